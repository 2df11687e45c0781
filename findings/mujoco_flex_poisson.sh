#!/usr/bin/env bash
# MuJoCo 3.3.8 (mujoco-js 0.0.7 of npm): a soft cube, <flexcomp dim="3"> of 48 tetrahedra with <elasticity young="${given}"
# poisson="..."/>, put into small uniform strains and shears of +-0.001; moduli by the work of the passive forces on its vertices.
#
# Guess: a shear modulus of E / (2 (1 + ratio)), a bulk modulus of E / (3 (1 - 2 ratio)), so that E and the ratio are as given.
# Seen: the shear modulus is right. The first Lame parameter counts twice, so that the bulk modulus is 160 for 100 at a ratio of
# 0.25, Young's modulus 160 for 150 and the ratio 0.333; at 0.45 the bulk modulus is 966 for 500. With a ratio of 0 all is as
# given. The same for finer cubes and for small ones. A cube of E and ratio n is had by a ratio of m = n / (2 - 2 n) and a modulus
# of E (1 + m) / (1 + n), as in the last line.
#   E 150, ratio 0, side 1, 3^3 vertices: shear 75.0, bulk 50.0 for 50.0, E 150.0, ratio 0.000
#   E 150, ratio 0.1, side 1, 3^3 vertices: shear 68.2, bulk 79.5 for 62.5, E 159.1, ratio 0.167
#   E 150, ratio 0.25, side 1, 3^3 vertices: shear 60.0, bulk 160.0 for 100.0, E 160.0, ratio 0.333
#   E 150, ratio 0.4, side 1, 3^3 vertices: shear 53.6, bulk 464.3 for 250.0, E 154.8, ratio 0.444
#   E 150, ratio 0.45, side 1, 3^3 vertices: shear 51.7, bulk 965.5 for 500.0, E 152.5, ratio 0.474
#   E 150, ratio 0.25, side 1, 2^3 vertices: shear 60.0, bulk 160.0 for 100.0, E 160.0, ratio 0.333
#   E 150, ratio 0.25, side 0.01, 3^3 vertices: shear 60.0, bulk 160.0 for 100.0, E 160.0, ratio 0.333
#   E 140, ratio 0.1667, side 1, 3^3 vertices: shear 60.0, bulk 100.0 for 70.0, E 150.0, ratio 0.250
set -euo pipefail
command -v npm >/dev/null || { echo "needs npm"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-save --ignore-scripts --prefix . mujoco-js@0.0.7 >/dev/null
cat > moduli.mjs <<'NODE'
import load from 'mujoco-js';
const mujoco = await load();
function show(count, size, ratio, given = 150) {
  const between = size / (count - 1);
  mujoco.FS.writeFile('/cube.xml', `<mujoco><option gravity="0 0 0"/><worldbody>
    <flexcomp name="cube" type="grid" dim="3" count="${count} ${count} ${count}" spacing="${between} ${between} ${between}"
      mass="1" radius="${size / 1e4}">
      <elasticity young="${given}" poisson="${ratio}"/><contact selfcollide="none"/>
    </flexcomp></worldbody></mujoco>`);
  const model = mujoco.MjModel.loadFromXML('/cube.xml');
  const data = new mujoco.MjData(model);
  mujoco.mj_forward(model, data);
  const rest = Array.from(data.flexvert_xpos);
  const axes = [0, 1, 2];
  const stress = (gradient, row, column) => {
    for (let n = 0; n < rest.length; n += 3) {
      for (const i of axes) data.qpos[n + i] = axes.reduce((sum, j) => sum + gradient[i][j] * rest[n + j], -rest[n + i]);
    }
    mujoco.mj_forward(model, data);
    let work = 0;
    for (let n = 0; n < rest.length; n += 3) work -= data.qfrc_passive[n + row] * rest[n + column];
    return work / size ** 3;
  };
  const h = 1e-3;
  const slope = (row, column, strained) => (stress(strained(h), row, column) - stress(strained(-h), row, column)) / (2 * h);
  const longer = (e) => [[1 + e, 0, 0], [0, 1, 0], [0, 0, 1]];
  const along = slope(0, 0, longer), across = slope(1, 1, longer);
  const shear = slope(0, 1, (e) => [[1, e / 2, 0], [e / 2, 1, 0], [0, 0, 1]]);
  const bulk = (along + 2 * across) / 3, young = 9 * bulk * shear / (3 * bulk + shear);
  console.log(`E ${given}, ratio ${+ratio.toFixed(4)}, side ${size}, ${count}^3 vertices: shear ${shear.toFixed(1)}, ` +
    `bulk ${bulk.toFixed(1)} for ${(given / 3 / (1 - 2 * ratio)).toFixed(1)}, E ${young.toFixed(1)}, ` +
    `ratio ${(across / (along + across)).toFixed(3)}`);
}
for (const ratio of [0, 0.1, 0.25, 0.4, 0.45]) show(3, 1, ratio);
show(2, 1, 0.25);
show(3, 0.01, 0.25);
show(3, 1, 1 / 6, 140);
NODE
timeout 300 node moduli.mjs > seen 2> messages || { cat messages; exit 1; }
cat seen
diff seen - <<'SEEN'
E 150, ratio 0, side 1, 3^3 vertices: shear 75.0, bulk 50.0 for 50.0, E 150.0, ratio 0.000
E 150, ratio 0.1, side 1, 3^3 vertices: shear 68.2, bulk 79.5 for 62.5, E 159.1, ratio 0.167
E 150, ratio 0.25, side 1, 3^3 vertices: shear 60.0, bulk 160.0 for 100.0, E 160.0, ratio 0.333
E 150, ratio 0.4, side 1, 3^3 vertices: shear 53.6, bulk 464.3 for 250.0, E 154.8, ratio 0.444
E 150, ratio 0.45, side 1, 3^3 vertices: shear 51.7, bulk 965.5 for 500.0, E 152.5, ratio 0.474
E 150, ratio 0.25, side 1, 2^3 vertices: shear 60.0, bulk 160.0 for 100.0, E 160.0, ratio 0.333
E 150, ratio 0.25, side 0.01, 3^3 vertices: shear 60.0, bulk 160.0 for 100.0, E 160.0, ratio 0.333
E 140, ratio 0.1667, side 1, 3^3 vertices: shear 60.0, bulk 100.0 for 70.0, E 150.0, ratio 0.250
SEEN
