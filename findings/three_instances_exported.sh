#!/usr/bin/env bash
# three.js 0.187.0 (npm: three): a packing of three grains drawn as one InstancedMesh, as many equal bodies are drawn, and a
# grain that is mirrored (scale -1, 1, 1), as a wall or a mirror plane has it, written by STLExporter, OBJExporter and
# PLYExporter and read again.
#
# Guess: three grains of volume 3.94, each in its place; a mirrored grain of volume 3.94; or a message.
# Seen: one grain is in the file, at the place where none of the three is, the origin of the mesh: the matrices of the
# instances are left out. The mirrored grain is inside out, with volume -3.94, in all three. No message. Make a Mesh of each
# instance before it is written, and turn the triangles of those whose matrix has a negative determinant.
#   STL: volume 3.94 for 11.82, x from -1 to 1; mirrored -3.94
#   OBJ: volume 3.94 for 11.82, x from -1 to 1; mirrored -3.94
#   PLY: volume 3.94 for 11.82, x from -1 to 1; mirrored -3.94
set -euo pipefail
command -v npm >/dev/null || { echo "needs npm"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-save --ignore-scripts --prefix . three@0.187.0 >/dev/null
cat > export.mjs <<'NODE'
import * as THREE from 'three';
import { OBJExporter } from 'three/examples/jsm/exporters/OBJExporter.js';
import { PLYExporter } from 'three/examples/jsm/exporters/PLYExporter.js';
import { STLExporter } from 'three/examples/jsm/exporters/STLExporter.js';
import { OBJLoader } from 'three/examples/jsm/loaders/OBJLoader.js';
import { PLYLoader } from 'three/examples/jsm/loaders/PLYLoader.js';
import { STLLoader } from 'three/examples/jsm/loaders/STLLoader.js';
globalThis.requestAnimationFrame ??= (call) => call();
function measure(geometry) {
  const { position } = geometry.attributes;
  const corner = (n) => new THREE.Vector3().fromBufferAttribute(position, geometry.index ? geometry.index.getX(n) : n);
  let volume = 0;
  for (let n = 0; n < (geometry.index ?? position).count; n += 3) {
    volume += corner(n).dot(corner(n + 1).cross(corner(n + 2))) / 6;
  }
  geometry.computeBoundingBox();
  return { volume: volume.toFixed(2), from: geometry.boundingBox.min.x.toFixed(0), to: geometry.boundingBox.max.x.toFixed(0) };
}
const formats = {
  STL: (scene) => new STLLoader().parse(new STLExporter().parse(scene)),
  OBJ: (scene) => new OBJLoader().parse(new OBJExporter().parse(scene)).children[0].geometry,
  PLY: (scene) => new PLYLoader().parse(new PLYExporter().parse(scene, () => {})),
};
const grain = new THREE.IcosahedronGeometry(1, 2);
const packing = new THREE.InstancedMesh(grain, new THREE.MeshBasicMaterial(), 3);
[5, 7, 9].forEach((x, n) => packing.setMatrixAt(n, new THREE.Matrix4().makeTranslation(x, 0, 0)));
const mirrored = new THREE.Mesh(grain, new THREE.MeshBasicMaterial());
mirrored.scale.set(-1, 1, 1);
for (const [name, write] of Object.entries(formats)) {
  const [all, turned] = [packing, mirrored].map((mesh) => {
    const scene = new THREE.Scene().add(mesh);
    scene.updateMatrixWorld(true);
    return measure(write(scene));
  });
  console.log(`${name}: volume ${all.volume} for ${(3 * measure(grain).volume).toFixed(2)}, x from ${all.from} to ${all.to}; `
    + `mirrored ${turned.volume}`);
}
NODE
node export.mjs > seen
cat seen
diff seen - <<'SEEN'
STL: volume 3.94 for 11.82, x from -1 to 1; mirrored -3.94
OBJ: volume 3.94 for 11.82, x from -1 to 1; mirrored -3.94
PLY: volume 3.94 for 11.82, x from -1 to 1; mirrored -3.94
SEEN
