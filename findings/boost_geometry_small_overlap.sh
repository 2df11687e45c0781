#!/usr/bin/env bash
# Boost.Geometry 1.74 (Debian 12: libboost1.74-dev 1.74.0+ds1-21, compiled by g++) and Shapely 1.8.5 (python3-shapely
# 1.8.5-2+b1): the area of the overlap of two squares of side 2, turned by 0.3, as a force law by overlap needs it: side on side
# (2 d) and a corner pushed in by d (d²).
#
# Guess: doubles give ten digits or more of such an area, until d comes near 1e-12.
# Seen: Boost first moves corners to a grid of about 1e-7 of the picture: at d = 1e-5 a side is off by one per cent, at 1e-7 it
# is double, and a corner is 5 times too large; at 1e-8 a side has no overlap and a corner 550 times its own, though
# `intersects` is true each time. A force jumps where grains begin to touch, and energy is not conserved.
# BOOST_GEOMETRY_NO_ROBUSTNESS cures sides, not corners, which end at 1e-8. Shapely (GEOS) is right to one part in a thousand at
# 1e-12.
#   d 1e-02: side 1.000, corner 1.000 of the exact area; Shapely 1.000, 1.000
#   d 1e-05: side 1.009, corner 1.003 of the exact area; Shapely 1.000, 1.000
#   d 1e-07: side 2.108, corner 5.497 of the exact area; Shapely 1.000, 1.000
#   d 1e-08: side 0.000, corner 549.685 of the exact area; Shapely 1.000, 1.000
set -euo pipefail
for pair in libboost1.74-dev=1.74.0+ds1-21 python3-shapely=1.8.5-2+b1; do
  version=$(dpkg-query -W -f='${Version}' "${pair%%=*}" 2>/dev/null || true)
  [ "$version" = "${pair#*=}" ] || { echo "needs ${pair%%=*} ${pair#*=}, found '${version:-none}'"; exit 77; }
done
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > overlap.cpp <<'CPP'
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>

#include <cmath>
#include <cstdio>

namespace geometry = boost::geometry;
using Point = geometry::model::d2::point_xy<double>;
using Polygon = geometry::model::polygon<Point, false>;

Polygon square(double distance, double turn) {
  Polygon result;
  for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}})
    geometry::append(result.outer(), Point(distance * std::cos(0.3) + std::cos(turn) * x - std::sin(turn) * y,
                                           distance * std::sin(0.3) + std::sin(turn) * x + std::cos(turn) * y));
  return result;
}

double overlap(const Polygon& a, const Polygon& b) {
  geometry::model::multi_polygon<Polygon> common;
  geometry::intersection(a, b, common);
  return geometry::intersects(a, b) ? geometry::area(common) : -1;
}

int main() {
  for (const double d : {1e-2, 1e-5, 1e-7, 1e-8}) {
    const Polygon first = square(0, 0.3);
    const double side = overlap(first, square(2 - d, 0.3));
    const double corner = overlap(first, square(1 + std::sqrt(2.0) - d, 0.3 + std::acos(-1.0) / 4));
    std::printf("d %.0e: side %.3f, corner %.3f of the exact area\n", d, side / (2 * d), corner / (d * d));
  }
}
CPP
g++ -std=c++17 -O1 overlap.cpp -o overlap 2>messages
./overlap > boost
/usr/bin/python3 - > shapely <<'PYTHON'
import math

from shapely.geometry import Polygon


def square(distance, turn):
    c, s = math.cos(turn), math.sin(turn)
    return Polygon([(distance * math.cos(0.3) + c * x - s * y, distance * math.sin(0.3) + s * x + c * y)
                    for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))])


for d in (1e-2, 1e-5, 1e-7, 1e-8):
    first = square(0, 0.3)
    side = first.intersection(square(2 - d, 0.3)).area / (2 * d)
    corner = first.intersection(square(1 + math.sqrt(2) - d, 0.3 + math.pi / 4)).area / d**2
    print(f"Shapely {side:.3f}, {corner:.3f}")
PYTHON
paste -d';' boost shapely | sed 's/;/; /' > seen
cat seen
diff seen - <<'SEEN'
d 1e-02: side 1.000, corner 1.000 of the exact area; Shapely 1.000, 1.000
d 1e-05: side 1.009, corner 1.003 of the exact area; Shapely 1.000, 1.000
d 1e-07: side 2.108, corner 5.497 of the exact area; Shapely 1.000, 1.000
d 1e-08: side 0.000, corner 549.685 of the exact area; Shapely 1.000, 1.000
SEEN
