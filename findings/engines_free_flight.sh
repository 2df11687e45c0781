#!/usr/bin/env bash
# Seven engines for rigid bodies: Bullet 3.24 (Debian 12: libbullet-dev 3.24+dfsg-2, compiled by g++) and from npm Jolt
# (jolt-physics 1.1.0), Rapier (@dimforge/rapier2d-compat 0.21.0), Planck 1.5.0, cannon-es 0.20.0, p2-es 1.2.3 and matter-js 0.20.0: a
# lone grain of radius 0.5 flies without gravity, 600 steps of 1/60, as the grains of a granular gas do.
#
# Guess: it goes on at its velocity, so that the way is 10 v.
# Seen: in none of them at every velocity. Bullet, Rapier, Jolt and Planck put a body to sleep that has been slow for a while though
# nothing touches it, which stops it for good: in Bullet below 0.8 after two seconds, in Rapier somewhere below 0.3. matter-js,
# p2-es, Jolt and cannon-es have friction of the air by default: 0.01 a step, 0.1, 0.05 and 0.01 a second. Bullet is exact at 1,
# as a test would have it, and a gas that cools freezes. Turn off both (DISABLE_DEACTIVATION, setCanSleep, allowSleep, frictionAir,
# linearDamping, mLinearDamping ...).
#   Bullet: 1.00 at 1, 0.20 at 0.5, 0.20 at 0.1, 0.20 at 0.01
#   Jolt: 0.79 at 1, 0.79 at 0.5, 0.79 at 0.1, 0.05 at 0.01
#   Rapier: 1.00 at 1, 1.00 at 0.5, 0.11 at 0.1, 0.05 at 0.01
#   Planck: 1.00 at 1, 1.00 at 0.5, 1.00 at 0.1, 0.05 at 0.01
#   cannon-es: 0.95 at 1, 0.95 at 0.5, 0.95 at 0.1, 0.95 at 0.01
#   p2-es: 0.62 at 1, 0.62 at 0.5, 0.62 at 0.1, 0.62 at 0.01
#   matter-js: 0.16 at 1, 0.16 at 0.5, 0.16 at 0.1, 0.16 at 0.01
set -euo pipefail
want=3.24+dfsg-2
version=$(dpkg-query -W -f='${Version}' libbullet-dev 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs libbullet-dev $want, found '${version:-none}'"; exit 77; }
for tool in g++ npm; do command -v $tool >/dev/null || { echo "needs $tool"; exit 77; }; done
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-save --ignore-scripts --prefix . jolt-physics@1.1.0 @dimforge/rapier2d-compat@0.21.0 planck@1.5.0 \
  cannon-es@0.20.0 p2-es@1.2.3 matter-js@0.20.0 >/dev/null
cat > bullet.cpp <<'CPP'
#include <btBulletDynamicsCommon.h>

#include <cstdio>

double way(double velocity) {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase pairs;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld world(&dispatcher, &pairs, &solver, &configuration);
    world.setGravity(btVector3(0, 0, 0));
    btSphereShape sphere(0.5);
    btVector3 inertia;
    sphere.calculateLocalInertia(1, inertia);
    btDefaultMotionState start;
    btRigidBody grain(btRigidBody::btRigidBodyConstructionInfo(1, &start, &sphere, inertia));
    grain.setLinearVelocity(btVector3(velocity, 0, 0));
    world.addRigidBody(&grain);
    for (int step = 0; step < 600; ++step) world.stepSimulation(1.0 / 60, 0, 1.0 / 60);
    world.removeRigidBody(&grain);
    return grain.getWorldTransform().getOrigin().x() / (10 * velocity);
}

int main() { std::printf("Bullet: %.2f at 1, %.2f at 0.5, %.2f at 0.1, %.2f at 0.01\n", way(1), way(0.5), way(0.1), way(0.01)); }
CPP
g++ -std=c++17 -I/usr/include/bullet -o bullet bullet.cpp -lBulletDynamics -lBulletCollision -lLinearMath
cat > fly.mjs <<'NODE'
import rapier from '@dimforge/rapier2d-compat';
import * as cannon from 'cannon-es';
import load_jolt from 'jolt-physics/wasm-compat';
import matter from 'matter-js';
import * as p2 from 'p2-es';
import * as planck from 'planck';

const jolt = await load_jolt();
await rapier.init();
const repeat = (step) => { for (let n = 0; n < 600; ++n) step(); };

const engines = {
  Jolt(velocity) {
    const settings = new jolt.JoltSettings();
    const layers = new jolt.BroadPhaseLayerInterfaceTable(1, 1);
    layers.MapObjectToBroadPhaseLayer(0, new jolt.BroadPhaseLayer(0));
    settings.mBroadPhaseLayerInterface = layers;
    settings.mObjectLayerPairFilter = new jolt.ObjectLayerPairFilterTable(1);
    settings.mObjectVsBroadPhaseLayerFilter = new jolt.ObjectVsBroadPhaseLayerFilterTable(layers, 1, settings.mObjectLayerPairFilter, 1);
    const world = new jolt.JoltInterface(settings);
    world.GetPhysicsSystem().SetGravity(new jolt.Vec3(0, 0, 0));
    const bodies = world.GetPhysicsSystem().GetBodyInterface();
    const body = bodies.CreateBody(new jolt.BodyCreationSettings(new jolt.SphereShape(0.5), new jolt.RVec3(0, 0, 0),
      jolt.Quat.prototype.sIdentity(), jolt.EMotionType_Dynamic, 0));
    bodies.AddBody(body.GetID(), jolt.EActivation_Activate);
    body.SetLinearVelocity(new jolt.Vec3(velocity, 0, 0));
    repeat(() => world.Step(1 / 60, 1));
    return body.GetPosition().GetX();
  },
  Rapier(velocity) {
    const world = new rapier.World({ x: 0, y: 0 });
    const body = world.createRigidBody(rapier.RigidBodyDesc.dynamic().setLinvel(velocity, 0));
    world.createCollider(rapier.ColliderDesc.ball(0.5), body);
    repeat(() => world.step());
    return body.translation().x;
  },
  Planck(velocity) {
    const world = new planck.World({ gravity: { x: 0, y: 0 } });
    const body = world.createBody({ type: 'dynamic', linearVelocity: { x: velocity, y: 0 } });
    body.createFixture(new planck.Circle(0.5), { density: 1 });
    repeat(() => world.step(1 / 60));
    return body.getPosition().x;
  },
  'cannon-es'(velocity) {
    const world = new cannon.World();
    const body = new cannon.Body({ mass: 1, shape: new cannon.Sphere(0.5), velocity: new cannon.Vec3(velocity, 0, 0) });
    world.addBody(body);
    repeat(() => world.step(1 / 60));
    return body.position.x;
  },
  'p2-es'(velocity) {
    const world = new p2.World({ gravity: [0, 0] });
    const body = new p2.Body({ mass: 1, velocity: [velocity, 0] });
    body.addShape(new p2.Circle({ radius: 0.5 }));
    world.addBody(body);
    repeat(() => world.step(1 / 60));
    return body.position[0];
  },
  'matter-js'(velocity) { // velocities are ways in a sixtieth of a second
    const engine = matter.Engine.create({ gravity: { x: 0, y: 0 } });
    const body = matter.Bodies.circle(0, 0, 0.5);
    matter.Composite.add(engine.world, body);
    matter.Body.setVelocity(body, { x: velocity / 60, y: 0 });
    repeat(() => matter.Engine.update(engine, 1000 / 60));
    return body.position.x;
  },
};
for (const [name, fly] of Object.entries(engines)) {
  const ways = [1, 0.5, 0.1, 0.01].map((velocity) => `${(fly(velocity) / (10 * velocity)).toFixed(2)} at ${velocity}`);
  console.log(`${name}: ${ways.join(', ')}`);
}
NODE
{ ./bullet; node fly.mjs 2> messages; } > seen || { cat seen messages; exit 1; }
cat seen
diff seen - <<'SEEN'
Bullet: 1.00 at 1, 0.20 at 0.5, 0.20 at 0.1, 0.20 at 0.01
Jolt: 0.79 at 1, 0.79 at 0.5, 0.79 at 0.1, 0.05 at 0.01
Rapier: 1.00 at 1, 1.00 at 0.5, 0.11 at 0.1, 0.05 at 0.01
Planck: 1.00 at 1, 1.00 at 0.5, 1.00 at 0.1, 0.05 at 0.01
cannon-es: 0.95 at 1, 0.95 at 0.5, 0.95 at 0.1, 0.95 at 0.01
p2-es: 0.62 at 1, 0.62 at 0.5, 0.62 at 0.1, 0.62 at 0.01
matter-js: 0.16 at 1, 0.16 at 0.5, 0.16 at 0.1, 0.16 at 0.01
SEEN
