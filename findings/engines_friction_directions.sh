#!/usr/bin/env bash
# Four engines for rigid bodies: Bullet 3.24 and Open Dynamics Engine 0.16.2 (Debian 12: libbullet-dev 3.24+dfsg-2, libode-dev
# 2:0.16.2-1, compiled by g++), and from npm Rapier (@dimforge/rapier3d-compat 0.21.0) and MuJoCo 3.3.8 (mujoco-js 0.0.7) with
# both of its friction cones: a cube that does not turn slides over a plane with a friction of 0.5 at a velocity of 5, at 0,
# 30 or 45 degrees to the x axis, as its sides are; from 0.1 s to 0.3 s its friction over its weight, and the direction of its
# velocity at the end.
#
# Guess: 0.5 in every direction, against the velocity, so that a cube that slides at 30 degrees goes on so until it stops.
# Seen: so with Bullet and Rapier. With ODE, as with dContactApprox1 and its two directions by default, the friction is 0.71
# at 30 and at 45 degrees, and pulls along the diagonal: the way bends towards the nearer axis, 30 degrees become 19. With
# MuJoCo's cone by default it is the other way round: least along the diagonal, 0.27, and 30 degrees become 38. No packing
# sheared with either is isotropic. In MuJoCo take cone="elliptic"; its softness costs a tenth still. In ODE give the
# direction of sliding (dContactFDir1).
#   Bullet, 0 degrees: friction 0.50, then at 0 degrees
#   Bullet, 30 degrees: friction 0.50, then at 30 degrees
#   Bullet, 45 degrees: friction 0.50, then at 45 degrees
#   ODE, 0 degrees: friction 0.50, then at 0 degrees
#   ODE, 30 degrees: friction 0.71, then at 19 degrees
#   ODE, 45 degrees: friction 0.71, then at 45 degrees
#   Rapier, 0 degrees: friction 0.50, then at 0 degrees
#   Rapier, 30 degrees: friction 0.50, then at 30 degrees
#   Rapier, 45 degrees: friction 0.50, then at 45 degrees
#   MuJoCo, elliptic, 0 degrees: friction 0.45, then at 0 degrees
#   MuJoCo, elliptic, 30 degrees: friction 0.45, then at 30 degrees
#   MuJoCo, elliptic, 45 degrees: friction 0.45, then at 45 degrees
#   MuJoCo, pyramidal, 0 degrees: friction 0.46, then at 0 degrees
#   MuJoCo, pyramidal, 30 degrees: friction 0.39, then at 38 degrees
#   MuJoCo, pyramidal, 45 degrees: friction 0.27, then at 45 degrees
set -euo pipefail
for pair in libbullet-dev=3.24+dfsg-2 libode-dev=2:0.16.2-1; do
  version=$(dpkg-query -W -f='${Version}' "${pair%%=*}" 2>/dev/null || true)
  [ "$version" = "${pair#*=}" ] || { echo "needs ${pair%%=*} ${pair#*=}, found '${version:-none}'"; exit 77; }
done
for tool in g++ npm pkg-config; do command -v $tool >/dev/null || { echo "needs $tool"; exit 77; }; done
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-save --ignore-scripts --prefix . @dimforge/rapier3d-compat@0.21.0 mujoco-js@0.0.7 >/dev/null
cat > slide.cpp <<'CPP'
#include <btBulletDynamicsCommon.h>
#include <ode/ode.h>

#include <cmath>
#include <cstdio>

