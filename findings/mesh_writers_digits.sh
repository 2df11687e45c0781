#!/usr/bin/env bash
# What triangle meshes keep of their coordinates when they are written: Open3D 0.16.1 (Debian 12: python3-open3d
# 0.16.1+ds-2+b4), CGAL 5.5.1 (libcgal-dev 5.5.1-2) and gts2stl of GTS 0.7.6 (libgts-bin 0.7.6+darcs121130-5+b1), by default: a
# vertex far from the origin, as of a grain in a large packing. All three keep double precision themselves.
#
# Guess: nine digits at least, as single precision needs, and sixteen where the file says double.
# Seen: six digits from all, in an ASCII PLY file of Open3D under "property double" as well, so that grains at 1000 from the
# origin have steps of 0.01: overlaps and fine triangles below that are lost or made, and none says anything. In CGAL give
# stream_precision(17), in Open3D write binary PLY.
#   open3d.obj: 1000.12
#   open3d.off: 1000.12
#   open3d.ply: 1000.12, property double x
#   cgal.off: 1000.12
#   cgal.obj: 1000.12
#   gts.stl: 1000.12
set -euo pipefail
for pair in python3-open3d=0.16.1+ds-2+b4 libcgal-dev=5.5.1-2 libgts-bin=0.7.6+darcs121130-5+b1; do
  version=$(dpkg-query -W -f='${Version}' "${pair%%=*}" 2>/dev/null || true)
  [ "$version" = "${pair#*=}" ] || { echo "needs ${pair%%=*} ${pair#*=}, found '${version:-none}'"; exit 77; }
done
command -v g++ >/dev/null || { echo "needs g++"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
printf 'OFF\n4 4 0\n1000.123456789 0 0\n0.00000123456789 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 3 1\n3 1 3 2\n3 0 2 3\n' > grain.off
{
  printf '4 6 4\n1000.123456789 0 0\n0.00000123456789 0 0\n0 1 0\n0 0 1\n'
  printf '1 2\n2 3\n3 1\n1 4\n4 2\n4 3\n1 2 3\n4 5 1\n5 6 2\n3 6 4\n'
} > grain.gts
cat > write.py <<'PYTHON'
import numpy
import open3d

points = numpy.array([[1000.123456789, 0, 0], [0.00000123456789, 0, 0], [0, 1, 0], [0, 0, 1]])
mesh = open3d.geometry.TriangleMesh(open3d.utility.Vector3dVector(points),
                                    open3d.utility.Vector3iVector(numpy.array([[0, 1, 2], [0, 3, 1], [1, 3, 2], [0, 2, 3]])))
for ending in ("obj", "off", "ply"):
    assert open3d.io.write_triangle_mesh(f"open3d.{ending}", mesh, write_ascii=True)
PYTHON
cat > write.cpp <<'CPP'
#include <CGAL/Simple_cartesian.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <vector>

int main() {
  std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
  std::vector<std::vector<std::size_t>> faces;
  if (!CGAL::IO::read_polygon_soup("grain.off", points, faces)) return 1;
  const bool off = CGAL::IO::write_polygon_soup("cgal.off", points, faces);
  const bool obj = CGAL::IO::write_polygon_soup("cgal.obj", points, faces);
  return off && obj ? 0 : 1;
}
CPP
{
  /usr/bin/python3 write.py
  g++ -std=c++17 -O0 -w write.cpp -o write -lgmp -lmpfr
  ./write
  gts2stl < grain.gts > gts.stl
} > messages 2>&1 || { cat messages; exit 1; }
for file in open3d.obj open3d.off open3d.ply cgal.off cgal.obj gts.stl; do
  echo "$file: $(grep -o -m 1 '1000\.[0-9]*' "$file")$(grep -o 'property double x' "$file" | sed 's/^/, /' || true)"
done > seen
cat seen
diff seen - <<'SEEN'
open3d.obj: 1000.12
open3d.off: 1000.12
open3d.ply: 1000.12, property double x
cgal.off: 1000.12
cgal.obj: 1000.12
gts.stl: 1000.12
SEEN
