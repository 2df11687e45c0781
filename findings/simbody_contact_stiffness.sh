#!/usr/bin/env bash
# Simbody 3.7 (Debian 12: libsimbody-dev 3.7+dfsg-3, compiled by g++), HuntCrossleyForce, "based on Hertz": the static force
# between two spheres of one material, and between a sphere and a plane, with an overlap of a hundredth of the radius, over
# that of Hertz, 4/3 sqrt(R) E* d^1.5 with 1 / E* = 1 / E1 + 1 / E2 for the plane strain moduli E1 and E2, as its parameters
# are.
#
# Guess: 1 in each case.
# Seen: 0.707 where both bodies are of one material, and right only if one of them is much stiffer: the moduli are put
# together by their powers of 2/3, as if each body were a spring of its own with a force of d^1.5, not by their inverses. A
# modulus that is measured by pressing grains onto glass is 29% too soft between grains, at the worst. Give each a modulus
# larger by the square root of 2.
#   radius 1, two spheres of one modulus: 0.707
#   radius 0.001, two spheres of one modulus: 0.707
#   sphere on a plane 1 times as stiff: 0.707
#   sphere on a plane 10 times as stiff: 0.821
#   sphere on a plane 100 times as stiff: 0.944
#   sphere on a plane 1e+06 times as stiff: 1.000
set -euo pipefail
want=3.7+dfsg-3
version=$(dpkg-query -W -f='${Version}' libsimbody-dev 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs libsimbody-dev $want, found '${version:-none}'"; exit 77; }
command -v g++ >/dev/null || { echo "needs g++"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > press.cpp <<'CPP'
#include <Simbody.h>

#include <cmath>
#include <cstdio>

using namespace SimTK;

double ratio(double first, double second, bool plane, double radius) {
    MultibodySystem system;
    SimbodyMatterSubsystem matter(system);
    GeneralContactSubsystem contacts(system);
    GeneralForceSubsystem forces(system);
    const ContactSetIndex set = contacts.createContactSet();
    HuntCrossleyForce law(forces, contacts, set);
    Body::Rigid body(MassProperties(1, Vec3(0), UnitInertia::sphere(radius)));
    MobilizedBody::Translation left(matter.updGround(), Transform(), body, Transform());
    MobilizedBody::Translation right(matter.updGround(), Transform(), body, Transform());
    contacts.addBody(set, left, ContactGeometry::Sphere(radius), Transform());
    if (plane) contacts.addBody(set, right, ContactGeometry::HalfSpace(), Transform());  // it fills x > 0
    else contacts.addBody(set, right, ContactGeometry::Sphere(radius), Transform());
    law.setBodyParameters(ContactSurfaceIndex(0), first, 0, 0, 0, 0);
    law.setBodyParameters(ContactSurfaceIndex(1), second, 0, 0, 0, 0);
    State state = system.realizeTopology();
    const double overlap = 0.01 * radius;
    right.setOneQ(state, 0, plane ? radius - overlap : 2 * radius - overlap);
    system.realize(state, Stage::Dynamics);
    const double force = system.getRigidBodyForces(state, Stage::Dynamics)[left.getMobilizedBodyIndex()][1].norm();
    const double modulus = 1 / (1 / first + 1 / second);
    return force / (4.0 / 3 * std::sqrt(plane ? radius : radius / 2) * modulus * std::pow(overlap, 1.5));
}

int main() {
    for (const double radius : {1.0, 0.001}) {
        std::printf("radius %g, two spheres of one modulus: %.3f\n", radius, ratio(1e6, 1e6, false, radius));
    }
    for (const double other : {1e6, 1e7, 1e8, 1e12}) {
        std::printf("sphere on a plane %g times as stiff: %.3f\n", other / 1e6, ratio(1e6, other, true, 1));
    }
}
CPP
g++ -O1 -w press.cpp -o press -I/usr/include/simbody -lSimTKsimbody -lSimTKmath -lSimTKcommon \
  2> messages || { cat messages; exit 1; }
./press > seen
cat seen
diff seen - <<'SEEN'
radius 1, two spheres of one modulus: 0.707
radius 0.001, two spheres of one modulus: 0.707
sphere on a plane 1 times as stiff: 0.707
sphere on a plane 10 times as stiff: 0.821
sphere on a plane 100 times as stiff: 0.944
sphere on a plane 1e+06 times as stiff: 1.000
SEEN
