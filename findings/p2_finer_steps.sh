#!/usr/bin/env bash
# p2-es 1.2.3 (npm), rigid bodies in two dimensions: a disc that falls on a plane with a given restitution, by the time step, and
# the inertia of a clump of two discs.
#
# Guess: the finer the step, the closer the rebound is to the restitution; the inertia of a clump is that of its parts by mass.
# Seen: the coarsest step is the best. At 1/60 s the disc comes back with 0.499 of its speed for 0.5, at 1/1000 with 0.214, and
# at 1/2000 it stays down, as it does with a restitution of 1: contacts are springs of stiffness 1e6, which give way where the
# step is finer. Where defaultContactMaterial.stiffness grows as one over the step squared, 0.499 stays. And a clump counts its
# whole mass for each of its parts: two discs side by side have twice their inertia (twenty twenty times).
#   restitution 0.5, steps 1/60, 1/240, 1/1000, 1/2000: 0.499 0.480 0.214 0.003; stiffness scaled: 0.499 0.499 0.499 0.499
#   restitution 1: 0.998 0.973 0.619 0.030
#   clump of two discs: inertia 3.000, true 1.500
set -euo pipefail
command -v npm >/dev/null || { echo "needs npm"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-save --ignore-scripts --prefix . p2-es@1.2.3 >/dev/null
cat > bounce.mjs <<'NODE'
import { Body, Circle, Plane, World } from 'p2-es';
const rebound = (step, restitution, stiffness) => { // greatest speed after the impact over the speed before it
  const world = new World({ gravity: [0, -10] });
  Object.assign(world.defaultContactMaterial, { restitution, friction: 0, stiffness });
  const [ground, disc] = [new Body({ mass: 0 }), new Body({ mass: 1, position: [0, 1.1], damping: 0 })];
  ground.addShape(new Plane());
  disc.addShape(new Circle({ radius: 0.1 }));
  world.addBody(ground);
  world.addBody(disc);
  let before = 0, after = 0;
  for (let i = 0; i < 1 / step; i++) {
    world.step(step);
    before = Math.max(before, -disc.velocity[1]);
    after = Math.max(after, disc.velocity[1]);
  }
  return (after / before).toFixed(3);
};
const steps = [60, 240, 1000, 2000];
const plain = (restitution) => steps.map((n) => rebound(1 / n, restitution, 1e6)).join(' ');
const scaled = steps.map((n) => rebound(1 / n, 0.5, 1e6 * (n / 60) ** 2)).join(' ');
console.log(`restitution 0.5, steps ${steps.map((n) => `1/${n}`).join(', ')}: ${plain(0.5)}; stiffness scaled: ${scaled}`);
console.log(`restitution 1: ${plain(1)}`);
const clump = new Body({ mass: 1 });
for (const x of [-1, 1]) clump.addShape(new Circle({ radius: 1 }), [x, 0]);
console.log(`clump of two discs: inertia ${clump.inertia.toFixed(3)}, true ${(1 / 2 + 1).toFixed(3)}`);
NODE
node bounce.mjs > seen
cat seen
diff seen - <<'SEEN'
restitution 0.5, steps 1/60, 1/240, 1/1000, 1/2000: 0.499 0.480 0.214 0.003; stiffness scaled: 0.499 0.499 0.499 0.499
restitution 1: 0.998 0.973 0.619 0.030
clump of two discs: inertia 3.000, true 1.500
SEEN