namespace {
constexpr double pi = 3.14159265358979, step = 1.0 / 240;

void show(const char* name, double angle, const double* before, const double* after) {
    const double lost = std::hypot(before[0] - after[0], before[1] - after[1]) / 0.2 / 10;
    std::printf("%s, %.0f degrees: friction %.2f, then at %.0f degrees\n", name, angle, lost,
                std::atan2(after[1], after[0]) * 180 / pi + 0.0);
}

void bullet(double angle) {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
    world.setGravity(btVector3(0, 0, -10));
    btStaticPlaneShape floor(btVector3(0, 0, 1), 0);
    btBoxShape cube(btVector3(0.5, 0.5, 0.5));
    btRigidBody plane(btRigidBody::btRigidBodyConstructionInfo(0, nullptr, &floor));
    plane.setFriction(0.5);
    btRigidBody body(btRigidBody::btRigidBodyConstructionInfo(1, nullptr, &cube));
    body.setFriction(1);
    body.setAngularFactor(btVector3(0, 0, 0));
    body.setActivationState(DISABLE_DEACTIVATION);
    btTransform place = btTransform::getIdentity();
    place.setOrigin(btVector3(0, 0, 0.5));
    body.setWorldTransform(place);
    world.addRigidBody(&plane);
    world.addRigidBody(&body);
    const auto run = [&](int steps) {
        for (int n = 0; n < steps; ++n) world.stepSimulation(step, 0);
    };
    run(60);
    body.setLinearVelocity(btVector3(5 * std::cos(angle * pi / 180), 5 * std::sin(angle * pi / 180), 0));
    run(24);
    const double before[2] = {body.getLinearVelocity().x(), body.getLinearVelocity().y()};
    run(48);
    const double after[2] = {body.getLinearVelocity().x(), body.getLinearVelocity().y()};
    show("Bullet", angle, before, after);
    world.removeRigidBody(&body);
    world.removeRigidBody(&plane);
}

dWorldID world;
dJointGroupID contacts;

void touch(void*, dGeomID a, dGeomID b) {
    dContact found[8];
    const int number = dCollide(a, b, 8, &found[0].geom, sizeof(dContact));
    for (int n = 0; n < number; ++n) {
        found[n].surface.mode = dContactApprox1;
        found[n].surface.mu = 0.5;
        dJointAttach(dJointCreateContact(world, contacts, &found[n]), dGeomGetBody(a), dGeomGetBody(b));
    }
}

void ode(double angle) {
    world = dWorldCreate();
    dWorldSetGravity(world, 0, 0, -10);
    dSpaceID space = dSimpleSpaceCreate(nullptr);
    contacts = dJointGroupCreate(0);
    dCreatePlane(space, 0, 0, 1, 0);
    dBodyID body = dBodyCreate(world);
    dMass mass;
    dMassSetBox(&mass, 1, 1, 1, 1);
    dBodySetMass(body, &mass);
    dGeomSetBody(dCreateBox(space, 1, 1, 1), body);
    dBodySetPosition(body, 0, 0, 0.5);
    dBodySetMaxAngularSpeed(body, 0);
    const auto run = [&](int steps) {
        for (int n = 0; n < steps; ++n) {
            dSpaceCollide(space, nullptr, touch);
            dWorldQuickStep(world, step);
            dJointGroupEmpty(contacts);
        }
    };
    run(60);
    dBodySetLinearVel(body, 5 * std::cos(angle * pi / 180), 5 * std::sin(angle * pi / 180), 0);
    run(24);
    const double before[2] = {dBodyGetLinearVel(body)[0], dBodyGetLinearVel(body)[1]};
    run(48);
    const double after[2] = {dBodyGetLinearVel(body)[0], dBodyGetLinearVel(body)[1]};
    show("ODE", angle, before, after);
    dSpaceDestroy(space);
    dWorldDestroy(world);
}
}  // namespace

