#!/usr/bin/env bash
# CGAL 5.5.1 (Debian 12: libcgal-dev 5.5.1-2), Polygon_mesh_processing::IO::read_polygon_mesh, the reader that repairs: a sphere
# of radius 1 of 512 triangles whose normals look outwards, all but one, in an OFF file.
#
# Guess: the one triangle is turned, or the file is refused; the volume is 4.09 either way.
# Seen: the reader makes all agree with the first triangle of each part. If the odd one is the first, the other 511 are turned,
# the volume is -4.09, and of two such grains in a file, one of them with it, 0. The answer is true, and no message is given. What
# pushes outwards along normals then pulls inwards. CGAL::IO::read_polygon_mesh refuses such files, and so leaves no doubt;
# else ask is_outward_oriented() of each part afterwards.
#   none turned: true, closed yes, volume 4.09; CGAL::IO: true
#   the second turned: true, closed yes, volume 4.09; CGAL::IO: false
#   the last turned: true, closed yes, volume 4.09; CGAL::IO: false
#   the first turned: true, closed yes, volume -4.09; CGAL::IO: false
#   two spheres, the first turned: true, closed yes, volume 0.00; CGAL::IO: false
set -euo pipefail
want=5.5.1-2
version=$(dpkg-query -W -f='${Version}' libcgal-dev 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs libcgal-dev $want, found '${version:-none}'"; exit 77; }
command -v g++ >/dev/null || { echo "needs g++"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > sphere.cpp <<'CPP'
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <utility>
#include <vector>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Point = std::array<double, 3>;

std::vector<Point> points;
std::vector<std::array<int, 3>> triangles;

int middle(std::map<std::pair<int, int>, int>& known, int a, int b) {
  const auto [at, fresh] = known.try_emplace(std::minmax(a, b), static_cast<int>(points.size()));
  if (fresh) {
    Point p;
    for (int k = 0; k < 3; ++k) p[k] = points[a][k] + points[b][k];
    const double length = std::hypot(p[0], p[1], p[2]);
    for (double& x : p) x /= length;
    points.push_back(p);
  }
  return at->second;
}

void show(const char* name, int turned, int spheres) {
  {
    std::ofstream file("sphere.off");
    file.precision(17);
    file << "OFF\n" << spheres * points.size() << ' ' << spheres * triangles.size() << " 0\n";
    for (int n = 0; n < spheres; ++n)
      for (const Point& p : points) file << p[0] + 3 * n << ' ' << p[1] << ' ' << p[2] << '\n';
    for (int n = 0; n < spheres; ++n)
      for (int m = 0; m < static_cast<int>(triangles.size()); ++m) {
        std::array<int, 3> t = triangles[m];
        if (n == 0 && m == turned) std::swap(t[1], t[2]);
        file << "3";
        for (const int corner : t) file << ' ' << corner + n * points.size();
        file << '\n';
      }
  }
  Mesh strict, mesh;
  const bool refused = !CGAL::IO::read_polygon_mesh("sphere.off", strict);
  const bool good = CGAL::Polygon_mesh_processing::IO::read_polygon_mesh("sphere.off", mesh);
  double volume = 0;
  for (const auto face : mesh.faces()) {
    std::vector<Mesh::Point> p;
    for (const auto vertex : vertices_around_face(mesh.halfedge(face), mesh)) p.push_back(mesh.point(vertex));
    volume += (p[0] - CGAL::ORIGIN) * CGAL::cross_product(p[1] - CGAL::ORIGIN, p[2] - CGAL::ORIGIN) / 6;
  }
  std::printf("%s: %s, closed %s, volume %.2f; CGAL::IO: %s\n", name, good ? "true" : "false",
              CGAL::is_closed(mesh) ? "yes" : "no", std::abs(volume) < 1e-9 ? 0. : volume, refused ? "false" : "true");
}

int main() {
  for (const double x : {-1., 1.})
    for (int k = 0; k < 3; ++k) {
      points.push_back({});
      points.back()[k] = x;
    }
  for (int n = 0; n < 8; ++n) {  // an octahedron; corner k of a side has coordinate k of either sign
    const int a = n & 1 ? 3 : 0, b = n & 2 ? 4 : 1, c = n & 4 ? 5 : 2;
    const bool outwards = ((n & 1) + (n >> 1 & 1) + (n >> 2 & 1)) % 2 == 1;
    triangles.push_back({a, outwards ? b : c, outwards ? c : b});
  }
  for (int round = 0; round < 3; ++round) {
    std::map<std::pair<int, int>, int> known;
    std::vector<std::array<int, 3>> finer;
    for (const auto& [a, b, c] : triangles) {
      const int ab = middle(known, a, b), bc = middle(known, b, c), ca = middle(known, c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    triangles = finer;
  }
  show("none turned", -1, 1);
  show("the second turned", 1, 1);
  show("the last turned", static_cast<int>(triangles.size()) - 1, 1);
  show("the first turned", 0, 1);
  show("two spheres, the first turned", 0, 2);
}
CPP
g++ -std=c++17 -O0 -w sphere.cpp -o sphere -lgmp -lmpfr
./sphere > seen
cat seen
diff seen - <<'SEEN'
none turned: true, closed yes, volume 4.09; CGAL::IO: true
the second turned: true, closed yes, volume 4.09; CGAL::IO: false
the last turned: true, closed yes, volume 4.09; CGAL::IO: false
the first turned: true, closed yes, volume -4.09; CGAL::IO: false
two spheres, the first turned: true, closed yes, volume 0.00; CGAL::IO: false
SEEN
