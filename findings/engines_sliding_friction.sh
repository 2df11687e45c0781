#!/usr/bin/env bash
# Five engines for rigid bodies from npm, matter-js 0.20.0, cannon-es 0.20.0, p2-es 1.2.3, Planck 1.5.0 and Rapier
# (@dimforge/rapier2d-compat 0.21.0): a grain of mass 1 that does not turn slides over a plate at 40, with friction 0.5, pressed
# to it by its weight or by a force; what it loses of its velocity in steps of 1/60 or 1/600, over the load, is its friction.
#
# Guess: 0.5 everywhere, Coulomb's law, for any load and any step.
# Seen: in three of them the load does not matter. p2-es and cannon-es take friction times mass times gravity for the limit, so
# that what presses grains on each other counts for nothing, and without gravity p2-es puts 10 for it and cannon-es has no
# friction. In cannon-es that force is taken for a change of momentum in each step: 60 times too much at 1/60, 600 times at 1/600.
# In matter-js a grain loses 1.2 of its velocity in a step of 1/60 whatever the weight and the force are. Planck and Rapier are
# right. In a packing that is pressed together, or a pile, where lower grains carry upper ones, no contact has its friction.
#   Planck: 0.5 by weight 10, 0.5 by weight 10 and force 90, 0.5 by force 1, 0.5 by weight 10 at 1/600
#   Rapier: 0.5 by weight 10, 0.5 by weight 10 and force 90, 0.5 by force 1, 0.5 by weight 10 at 1/600
#   p2-es: 0.5 by weight 10, 0.05 by weight 10 and force 90, 5 by force 1, 0.5 by weight 10 at 1/600
#   cannon-es: 30 by weight 10, 3 by weight 10 and force 90, 0 by force 1, 300 by weight 10 at 1/600
#   matter-js: 7.2 by weight 10, 0.72 by weight 10 and force 90, 72 by force 1, 0.72 by weight 10 at 1/600
set -euo pipefail
command -v npm >/dev/null || { echo "needs npm"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-save --ignore-scripts --prefix . @dimforge/rapier2d-compat@0.21.0 planck@1.5.0 cannon-es@0.20.0 \
  p2-es@1.2.3 matter-js@0.20.0 >/dev/null
cat > slide.mjs <<'NODE'
import rapier from '@dimforge/rapier2d-compat';
import * as cannon from 'cannon-es';
import matter from 'matter-js';
import * as p2 from 'p2-es';
import * as planck from 'planck';

await rapier.init();
const friction = 0.5, start = 40;
// each returns what makes a step, and what tells the velocity along the plate
const engines = {
  Planck(gravity, force, dt) {
    const world = new planck.World({ gravity: { x: 0, y: -gravity } });
    world.createBody().createFixture(new planck.Edge({ x: -100, y: -0.5 }, { x: 100, y: -0.5 }), { friction });
    const grain = world.createBody({ type: 'dynamic', linearVelocity: { x: start, y: 0 }, fixedRotation: true });
    grain.createFixture(new planck.Circle(0.5), { density: 4 / Math.PI, friction });
    return [() => { grain.applyForceToCenter({ x: 0, y: -force }); world.step(dt); }, () => grain.getLinearVelocity().x];
  },
  Rapier(gravity, force, dt) {
    const world = new rapier.World({ x: 0, y: -gravity });
    world.timestep = dt;
    world.createCollider(rapier.ColliderDesc.cuboid(100, 1).setTranslation(0, -1.5).setFriction(friction));
    const grain = world.createRigidBody(rapier.RigidBodyDesc.dynamic().setLinvel(start, 0).lockRotations());
    world.createCollider(rapier.ColliderDesc.ball(0.5).setMass(1).setFriction(friction), grain);
    grain.addForce({ x: 0, y: -force }, true);
    return [() => world.step(), () => grain.linvel().x];
  },
  'p2-es'(gravity, force, dt) {
    const world = new p2.World({ gravity: [0, -gravity] });
    Object.assign(world.defaultContactMaterial, { friction });
    const plate = new p2.Body({ position: [0, -0.5] });
    plate.addShape(new p2.Plane());
    const grain = new p2.Body({ mass: 1, velocity: [start, 0], damping: 0, fixedRotation: true });
    grain.addShape(new p2.Circle({ radius: 0.5 }));
    world.addBody(plate);
    world.addBody(grain);
    return [() => { grain.applyForce([0, -force]); world.step(dt); }, () => grain.velocity[0]];
  },
  'cannon-es'(gravity, force, dt) {
    const world = new cannon.World({ gravity: new cannon.Vec3(0, 0, -gravity) });
    Object.assign(world.defaultContactMaterial, { restitution: 0, friction });
    world.addBody(new cannon.Body({ mass: 0, shape: new cannon.Plane(), position: new cannon.Vec3(0, 0, -0.5) }));
    const grain = new cannon.Body({ mass: 1, shape: new cannon.Sphere(0.5), linearDamping: 0, fixedRotation: true,
      velocity: new cannon.Vec3(start, 0, 0) });
    grain.updateMassProperties();
    world.addBody(grain);
    return [() => { grain.applyForce(new cannon.Vec3(0, 0, -force)); world.step(dt); }, () => grain.velocity.x];
  },
  'matter-js'(gravity, force, dt) { // in hundredths of the length; velocities are ways in a sixtieth of a second, times are in ms
    const engine = matter.Engine.create({ gravity: { x: 0, y: 1, scale: gravity * 1e-4 } });
    const surface = { restitution: 0, friction, frictionStatic: friction, frictionAir: 0 };
    const plate = matter.Bodies.rectangle(0, 150, 100000, 200, { isStatic: true, ...surface });
    const grain = matter.Bodies.circle(0, 0, 50, { inertia: Infinity, ...surface });
    matter.Composite.add(engine.world, [plate, grain]);
    matter.Body.setVelocity(grain, { x: start * 100 / 60, y: 0 });
    const step = () => { grain.force.y += grain.mass * force * 1e-4; matter.Engine.update(engine, dt * 1000); };
    return [step, () => grain.velocity.x * 0.6];
  },
};
const cases = [['weight 10', 10, 0, 1 / 60], ['weight 10 and force 90', 10, 90, 1 / 60], ['force 1', 0, 1, 1 / 60],
  ['weight 10 at 1/600', 10, 0, 1 / 600]];
for (const [name, make] of Object.entries(engines)) {
  const words = cases.map(([what, gravity, force, dt]) => {
    const [step, velocity] = make(gravity, force, dt);
    const velocities = [1, 2, 3, 4, 5].map(() => (step(), velocity()));
    return `${Number(((velocities[1] - velocities[4]) / (3 * dt) / (gravity + force)).toPrecision(2))} by ${what}`;
  });
  console.log(`${name}: ${words.join(', ')}`);
}
NODE
node slide.mjs > seen 2> messages || { cat messages; exit 1; }
cat seen
diff seen - <<'SEEN'
Planck: 0.5 by weight 10, 0.5 by weight 10 and force 90, 0.5 by force 1, 0.5 by weight 10 at 1/600
Rapier: 0.5 by weight 10, 0.5 by weight 10 and force 90, 0.5 by force 1, 0.5 by weight 10 at 1/600
p2-es: 0.5 by weight 10, 0.05 by weight 10 and force 90, 5 by force 1, 0.5 by weight 10 at 1/600
cannon-es: 30 by weight 10, 3 by weight 10 and force 90, 0 by force 1, 300 by weight 10 at 1/600
matter-js: 7.2 by weight 10, 0.72 by weight 10 and force 90, 72 by force 1, 0.72 by weight 10 at 1/600
SEEN
