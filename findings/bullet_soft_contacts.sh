#!/usr/bin/env bash
# Bullet 3.24 (Debian 12: libbullet-dev 3.24+dfsg-2, compiled by g++), setContactStiffnessAndDamping, which makes a contact a
# spring with a dashpot: a grain of mass 1 on a plate, at gravity 10, with a stiffness of 10 / overlap, so that it rests at that
# overlap, where it is put at the start; what its overlap is after 10, for grains of radius 0.5 and 50, at steps of 1/60 and
# 1/600.
#
# Guess: it stays where it is.
# Seen: so it does up to an overlap of 0.039. From 0.041 on there is no spring, and the grain sinks into the plate and through
# it, the faster the finer the step, whatever its size: 0.041 is 0.08% of a radius of 50. What lies deeper than
# m_splitImpulsePenetrationThreshold, -0.04, is left to a push that is to take overlaps away and does not know the stiffness.
# With m_splitImpulse = 0 all rest where they should. In a stack the lower grains fail first, as they carry more.
#   radius 0.5, steps of 1/60; 0.02 is 0.02; 0.039 is 0.04; 0.041 is 0.11; 0.1 is 0.38
#   radius 0.5, steps of 1/60, m_splitImpulse = 0; 0.02 is 0.02; 0.039 is 0.04; 0.041 is 0.04; 0.1 is 0.10
#   radius 0.5, steps of 1/600; 0.02 is 0.02; 0.039 is 0.04; 0.041 is 0.80; 0.1 is 2.47
#   radius 0.5, steps of 1/600, m_splitImpulse = 0; 0.02 is 0.02; 0.039 is 0.04; 0.041 is 0.04; 0.1 is 0.10
#   radius 50, steps of 1/60; 0.02 is 0.02; 0.039 is 0.04; 0.041 is 0.11; 0.1 is 0.38
#   radius 50, steps of 1/60, m_splitImpulse = 0; 0.02 is 0.02; 0.039 is 0.04; 0.041 is 0.04; 0.1 is 0.10
#   radius 50, steps of 1/600; 0.02 is 0.02; 0.039 is 0.04; 0.041 is 0.80; 0.1 is 2.47
#   radius 50, steps of 1/600, m_splitImpulse = 0; 0.02 is 0.02; 0.039 is 0.04; 0.041 is 0.04; 0.1 is 0.10
set -euo pipefail
want=3.24+dfsg-2
version=$(dpkg-query -W -f='${Version}' libbullet-dev 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs libbullet-dev $want, found '${version:-none}'"; exit 77; }
command -v g++ >/dev/null || { echo "needs g++"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > rest.cpp <<'CPP'
#include <btBulletDynamicsCommon.h>

#include <cmath>
#include <cstdio>

double overlap_at_the_end(double radius, double overlap, int steps, int split_impulse) {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase pairs;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld world(&dispatcher, &pairs, &solver, &configuration);
    world.setGravity(btVector3(0, -10, 0));
    world.getSolverInfo().m_splitImpulse = split_impulse;
    btStaticPlaneShape plane(btVector3(0, 1, 0), 0);
    btRigidBody plate(btRigidBody::btRigidBodyConstructionInfo(0, nullptr, &plane));
    world.addRigidBody(&plate);
    btSphereShape sphere(radius);
    btVector3 inertia;
    sphere.calculateLocalInertia(1, inertia);
    btRigidBody::btRigidBodyConstructionInfo start(1, nullptr, &sphere, inertia);
    start.m_startWorldTransform.setIdentity();
    start.m_startWorldTransform.setOrigin(btVector3(0, radius - overlap, 0));
    btRigidBody grain(start);
    grain.setActivationState(DISABLE_DEACTIVATION);
    const double stiffness = 10 / overlap;
    grain.setContactStiffnessAndDamping(stiffness, 2 * std::sqrt(stiffness));
    world.addRigidBody(&grain);
    for (int step = 0; step < 10 * steps; ++step) world.stepSimulation(1.0 / steps, 0, 1.0 / steps);
    const double end = radius - grain.getWorldTransform().getOrigin().y();
    world.removeRigidBody(&grain);
    world.removeRigidBody(&plate);
    return end;
}

int main() {
    for (double radius : {0.5, 50.0}) {
        for (int steps : {60, 600}) {
            for (int split_impulse : {1, 0}) {
                std::printf("radius %g, steps of 1/%d%s", radius, steps, split_impulse ? "" : ", m_splitImpulse = 0");
                for (double overlap : {0.02, 0.039, 0.041, 0.1})
                    std::printf("; %g is %.2f", overlap, overlap_at_the_end(radius, overlap, steps, split_impulse));
                std::printf("\n");
            }
        }
    }
}
CPP
g++ -std=c++17 -O1 -I/usr/include/bullet -o rest rest.cpp -lBulletDynamics -lBulletCollision -lLinearMath
./rest > seen
cat seen
diff seen - <<'SEEN'
radius 0.5, steps of 1/60; 0.02 is 0.02; 0.039 is 0.04; 0.041 is 0.11; 0.1 is 0.38
radius 0.5, steps of 1/60, m_splitImpulse = 0; 0.02 is 0.02; 0.039 is 0.04; 0.041 is 0.04; 0.1 is 0.10
radius 0.5, steps of 1/600; 0.02 is 0.02; 0.039 is 0.04; 0.041 is 0.80; 0.1 is 2.47
radius 0.5, steps of 1/600, m_splitImpulse = 0; 0.02 is 0.02; 0.039 is 0.04; 0.041 is 0.04; 0.1 is 0.10
radius 50, steps of 1/60; 0.02 is 0.02; 0.039 is 0.04; 0.041 is 0.11; 0.1 is 0.38
radius 50, steps of 1/60, m_splitImpulse = 0; 0.02 is 0.02; 0.039 is 0.04; 0.041 is 0.04; 0.1 is 0.10
radius 50, steps of 1/600; 0.02 is 0.02; 0.039 is 0.04; 0.041 is 0.80; 0.1 is 2.47
radius 50, steps of 1/600, m_splitImpulse = 0; 0.02 is 0.02; 0.039 is 0.04; 0.041 is 0.04; 0.1 is 0.10
SEEN
