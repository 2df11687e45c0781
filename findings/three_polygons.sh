#!/usr/bin/env bash
# three.js 0.170.0 (npm: three): PLYLoader, OBJLoader and XYZLoader reading polygons and points, as shown in a page of a
# simulation.
#
# Guess: a polygon comes with all its area, whatever its number of corners, or it is an error; the XYZ files of chemists are
# read.
# Seen: PLYLoader takes faces of three and four corners; a pentagon is dropped without a word and the mesh has no face. One with
# four corners and a dent is cut across the dent: 3 for an area of 1. OBJLoader makes a fan from the first corner: right for
# these two if the dent is seen from there, 3.8 for 2.2 if not. XYZLoader drops every row that begins with an element: no
# points, while bare numbers are read. Write triangles, and points as PLY.
#   pentagon of area 1.25: PLY 0 triangles of area 0, OBJ 3 triangles of area 1.25
#   dented quadrangle of area 1: PLY 2 triangles of area 3, OBJ 2 triangles of area 1
#   dented pentagon of area 2.2: PLY 0 triangles of area 0, OBJ 3 triangles of area 3.8
#   XYZ rows "C 1 2 3": 0 points, "1 2 3": 2 points, "1 2 3 0.5": 0 points
set -euo pipefail
command -v npm >/dev/null || { echo "needs npm"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-save --ignore-scripts --prefix . three@0.170.0 >/dev/null
cat > read.mjs <<'NODE'
import { OBJLoader } from 'three/examples/jsm/loaders/OBJLoader.js';
import { PLYLoader } from 'three/examples/jsm/loaders/PLYLoader.js';
import { XYZLoader } from 'three/examples/jsm/loaders/XYZLoader.js';
const triangles = (geometry, isIndexed) => {
  const at = geometry.attributes.position;
  const indices = geometry.index ? Array.from(geometry.index.array) : isIndexed ? [] : [...Array(at.count).keys()];
  let area = 0;
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = indices.slice(i, i + 3);
    const [x, y] = [(i) => at.getX(i) - at.getX(a), (i) => at.getY(i) - at.getY(a)];
    area += Math.abs(x(b) * y(c) - x(c) * y(b)) / 2;
  }
  return `${indices.length / 3} triangles of area ${Number(area.toFixed(3))}`;
};
for (const [name, corners] of [['pentagon of area 1.25', [[0, 0], [1, 0], [1.5, 0.5], [1, 1], [0, 1]]],
                               ['dented quadrangle of area 1', [[0, 0], [2, 0], [0.5, 0.5], [0, 2]]],
                               ['dented pentagon of area 2.2', [[0, 0], [2, 0], [2, 2], [1, 0.2], [0, 2]]]]) {
  const n = corners.length;
  const rows = corners.map(([x, y]) => `${x} ${y} 0`);
  const ply = new PLYLoader().parse(['ply', 'format ascii 1.0', `element vertex ${n}`, 'property double x', 'property double y',
    'property double z', 'element face 1', 'property list uchar int vertex_indices', 'end_header', ...rows,
    `${n} ${corners.map((_, i) => i).join(' ')}`, ''].join('\n'));
  const face = `f ${corners.map((_, i) => i + 1).join(' ')}`;
  const obj = new OBJLoader().parse([...rows.map((row) => `v ${row}`), face, ''].join('\n'));
  console.log(`${name}: PLY ${triangles(ply, true)}, OBJ ${triangles(obj.children[0].geometry, false)}`);
}
const points = (row) => new XYZLoader().parse(`2\n\n${row}\n${row}\n`).attributes.position.count;
console.log('XYZ rows ' + ['C 1 2 3', '1 2 3', '1 2 3 0.5'].map((row) => `"${row}": ${points(row)} points`).join(', '));
NODE
node read.mjs > seen 2>messages
cat seen
diff seen - <<'SEEN'
pentagon of area 1.25: PLY 0 triangles of area 0, OBJ 3 triangles of area 1.25
dented quadrangle of area 1: PLY 2 triangles of area 3, OBJ 2 triangles of area 1
dented pentagon of area 2.2: PLY 0 triangles of area 0, OBJ 3 triangles of area 3.8
XYZ rows "C 1 2 3": 0 points, "1 2 3": 2 points, "1 2 3 0.5": 0 points
SEEN
