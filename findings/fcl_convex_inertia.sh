#!/usr/bin/env bash
# FCL 0.7.0 (Debian 12: libfcl-dev 0.7.0-3+b1, compiled by g++): volume and moments of inertia of a cube with a corner at the
# origin, as Boxd, which has its centre there, as Convexd of eight corners and twelve triangles, and as a mesh (BVHModel) of
# them, for sides of 0.1, 1 and 10.
#
# Guess: a moment of volume times side^2 / 6 about the centre of mass from all, as all have a density of 1.
# Seen: the volumes are right, and so are the moments of Boxd and of the mesh. Those of Convexd about the origin are for a mass
# of 1, not a density of 1, so that the volume is missing, and computeMomentofInertiaRelatedToCOM takes volume times distance^2
# away from them, as for a density of 1. What is left is 4000 times too large for a side of 0.1, and negative for 10. A cube of
# side 1, as in a first test, is right.
#   side 0.1, Boxd: volume 1.000 of it, about the centre of mass 1 of the moment
#   side 0.1, Convexd: volume 1.000 of it, about the centre of mass 3997 of the moment
#   side 0.1, BVHModel: volume 1.000 of it, about the centre of mass 1 of the moment
#   side 1, Boxd: volume 1.000 of it, about the centre of mass 1 of the moment
#   side 1, Convexd: volume 1.000 of it, about the centre of mass 1 of the moment
#   side 1, BVHModel: volume 1.000 of it, about the centre of mass 1 of the moment
#   side 10, Boxd: volume 1.000 of it, about the centre of mass 1 of the moment
#   side 10, Convexd: volume 1.000 of it, about the centre of mass -2.996 of the moment
#   side 10, BVHModel: volume 1.000 of it, about the centre of mass 1 of the moment
set -euo pipefail
want=0.7.0-3+b1
version=$(dpkg-query -W -f='${Version}' libfcl-dev 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs libfcl-dev $want, found '${version:-none}'"; exit 77; }
command -v g++ >/dev/null || { echo "needs g++"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > cube.cpp <<'CPP'
#include <fcl/fcl.h>

#include <cstdio>
#include <memory>
#include <vector>

void show(const char* name, double side, const fcl::CollisionGeometryd& shape) {
    const double volume = side * side * side, moment = volume * side * side / 6;
    std::printf("side %g, %s: volume %.3f of it, about the centre of mass %.4g of the moment\n", side, name,
                shape.computeVolume() / volume, shape.computeMomentofInertiaRelatedToCOM()(0, 0) / moment);
}

int main() {
    for (double side : {0.1, 1.0, 10.0}) {
        show("Boxd", side, fcl::Boxd(side, side, side));
        const auto corners = std::make_shared<std::vector<fcl::Vector3d>>();
        for (int n = 0; n < 8; ++n) corners->push_back(side * fcl::Vector3d(n & 1, n >> 1 & 1, n >> 2));
        const auto faces = std::make_shared<std::vector<int>>();
        std::vector<fcl::Triangle> triangles;
        const int quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
        for (const auto& q : quads) {
            for (int n : {1, 2}) {
                faces->insert(faces->end(), {3, q[0], q[n], q[n + 1]});
                triangles.emplace_back(q[0], q[n], q[n + 1]);
            }
        }
        show("Convexd", side, fcl::Convexd(corners, 12, faces));
        fcl::BVHModel<fcl::OBBRSSd> mesh;
        mesh.beginModel();
        mesh.addSubModel(*corners, triangles);
        mesh.endModel();
        show("BVHModel", side, mesh);
    }
}
CPP
g++ -std=c++17 -O1 -I/usr/include/eigen3 -o cube cube.cpp -lfcl -lccd -loctomap
./cube > seen
cat seen
diff seen - <<'SEEN'
side 0.1, Boxd: volume 1.000 of it, about the centre of mass 1 of the moment
side 0.1, Convexd: volume 1.000 of it, about the centre of mass 3997 of the moment
side 0.1, BVHModel: volume 1.000 of it, about the centre of mass 1 of the moment
side 1, Boxd: volume 1.000 of it, about the centre of mass 1 of the moment
side 1, Convexd: volume 1.000 of it, about the centre of mass 1 of the moment
side 1, BVHModel: volume 1.000 of it, about the centre of mass 1 of the moment
side 10, Boxd: volume 1.000 of it, about the centre of mass 1 of the moment
side 10, Convexd: volume 1.000 of it, about the centre of mass -2.996 of the moment
side 10, BVHModel: volume 1.000 of it, about the centre of mass 1 of the moment
SEEN
