#!/usr/bin/env bash
# three.js 0.187.0 and three-subdivide 1.1.5 (npm): a grain as an icosahedron, its corners merged by mergeVertices, or refined by
# LoopSubdivision, at radii from 1 to 1e-6; volumes in units of the radius cubed.
#
# Guess: the same at every radius: 20 triangles and 2.536 after merging, 80 and 1.664 refined once, 320 and 1.501 refined twice.
# Seen: both compare rounded coordinates. mergeVertices, which rounds to 1e-4 by default, leaves a grain of 1e-4 seven corners
# and a third of its volume, and one of 3e-5 is a point. LoopSubdivision, which rounds to 1e-3 with no way to change it, has 20%
# too much volume at a radius of 0.02, 26% more and then 25% less at 0.01, and returns no triangles at 0.001. No word of either.
# Scale to a radius of 1 first.
#   merged at 1: 12 corners, 20 triangles, volume 2.536
#   merged at 0.001: 12 corners, 20 triangles, volume 2.536
#   merged at 0.0001: 7 corners, 20 triangles, volume 0.918
#   merged at 0.00003: 1 corners, 20 triangles, volume 0.000
#   refined at 1: once 80 triangles, volume 1.664, twice 320 triangles, volume 1.501
#   refined at 0.02: once 80 triangles, volume 2.002, twice 320 triangles, volume 1.624
#   refined at 0.01: once 80 triangles, volume 2.094, twice 320 triangles, volume 1.120
#   refined at 0.001: once 0 triangles, volume 0.000, twice 0 triangles, volume 0.000
set -euo pipefail
command -v npm >/dev/null || { echo "needs npm"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-save --ignore-scripts --legacy-peer-deps --prefix . three@0.187.0 three-subdivide@1.1.5 >/dev/null
cat > meshes.mjs <<'NODE'
import { IcosahedronGeometry, Vector3 } from 'three';
import { mergeVertices } from 'three/addons/utils/BufferGeometryUtils.js';
import { LoopSubdivision } from 'three-subdivide';

const grain = (r) => new IcosahedronGeometry(r, 0).deleteAttribute('uv').deleteAttribute('normal');
const look = ({ attributes: { position }, index }, r) => {
  const corner = (i) => new Vector3().fromBufferAttribute(position, index ? index.getX(i) : i);
  const count = (index ?? position).count;
  let sum = 0;
  for (let i = 0; i < count; i += 3) sum += corner(i).dot(corner(i + 1).cross(corner(i + 2))) / 6;
  return `${count / 3} triangles, volume ${(sum / r ** 3).toFixed(3)}`;
};
for (const r of [1, 1e-3, 1e-4, 3e-5]) {
  const merged = mergeVertices(grain(r));
  console.log(`merged at ${r}: ${merged.attributes.position.count} corners, ${look(merged, r)}`);
}
for (const r of [1, 0.02, 0.01, 0.001]) {
  const [once, twice] = [1, 2].map((steps) => look(LoopSubdivision.modify(grain(r), steps), r));
  console.log(`refined at ${r}: once ${once}, twice ${twice}`);
}
NODE
node meshes.mjs > seen 2> messages || { cat messages; exit 1; }
cat seen
diff seen - <<'SEEN'
merged at 1: 12 corners, 20 triangles, volume 2.536
merged at 0.001: 12 corners, 20 triangles, volume 2.536
merged at 0.0001: 7 corners, 20 triangles, volume 0.918
merged at 0.00003: 1 corners, 20 triangles, volume 0.000
refined at 1: once 80 triangles, volume 1.664, twice 320 triangles, volume 1.501
refined at 0.02: once 80 triangles, volume 2.002, twice 320 triangles, volume 1.624
refined at 0.01: once 80 triangles, volume 2.094, twice 320 triangles, volume 1.120
refined at 0.001: once 0 triangles, volume 0.000, twice 0 triangles, volume 0.000
SEEN
