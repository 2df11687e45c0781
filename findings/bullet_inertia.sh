#!/usr/bin/env bash
# Bullet 3.24 (Debian 12: libbullet-dev 3.24+dfsg-2, compiled by g++): the moment of inertia of grains of mass 1 by
# calculateLocalInertia, each of size 2 and of size 0.02, in units of mass times half the size squared.
#
# Guess: those of the closed forms, at any size.
# Seen: spheres, boxes and cylinders are right. A grain given by its corners (btConvexHullShape) has the moment of its bounding box,
# enlarged on all sides by 0.12, three times the default margin of collisions, whatever its size: a regular tetrahedron of size
# 2 has twice its moment, one of 0.02 282 times, a cube of 0.02 169 times. A cone is taken for such a box, and a capsule, a rod
# with round ends, for its bounding box. Set the margin before, or pass moments of your own to the body.
#   sphere: true 0.4000, of size 2 0.4000, of size 0.02 0.4000
#   box: true 0.6667, of size 2 0.6667, of size 0.02 0.6667
#   cylinder: true 0.5833, of size 2 0.5833, of size 0.02 0.5833
#   cube of corners: true 0.6667, of size 2 0.8363, of size 0.02 112.6667
#   tetrahedron of corners: true 0.4000, of size 2 0.8363, of size 0.02 112.6667
#   cone: true 0.3000, of size 2 0.8363, of size 0.02 112.6667
#   capsule: true 0.3025, of size 2 0.4167, of size 0.02 0.4167
set -euo pipefail
want=3.24+dfsg-2
version=$(dpkg-query -W -f='${Version}' libbullet-dev 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs libbullet-dev $want, found '${version:-none}'"; exit 77; }
command -v g++ >/dev/null || { echo "needs g++"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > moments.cpp <<'CPP'
#include <btBulletDynamicsCommon.h>

#include <cstdio>

void show(const char* name, double truth, btCollisionShape& large, btCollisionShape& small) {
    btVector3 of_large, of_small;
    large.calculateLocalInertia(1, of_large);
    small.calculateLocalInertia(1, of_small);
    std::printf("%s: true %.4f, of size 2 %.4f, of size 0.02 %.4f\n", name, truth, of_large.x(), of_small.x() / 1e-4);
}

btConvexHullShape hull(double size, bool all_corners) {
    btConvexHullShape shape;
    for (int corner = 0; corner < 8; ++corner) {
        const int x = corner & 1 ? 1 : -1, y = corner & 2 ? 1 : -1, z = corner & 4 ? 1 : -1;
        if (all_corners || x * y * z == 1) shape.addPoint(size * btVector3(x, y, z));
    }
    return shape;
}

int main() {
    btSphereShape sphere(1), small_sphere(0.01);
    show("sphere", 0.4, sphere, small_sphere);
    btBoxShape box(btVector3(1, 1, 1)), small_box(btVector3(0.01, 0.01, 0.01));
    show("box", 2.0 / 3, box, small_box);
    btCylinderShape cylinder(btVector3(1, 1, 1)), small_cylinder(btVector3(0.01, 0.01, 0.01));
    show("cylinder", 7.0 / 12, cylinder, small_cylinder);
    btConvexHullShape cube = hull(1, true), small_cube = hull(0.01, true);
    show("cube of corners", 2.0 / 3, cube, small_cube);
    btConvexHullShape tetrahedron = hull(1, false), small_tetrahedron = hull(0.01, false);
    show("tetrahedron of corners", 0.4, tetrahedron, small_tetrahedron);
    btConeShape cone(1, 2), small_cone(0.01, 0.02);
    show("cone", 3.0 / 20 + 3.0 / 80 * 4, cone, small_cone);
    // two half spheres and a cylinder of radius 1/2 and length 1, of volumes 2 to 3, their centres of mass 3/16 away from it
    btCapsuleShape capsule(0.5, 1), small_capsule(0.005, 0.01);
    const double ends = 0.4 * (0.4 * 0.25 - 9.0 / 256 + 121.0 / 256), middle = 0.6 * (3 * 0.25 + 1) / 12;
    show("capsule", ends + middle, capsule, small_capsule);
}
CPP
g++ -std=c++17 -I/usr/include/bullet -o moments moments.cpp -lBulletDynamics -lBulletCollision -lLinearMath
./moments > seen
cat seen
diff seen - <<'SEEN'
sphere: true 0.4000, of size 2 0.4000, of size 0.02 0.4000
box: true 0.6667, of size 2 0.6667, of size 0.02 0.6667
cylinder: true 0.5833, of size 2 0.5833, of size 0.02 0.5833
cube of corners: true 0.6667, of size 2 0.8363, of size 0.02 112.6667
tetrahedron of corners: true 0.4000, of size 2 0.8363, of size 0.02 112.6667
cone: true 0.3000, of size 2 0.8363, of size 0.02 112.6667
capsule: true 0.3025, of size 2 0.4167, of size 0.02 0.4167
SEEN
