#!/usr/bin/env bash
# Open Dynamics Engine 0.16.2 (Debian 12: libode-dev 2:0.16.2-1): a grain as a mesh of triangles, a tetrahedron of density 1 with
# its corner of three right angles at (d, d, d): dMassSetTrimesh, then dMassTranslate by minus the centre of mass, as a body needs
# it. The moments about the axes through that centre are 0.0125.
#
# Guess: 0.0125 wherever the mesh lies, up to single precision.
# Seen: dMassSetTrimesh has the moments about the origin and adds the step from the centre of mass to it once more. What is left
# after the translation are the moments about the origin: 2.7 times too large at d = 0 and 283 times at d = 3, and right where
# the centre of mass is the origin. dMassCheck has nothing against them, and a blow turns the grain as slowly as they say. Move
# the vertices first, so that the centre of mass is at the origin.
#   d = -0.25: mass 0.1667, centre of mass 0.00, moments 0.0125 0.0125 0.0125, check 1, by a blow 0.0104 for 0.0104
#   d = 0: mass 0.1667, centre of mass 0.25, moments 0.0333 0.0333 0.0333, check 1, by a blow 0.0417 for 0.0104
#   d = 1: mass 0.1667, centre of mass 1.25, moments 0.5333 0.5333 0.5333, check 1, by a blow 0.7917 for 0.0104
#   d = 3: mass 0.1667, centre of mass 3.25, moments 3.5333 3.5333 3.5333, check 1, by a blow 5.2917 for 0.0104
set -euo pipefail
want=2:0.16.2-1
version=$(dpkg-query -W -f='${Version}' libode-dev 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs libode-dev $want, found '${version:-none}'"; exit 77; }
command -v g++ >/dev/null || { echo "needs g++"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > mass.cpp <<'CPP'
#include <cstdio>
#include <initializer_list>
#include <ode/ode.h>

void look(float d) {
  float corners[] = {d, d, d, d + 1, d, d, d, d + 1, d, d, d, d + 1};
  dTriIndex faces[] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
  dTriMeshDataID data = dGeomTriMeshDataCreate();
  dGeomTriMeshDataBuildSingle(data, corners, 3 * sizeof(float), 4, faces, 12, 3 * sizeof(dTriIndex));
  dGeomID mesh = dCreateTriMesh(nullptr, data, nullptr, nullptr, nullptr);
  dMass mass;
  dMassSetTrimesh(&mass, 1, mesh);
  double centre = mass.c[0];
  dMassTranslate(&mass, -mass.c[0], -mass.c[1], -mass.c[2]);
  dWorldID world = dWorldCreate();
  dBodyID body = dBodyCreate(world);
  dBodySetMass(body, &mass);
  dBodyAddTorque(body, 1, -1, 0);  // along a principal axis, with the moment 1 / 96
  dWorldStep(world, 1e-6);
  std::printf("d = %g: mass %.4f, centre of mass %.2f, moments %.4f %.4f %.4f, check %d, by a blow %.4f for %.4f\n", d, mass.mass,
              centre, mass.I[0], mass.I[5], mass.I[10], dMassCheck(&mass), 1e-6 / dBodyGetAngularVel(body)[0], 1 / 96.0);
}

int main() {
  dInitODE();
  for (float d : {-0.25F, 0.0F, 1.0F, 3.0F}) look(d);
  dCloseODE();
}
CPP
g++ -std=c++17 -O0 -w mass.cpp -o mass -lode
./mass > seen
cat seen
diff seen - <<'SEEN'
d = -0.25: mass 0.1667, centre of mass 0.00, moments 0.0125 0.0125 0.0125, check 1, by a blow 0.0104 for 0.0104
d = 0: mass 0.1667, centre of mass 0.25, moments 0.0333 0.0333 0.0333, check 1, by a blow 0.0417 for 0.0104
d = 1: mass 0.1667, centre of mass 1.25, moments 0.5333 0.5333 0.5333, check 1, by a blow 0.7917 for 0.0104
d = 3: mass 0.1667, centre of mass 3.25, moments 3.5333 3.5333 3.5333, check 1, by a blow 5.2917 for 0.0104
SEEN
