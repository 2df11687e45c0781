#!/usr/bin/env bash
# CGAL 5.5.1 (Debian 12: libcgal-dev 5.5.1-2, compiled by g++), Periodic_2_Delaunay_triangulation_2 of grains in a periodic square of
# side 1, as it is needed for neighbours and free areas: random places everywhere, or in the left half.
#
# Guess: a loop over the triangles (faces_begin to faces_end) meets each once, their areas adding up to 1, and number_of_faces() is
# as many as it meets.
# Seen: where the triangles are not all small, the triangulation is kept nine times, and the loop meets all copies: areas add up
# to 9, and vertices and edges of a loop are nine times those of number_of_vertices() and number_of_edges(), which count them once.
# Some fifty grains at random places make it one, and then it is right; a hole makes it nine again at any number. So what works in
# a test on many grains is nine times too large for few, or once they cluster. Loop with periodic_triangles_begin(T::UNIQUE), or ask
# is_1_cover().
#   8 grains everywhere: number_of_faces 16, the loop meets 144 of area 9.000, UNIQUE has 1.000
#   32 grains everywhere: number_of_faces 64, the loop meets 576 of area 9.000, UNIQUE has 1.000
#   64 grains everywhere: number_of_faces 128, the loop meets 128 of area 1.000, UNIQUE has 1.000
#   512 grains everywhere: number_of_faces 1024, the loop meets 1024 of area 1.000, UNIQUE has 1.000
#   512 grains in one half: number_of_faces 1024, the loop meets 9216 of area 9.000, UNIQUE has 1.000
set -euo pipefail
want=5.5.1-2
version=$(dpkg-query -W -f='${Version}' libcgal-dev 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs libcgal-dev $want, found '${version:-none}'"; exit 77; }
command -v g++ >/dev/null || { echo "needs g++"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > areas.cpp <<'CPP'
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Periodic_2_Delaunay_triangulation_2.h>
#include <CGAL/Periodic_2_Delaunay_triangulation_traits_2.h>

#include <cstdio>
#include <random>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangulation = CGAL::Periodic_2_Delaunay_triangulation_2<CGAL::Periodic_2_Delaunay_triangulation_traits_2<Kernel>>;

void show(const char* where, int number, double width) {
    std::mt19937 random(1);
    Triangulation triangulation(Triangulation::Iso_rectangle(0, 0, 1, 1));
    const auto uniform = [&random] { return random() / 4294967296.0; };
    for (int n = 0; n < number; ++n) {
        const double x = width * uniform(), y = uniform();
        triangulation.insert(Triangulation::Point(x, y));
    }
    double looped = 0, unique = 0;
    int faces = 0;
    for (auto face = triangulation.faces_begin(); face != triangulation.faces_end(); ++face, ++faces)
        looped += triangulation.triangle(triangulation.periodic_triangle(face)).area();
    for (auto face = triangulation.periodic_triangles_begin(Triangulation::UNIQUE);
         face != triangulation.periodic_triangles_end(Triangulation::UNIQUE); ++face)
        unique += triangulation.triangle(*face).area();
    std::printf("%d grains %s: number_of_faces %zu, the loop meets %d of area %.3f, UNIQUE has %.3f\n", number, where,
                std::size_t(triangulation.number_of_faces()), faces, looped, unique);
}

int main() {
    for (int number : {8, 32, 64, 512}) show("everywhere", number, 1);
    show("in one half", 512, 0.5);
}
CPP
g++ -O1 -frounding-math -o areas areas.cpp -lgmp -lmpfr
./areas > seen
cat seen
diff seen - <<'SEEN'
8 grains everywhere: number_of_faces 16, the loop meets 144 of area 9.000, UNIQUE has 1.000
32 grains everywhere: number_of_faces 64, the loop meets 576 of area 9.000, UNIQUE has 1.000
64 grains everywhere: number_of_faces 128, the loop meets 128 of area 1.000, UNIQUE has 1.000
512 grains everywhere: number_of_faces 1024, the loop meets 1024 of area 1.000, UNIQUE has 1.000
512 grains in one half: number_of_faces 1024, the loop meets 9216 of area 9.000, UNIQUE has 1.000
SEEN