int main() {
    for (const double angle : {0.0, 30.0, 45.0}) bullet(angle);
    dInitODE();
    for (const double angle : {0.0, 30.0, 45.0}) ode(angle);
    dCloseODE();
}
CPP
cat > slide.mjs <<'NODE'
import RAPIER from '@dimforge/rapier3d-compat';
import loadMujoco from 'mujoco-js';
await RAPIER.init();
const mujoco = await loadMujoco();
const step = 1 / 240;
function slide(name, { run, push, velocity }, angle) {
  run(60);
  push(5 * Math.cos(angle * Math.PI / 180), 5 * Math.sin(angle * Math.PI / 180));
  run(24);
  const before = velocity();
  run(48);
  const after = velocity();
  const lost = Math.hypot(before[0] - after[0], before[1] - after[1]) / 0.2 / 10;
  const direction = Math.atan2(after[1], after[0]) * 180 / Math.PI + 0;
  const words = `friction ${lost.toFixed(2)}, then at ${direction.toFixed(0).replace('-0', '0')} degrees`;
  console.log(`${name}, ${angle} degrees: ${words}`);
}
function rapier() {
  const world = new RAPIER.World({ x: 0, y: 0, z: -10 });
  world.timestep = step;
  world.createCollider(RAPIER.ColliderDesc.cuboid(50, 50, 1).setTranslation(0, 0, -1).setFriction(0.5),
    world.createRigidBody(RAPIER.RigidBodyDesc.fixed()));
  const body = world.createRigidBody(RAPIER.RigidBodyDesc.dynamic().setTranslation(0, 0, 0.5).lockRotations().setCanSleep(false));
  world.createCollider(RAPIER.ColliderDesc.cuboid(0.5, 0.5, 0.5).setFriction(0.5), body);
  return {
    run: (steps) => { for (let n = 0; n < steps; ++n) world.step(); },
    push: (x, y) => body.setLinvel({ x, y, z: 0 }, true),
    velocity: () => [body.linvel().x, body.linvel().y],
  };
}
function mujocoCube(cone) {
  mujoco.FS.writeFile('/cube.xml', `<mujoco><option timestep="${step}" cone="${cone}" gravity="0 0 -10"/><worldbody>
    <geom type="plane" size="50 50 1" friction="0.5 0 0"/><body pos="0 0 0.5"><joint type="slide" axis="1 0 0"/>
    <joint type="slide" axis="0 1 0"/><joint type="slide" axis="0 0 1"/>
    <geom type="box" size="0.5 0.5 0.5" friction="0.5 0 0"/></body></worldbody></mujoco>`);
  const model = mujoco.MjModel.loadFromXML('/cube.xml');
  const data = new mujoco.MjData(model);
  return {
    run: (steps) => { for (let n = 0; n < steps; ++n) mujoco.mj_step(model, data); },
    push: (x, y) => { [data.qvel[0], data.qvel[1]] = [x, y]; },
    velocity: () => [data.qvel[0], data.qvel[1]],
  };
}
for (const [name, make] of [['Rapier', rapier], ['MuJoCo, elliptic', () => mujocoCube('elliptic')],
  ['MuJoCo, pyramidal', () => mujocoCube('pyramidal')]]) {
  for (const angle of [0, 30, 45]) slide(name, make(), angle);
}
NODE
g++ -O1 -w slide.cpp -o slide $(pkg-config --cflags --libs bullet ode)
{ ./slide && timeout 600 node slide.mjs; } > seen 2> messages || { cat messages; exit 1; }
cat seen
diff seen - <<'SEEN'
Bullet, 0 degrees: friction 0.50, then at 0 degrees
Bullet, 30 degrees: friction 0.50, then at 30 degrees
Bullet, 45 degrees: friction 0.50, then at 45 degrees
ODE, 0 degrees: friction 0.50, then at 0 degrees
ODE, 30 degrees: friction 0.71, then at 19 degrees
ODE, 45 degrees: friction 0.71, then at 45 degrees
Rapier, 0 degrees: friction 0.50, then at 0 degrees
Rapier, 30 degrees: friction 0.50, then at 30 degrees
Rapier, 45 degrees: friction 0.50, then at 45 degrees
MuJoCo, elliptic, 0 degrees: friction 0.45, then at 0 degrees
MuJoCo, elliptic, 30 degrees: friction 0.45, then at 30 degrees
MuJoCo, elliptic, 45 degrees: friction 0.45, then at 45 degrees
MuJoCo, pyramidal, 0 degrees: friction 0.46, then at 0 degrees
MuJoCo, pyramidal, 30 degrees: friction 0.39, then at 38 degrees
MuJoCo, pyramidal, 45 degrees: friction 0.27, then at 45 degrees
SEEN
