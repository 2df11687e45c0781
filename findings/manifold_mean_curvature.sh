#!/usr/bin/env bash
# Manifold 3.5.4 (npm: manifold-3d), calculateCurvature: the Gaussian and the mean curvature of spheres (medians over the
# vertices, times the radius squared and the radius) and at the ends of the axes of an ellipsoid of 3 by 2 by 1.
#
# Guess: a sphere has 1 and 1; the ellipsoid has 2.25 and 1.875 at the end of its longest axis, 0.444 and 1.111, 0.028 and
# 0.181 at the others.
# Seen: the Gaussian curvature is right, and the mean curvature is twice that: it is the sum of both principal curvatures, not
# their mean, though it goes by that name. A Laplace pressure of 2 gamma H comes out twice as large as it is, a bending energy
# of 2 kappa H² four times.
#   sphere of radius 1: 1.00 2.00
#   sphere of radius 0.001: 1.00 2.00
#   ellipsoid, axis of 3: 2.25 3.75
#   ellipsoid, axis of 2: 0.44 2.22
#   ellipsoid, axis of 1: 0.03 0.36
set -euo pipefail
command -v npm >/dev/null || { echo "needs npm"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-save --ignore-scripts --prefix . manifold-3d@3.5.4 >/dev/null
cat > curve.mjs <<'NODE'
import load from 'manifold-3d';
const library = await load();
library.setup();
const { Manifold } = library;
function vertices(body) {
  const mesh = body.calculateCurvature(0, 1).getMesh();
  const row = (v) => [...mesh.vertProperties.slice(v * mesh.numProp, (v + 1) * mesh.numProp)];
  return Array.from({ length: mesh.numVert }, (_, v) => row(v));
}
const median = (list) => list.sort((a, b) => a - b)[list.length >> 1].toFixed(2);
for (const radius of [1, 0.001]) {
  const all = vertices(Manifold.sphere(radius, 128));
  const [gaussian, mean] = [all.map((v) => v[3] * radius ** 2), all.map((v) => v[4] * radius)];
  console.log(`sphere of radius ${radius}: ${median(gaussian)} ${median(mean)}`);
}
const all = vertices(Manifold.sphere(1, 256).scale([3, 2, 1]));
for (const axis of [0, 1, 2]) {
  const end = all.reduce((a, b) => (b[axis] > a[axis] ? b : a));
  console.log(`ellipsoid, axis of ${3 - axis}: ${end[3].toFixed(2)} ${end[4].toFixed(2)}`);
}
NODE
node curve.mjs > seen
cat seen
diff seen - <<'SEEN'
sphere of radius 1: 1.00 2.00
sphere of radius 0.001: 1.00 2.00
ellipsoid, axis of 3: 2.25 3.75
ellipsoid, axis of 2: 0.44 2.22
ellipsoid, axis of 1: 0.03 0.36
SEEN
