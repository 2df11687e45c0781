#!/usr/bin/env bash
# mesh-mean-curvature 1.0.1 (npm, with mesh-laplacian 1.0.0): the mean curvature at each vertex of an icosphere of 642
# vertices and of an open tube, times the radius, as for the Laplace pressure of a drop.
#
# Guess: 1.0 for the sphere and 0.5 for the tube, or twice that where the sum of the two curvatures is meant, at each size.
# Seen: 4.0 and 2.0, four times the mean and twice the sum of the curvatures; 4.57 at the twelve vertices of five triangles.
# Triangles with an area below 1e-8 are skipped, whatever the size of the mesh: at a radius of 1e-3 values are anything from 0 to
# 28, and at 1e-4 all are 0. The rim of the tube has 20. Divide by four, and scale lengths to about 1.
#   sphere of radius 1, 642 vertices: mean 4.00, from 3.98 to 4.57
#   sphere of radius 0.01, 642 vertices: mean 4.00, from 3.98 to 4.57
#   sphere of radius 0.001, 642 vertices: mean 8.52, from 0.00 to 28.48
#   sphere of radius 0.0001, 642 vertices: mean 0.00, from 0.00 to 0.00
#   tube of radius 1: 2.00 in the middle, 20.47 at the rim
set -euo pipefail
command -v npm >/dev/null || { echo "needs npm"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-save --ignore-scripts --prefix . mesh-mean-curvature@1.0.1 mesh-laplacian@1.0.0 >/dev/null
cat > curvatures.cjs <<'NODE'
const curvatures = require('mesh-mean-curvature');

function icosphere(refinements) {
  const t = (1 + Math.sqrt(5)) / 2, length = Math.hypot(1, t);
  const points = [];
  for (const [k, l] of [[0, 1], [1, 2], [2, 0]])
    for (const a of [-1, 1]) for (const b of [-t, t]) {
      const p = [0, 0, 0];
      [p[k], p[l]] = [a / length, b / length];
      points.push(p);
    }
  const distance = (i, j) => Math.hypot(...points[i].map((x, k) => x - points[j][k]));
  let triangles = [];  // the shortest distances are edges
  for (let i = 0; i < 12; i++) for (let j = 0; j < i; j++) for (let k = 0; k < j; k++)
    if (Math.max(distance(i, j), distance(j, k), distance(k, i)) < 1.1) triangles.push([i, j, k]);
  for (; refinements > 0; refinements--) {
    const known = new Map();
    const middle = (i, j) => {
      const key = `${Math.min(i, j)} ${Math.max(i, j)}`;
      if (!known.has(key)) {
        const p = points[i].map((x, k) => x + points[j][k]), r = Math.hypot(...p);
        known.set(key, points.push(p.map((x) => x / r)) - 1);
      }
      return known.get(key);
    };
    triangles = triangles.flatMap(([i, j, k]) => {
      const [a, b, c] = [middle(i, j), middle(j, k), middle(k, i)];
      return [[i, a, c], [j, b, a], [k, c, b], [a, b, c]];
    });
  }
  return [triangles, points];
}

const [triangles, points] = icosphere(3);
for (const r of [1, 0.01, 1e-3, 1e-4]) {
  const values = curvatures(triangles, points.map((p) => p.map((x) => r * x))).map((h) => h * r);
  const mean = values.reduce((a, b) => a + b) / values.length;
  console.log(`sphere of radius ${r}, ${points.length} vertices: mean ${mean.toFixed(2)}, ` +
    `from ${Math.min(...values).toFixed(2)} to ${Math.max(...values).toFixed(2)}`);
}
const around = 32, rings = 33, tube = [[], []];
for (let ring = 0; ring < rings; ring++) for (let n = 0; n < around; n++) {
  const angle = (2 * Math.PI * n) / around;
  tube[1].push([Math.cos(angle), Math.sin(angle), (2 * Math.PI * ring) / around]);
  if (ring + 1 === rings) continue;
  const a = ring * around + n, b = ring * around + (n + 1) % around;
  tube[0].push([a, b, b + around], [a, b + around, a + around]);
}
const values = curvatures(...tube);
console.log(`tube of radius 1: ${values[16 * around].toFixed(2)} in the middle, ${values[0].toFixed(2)} at the rim`);
NODE
node curvatures.cjs > seen
cat seen
diff seen - <<'SEEN'
sphere of radius 1, 642 vertices: mean 4.00, from 3.98 to 4.57
sphere of radius 0.01, 642 vertices: mean 4.00, from 3.98 to 4.57
sphere of radius 0.001, 642 vertices: mean 8.52, from 0.00 to 28.48
sphere of radius 0.0001, 642 vertices: mean 0.00, from 0.00 to 0.00
tube of radius 1: 2.00 in the middle, 20.47 at the rim
SEEN
