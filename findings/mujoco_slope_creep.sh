#!/usr/bin/env bash
# MuJoCo 3.3.8 (npm: mujoco-js 0.0.7), in its units of metre and kilogram: a cube on a slope of 0.2 (11 degrees) with a
# friction of 1, for which it should stay up to 45 degrees; its velocity down the slope from 1 s to 11 s, by its size, the
# step, and the two shapes of friction cone.
#
# Guess: it stays, as static friction has it; or creeps by something tiny that a finer step makes smaller.
# Seen: it creeps for ever, at 1.02 mm/s with the default cone and half of that with the elliptic one, whatever its size,
# weight and the step: a cube of 1 mm moves by its own size every second, and no pile of grains has an angle of repose at
# which it is at rest.  `impratio` divides the velocity, by 10 for 10.
#   size 0.1, step 0.002, pyramidal, impratio 1: 1.015 mm/s
#   size 0.002, step 0.002, pyramidal, impratio 1: 1.015 mm/s
#   size 0.1, step 0.0002, pyramidal, impratio 1: 1.015 mm/s
#   size 0.1, step 0.002, elliptic, impratio 1: 0.508 mm/s
#   size 0.1, step 0.002, pyramidal, impratio 10: 0.103 mm/s
set -euo pipefail
command -v npm >/dev/null || { echo "needs npm"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-save --ignore-scripts --prefix . mujoco-js@0.0.7 >/dev/null
cat > creep.mjs <<'NODE'
import load from 'mujoco-js';
const mujoco = await load();
function velocity(size, step, cone, ratio) {
  mujoco.FS.writeFile('/cube.xml', `<mujoco><option timestep="${step}" cone="${cone}" impratio="${ratio}"
    gravity="${9.81 * Math.sin(0.2)} 0 ${-9.81 * Math.cos(0.2)}"/><worldbody>
    <geom type="plane" size="1 1 0.1" friction="1 0 0"/>
    <body pos="0 0 ${size / 2}"><freejoint/><geom type="box" size="${size / 2} ${size / 2} ${size / 2}" friction="1 0 0"/></body>
  </worldbody></mujoco>`);
  const model = mujoco.MjModel.loadFromXML('/cube.xml');
  const data = new mujoco.MjData(model);
  const run = (time) => { for (let n = 0; n < Math.round(time / step); ++n) mujoco.mj_step(model, data); };
  run(1);
  const start = data.qpos[0];
  run(10);
  return (data.qpos[0] - start) / 10;
}
for (const each of [[0.1, 0.002, 'pyramidal', 1], [0.002, 0.002, 'pyramidal', 1], [0.1, 0.0002, 'pyramidal', 1],
  [0.1, 0.002, 'elliptic', 1], [0.1, 0.002, 'pyramidal', 10]]) {
  console.log(`size ${each[0]}, step ${each[1]}, ${each[2]}, impratio ${each[3]}: ${(1000 * velocity(...each)).toFixed(3)} mm/s`);
}
NODE
timeout 600 node creep.mjs > seen 2> messages || { cat messages; exit 1; }
cat seen
diff seen - <<'SEEN'
size 0.1, step 0.002, pyramidal, impratio 1: 1.015 mm/s
size 0.002, step 0.002, pyramidal, impratio 1: 1.015 mm/s
size 0.1, step 0.0002, pyramidal, impratio 1: 1.015 mm/s
size 0.1, step 0.002, elliptic, impratio 1: 0.508 mm/s
size 0.1, step 0.002, pyramidal, impratio 10: 0.103 mm/s
SEEN
