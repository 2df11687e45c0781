#!/usr/bin/env bash
# Box2D 2.4.1 (Debian 12: libbox2d-dev 2.4.1-3, compiled by g++) and from npm Planck 1.5.0, Jolt (jolt-physics 1.1.0), cannon-es 0.20.0,
# matter-js 0.20.0, p2-es 1.2.3 and Rapier (@dimforge/rapier2d-compat 0.21.0): two equal grains of radius 0.5 and restitution 1,
# without friction, gravity and damping, meet head-on at velocities v and -v; steps of 1/60.
#
# Guess: both leave at v, at any v, perhaps less one step's worth of error.
# Seen: Box2D, Planck and Jolt have no restitution where the grains approach at less than 1, so that both stop dead at v = 0.4 and
# are elastic at v = 0.6. In matter-js the threshold is 2 lengths a step: grains of this size never bounce, and part at a seventh
# of v. In cannon-es they leave at 0.88 to 1.12, by where in the step they meet. p2-es and Rapier are exact. So a granular gas
# does not cool in one unit of length, and collapses in another. b2_velocityThreshold is fixed when Box2D is compiled,
# mMinVelocityForRestitution, Settings.velocityThreshold and Resolver._restingThresh can be set.
#   Box2D: 1.00, 1.00 at 10; 1.00, 1.00 at 0.6; 0.00, 0.00 at 0.4; 0.00, 0.00 at 0.1
#   Planck: 1.00, 1.00 at 10; 1.00, 1.00 at 0.6; 0.00, 0.00 at 0.4; 0.00, 0.00 at 0.1
#   Jolt: 1.00, 1.00 at 10; 1.00, 1.00 at 0.6; 0.00, 0.00 at 0.4; 0.00, 0.00 at 0.1
#   matter-js: 0.15, 0.15 at 10; 0.15, 0.15 at 0.6; 0.15, 0.15 at 0.4; 0.15, 0.15 at 0.1
#   cannon-es: 1.12, 0.88 at 10; 1.12, 0.88 at 0.6; 1.12, 0.88 at 0.4; 1.12, 0.88 at 0.1
#   p2-es: 1.00, 1.00 at 10; 1.00, 1.00 at 0.6; 1.00, 1.00 at 0.4; 1.00, 1.00 at 0.1
#   Rapier: 1.00, 1.00 at 10; 1.00, 1.00 at 0.6; 1.00, 1.00 at 0.4; 1.00, 1.00 at 0.1
set -euo pipefail
want=2.4.1-3
version=$(dpkg-query -W -f='${Version}' libbox2d-dev 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs libbox2d-dev $want, found '${version:-none}'"; exit 77; }
for tool in g++ npm; do command -v $tool >/dev/null || { echo "needs $tool"; exit 77; }; done
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-save --ignore-scripts --prefix . jolt-physics@1.1.0 @dimforge/rapier2d-compat@0.21.0 planck@1.5.0 \
  cannon-es@0.20.0 p2-es@1.2.3 matter-js@0.20.0 >/dev/null
cat > box2d.cpp <<'CPP'
#include <box2d/box2d.h>

#include <cstdio>
#include <initializer_list>

double leaves(double velocity, double part_of_step) {
    b2World world(b2Vec2(0, 0));
    b2Body* right = nullptr;
    for (int side : {-1, 1}) {
        b2BodyDef body;
        body.type = b2_dynamicBody;
        body.position.Set(side * (0.5 + velocity / 4 + velocity / 60 * part_of_step), 0);
        body.linearVelocity.Set(-side * velocity, 0);
        right = world.CreateBody(&body);
        b2CircleShape disc;
        disc.m_radius = 0.5;
        b2FixtureDef fixture;
        fixture.shape = &disc;
        fixture.density = fixture.restitution = 1;
        fixture.friction = 0;
        right->CreateFixture(&fixture);
    }
    for (int step = 0; step < 90; ++step) world.Step(1.0 / 60, 8, 3);
    return right->GetLinearVelocity().x / velocity;
}

int main() {
    std::printf("Box2D:");
    const char* between = " ";
    for (double velocity : {10.0, 0.6, 0.4, 0.1}) {
        std::printf("%s%.2f, %.2f at %g", between, leaves(velocity, 0.1), leaves(velocity, 0.9), velocity);
        between = "; ";
    }
    std::printf("\n");
}
CPP
g++ -std=c++17 -o box2d box2d.cpp -lbox2d
cat > meet.mjs <<'NODE'
import rapier from '@dimforge/rapier2d-compat';
import * as cannon from 'cannon-es';
import load_jolt from 'jolt-physics/wasm-compat';
import matter from 'matter-js';
import * as p2 from 'p2-es';
import * as planck from 'planck';

const jolt = await load_jolt();
await rapier.init();
// grain(side, x, velocity) is called for both grains, step() 90 times
function both(velocity, part_of_step, grain, step) {
  const [, right] = [-1, 1].map((side) => grain(side * (0.5 + velocity / 4 + (velocity / 60) * part_of_step), -side * velocity));
  for (let n = 0; n < 90; ++n) step();
  return right;
}

const engines = {
  Planck(velocity, part) {
    const world = new planck.World({ gravity: { x: 0, y: 0 } });
    return both(velocity, part, (x, v) => {
      const body = world.createBody({ type: 'dynamic', position: { x, y: 0 }, linearVelocity: { x: v, y: 0 } });
      body.createFixture(new planck.Circle(0.5), { density: 1, restitution: 1, friction: 0 });
      return body;
    }, () => world.step(1 / 60)).getLinearVelocity().x;
  },
  Jolt(velocity, part) {
    const settings = new jolt.JoltSettings();
    const layers = new jolt.BroadPhaseLayerInterfaceTable(1, 1);
    layers.MapObjectToBroadPhaseLayer(0, new jolt.BroadPhaseLayer(0));
    const pairs = new jolt.ObjectLayerPairFilterTable(1);
    pairs.EnableCollision(0, 0);
    settings.mBroadPhaseLayerInterface = layers;
    settings.mObjectLayerPairFilter = pairs;
    settings.mObjectVsBroadPhaseLayerFilter = new jolt.ObjectVsBroadPhaseLayerFilterTable(layers, 1, pairs, 1);
    const world = new jolt.JoltInterface(settings);
    world.GetPhysicsSystem().SetGravity(new jolt.Vec3(0, 0, 0));
    const bodies = world.GetPhysicsSystem().GetBodyInterface();
    const leaves = both(velocity, part, (x, v) => {
      const grain = new jolt.BodyCreationSettings(new jolt.SphereShape(0.5), new jolt.RVec3(x, 0, 0),
        jolt.Quat.prototype.sIdentity(), jolt.EMotionType_Dynamic, 0);
      Object.assign(grain, { mRestitution: 1, mFriction: 0, mLinearDamping: 0, mAllowSleeping: false });
      const body = bodies.CreateBody(grain);
      bodies.AddBody(body.GetID(), jolt.EActivation_Activate);
      body.SetLinearVelocity(new jolt.Vec3(v, 0, 0));
      return body;
    }, () => world.Step(1 / 60, 1)).GetLinearVelocity().GetX();
    jolt.destroy(world);
    return leaves;
  },
  'matter-js'(velocity, part) { // velocities are ways in a sixtieth of a second
    const engine = matter.Engine.create({ gravity: { x: 0, y: 0 } });
    return both(velocity, part, (x, v) => {
      const body = matter.Bodies.circle(x, 0, 0.5, { restitution: 1, friction: 0, frictionAir: 0, frictionStatic: 0 });
      matter.Composite.add(engine.world, body);
      matter.Body.setVelocity(body, { x: v / 60, y: 0 });
      return body;
    }, () => matter.Engine.update(engine, 1000 / 60)).velocity.x * 60;
  },
  'cannon-es'(velocity, part) {
    const world = new cannon.World();
    Object.assign(world.defaultContactMaterial, { restitution: 1, friction: 0 });
    return both(velocity, part, (x, v) => {
      const body = new cannon.Body({ mass: 1, shape: new cannon.Sphere(0.5), linearDamping: 0, position: new cannon.Vec3(x, 0, 0),
        velocity: new cannon.Vec3(v, 0, 0) });
      world.addBody(body);
      return body;
    }, () => world.step(1 / 60)).velocity.x;
  },
  'p2-es'(velocity, part) {
    const world = new p2.World({ gravity: [0, 0] });
    Object.assign(world.defaultContactMaterial, { restitution: 1, friction: 0 });
    return both(velocity, part, (x, v) => {
      const body = new p2.Body({ mass: 1, position: [x, 0], velocity: [v, 0], damping: 0 });
      body.addShape(new p2.Circle({ radius: 0.5 }));
      world.addBody(body);
      return body;
    }, () => world.step(1 / 60)).velocity[0];
  },
  Rapier(velocity, part) {
    const world = new rapier.World({ x: 0, y: 0 });
    return both(velocity, part, (x, v) => {
      const body = world.createRigidBody(rapier.RigidBodyDesc.dynamic().setTranslation(x, 0).setLinvel(v, 0));
      world.createCollider(rapier.ColliderDesc.ball(0.5).setRestitution(1).setFriction(0), body);
      return body;
    }, () => world.step()).linvel().x;
  },
};
const words = (meet, v) => `${[0.1, 0.9].map((part) => Math.abs(meet(v, part) / v).toFixed(2)).join(', ')} at ${v}`;
for (const [name, meet] of Object.entries(engines)) console.log(`${name}: ${[10, 0.6, 0.4, 0.1].map((v) => words(meet, v)).join('; ')}`);
NODE
{ ./box2d; node meet.mjs 2> messages; } > seen || { cat seen messages; exit 1; }
cat seen
diff seen - <<'SEEN'
Box2D: 1.00, 1.00 at 10; 1.00, 1.00 at 0.6; 0.00, 0.00 at 0.4; 0.00, 0.00 at 0.1
Planck: 1.00, 1.00 at 10; 1.00, 1.00 at 0.6; 0.00, 0.00 at 0.4; 0.00, 0.00 at 0.1
Jolt: 1.00, 1.00 at 10; 1.00, 1.00 at 0.6; 0.00, 0.00 at 0.4; 0.00, 0.00 at 0.1
matter-js: 0.15, 0.15 at 10; 0.15, 0.15 at 0.6; 0.15, 0.15 at 0.4; 0.15, 0.15 at 0.1
cannon-es: 1.12, 0.88 at 10; 1.12, 0.88 at 0.6; 1.12, 0.88 at 0.4; 1.12, 0.88 at 0.1
p2-es: 1.00, 1.00 at 10; 1.00, 1.00 at 0.6; 1.00, 1.00 at 0.4; 1.00, 1.00 at 0.1
Rapier: 1.00, 1.00 at 10; 1.00, 1.00 at 0.6; 1.00, 1.00 at 0.4; 1.00, 1.00 at 0.1
SEEN
