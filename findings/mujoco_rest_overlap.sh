#!/usr/bin/env bash
# MuJoCo 3.3.8 (npm: mujoco-js 0.0.7), in its units of metre and kilogram: a ball on a plane at gravity 9.81, at rest after 5 s of
# steps of 2 ms and of 0.2 ms, with the default contact, by its radius and its density.
#
# Guess: the heavier and the stiffer loaded, the deeper: an overlap of next to nothing for small grains.
# Seen: the overlap is 0.367 mm for each, be it a grain or a boulder, light or heavy, and at any step: a contact is given an acceleration
# that depends on the overlap in metres, not a force, and its strength goes up within 1 mm. A ball of radius 1 mm is sunk in by
# a third of it, one of 0.4 mm by nine tenths. Smaller ones, 0.1 mm, are an error, as their mass is. Set solref and
# solimp by the size of the grains, or take another unit of length.
#   version 3.3.8
#   radius 1, density 1000, step 0.002: overlap 0.367 mm, 0.0004 of the radius
#   radius 0.1, density 1000, step 0.002: overlap 0.367 mm, 0.0037 of the radius
#   radius 0.01, density 1000, step 0.002: overlap 0.367 mm, 0.0367 of the radius
#   radius 0.001, density 1000, step 0.002: overlap 0.367 mm, 0.3672 of the radius
#   radius 0.001, density 10000, step 0.002: overlap 0.367 mm, 0.3672 of the radius
#   radius 0.001, density 1000, step 0.0002: overlap 0.367 mm, 0.3672 of the radius
#   radius 0.0004, density 10000, step 0.002: overlap 0.367 mm, 0.9180 of the radius
set -euo pipefail
command -v npm >/dev/null || { echo "needs npm"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-save --ignore-scripts --prefix . mujoco-js@0.0.7 >/dev/null
cat > rest.mjs <<'NODE'
import load from 'mujoco-js';
const mujoco = await load();
function overlap(radius, density, step) {
  mujoco.FS.writeFile('/ball.xml', `<mujoco><option timestep="${step}" gravity="0 0 -9.81"/><worldbody>
    <geom type="plane" size="1 1 0.1"/>
    <body pos="0 0 ${radius}"><freejoint/><geom type="sphere" size="${radius}" density="${density}"/></body>
  </worldbody></mujoco>`);
  const model = mujoco.MjModel.loadFromXML('/ball.xml');
  const data = new mujoco.MjData(model);
  for (let n = 0; n < Math.round(5 / step); ++n) mujoco.mj_step(model, data);
  return radius - data.qpos[2];
}
console.log(`version ${mujoco.mj_versionString()}`);
for (const [radius, density, step] of [[1, 1000, 0.002], [0.1, 1000, 0.002], [0.01, 1000, 0.002], [0.001, 1000, 0.002],
  [0.001, 10000, 0.002], [0.001, 1000, 0.0002], [0.0004, 10000, 0.002]]) {
  const depth = overlap(radius, density, step);
  console.log(`radius ${radius}, density ${density}, step ${step}: overlap ${(1000 * depth).toFixed(3)} mm, `
    + `${(depth / radius).toFixed(4)} of the radius`);
}
NODE
timeout 120 node rest.mjs > seen 2> messages || { cat messages; exit 1; }
cat seen
diff seen - <<'SEEN'
version 3.3.8
radius 1, density 1000, step 0.002: overlap 0.367 mm, 0.0004 of the radius
radius 0.1, density 1000, step 0.002: overlap 0.367 mm, 0.0037 of the radius
radius 0.01, density 1000, step 0.002: overlap 0.367 mm, 0.0367 of the radius
radius 0.001, density 1000, step 0.002: overlap 0.367 mm, 0.3672 of the radius
radius 0.001, density 10000, step 0.002: overlap 0.367 mm, 0.3672 of the radius
radius 0.001, density 1000, step 0.0002: overlap 0.367 mm, 0.3672 of the radius
radius 0.0004, density 10000, step 0.002: overlap 0.367 mm, 0.9180 of the radius
SEEN
