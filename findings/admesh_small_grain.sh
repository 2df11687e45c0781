#!/usr/bin/env bash
# ADMesh 0.98.4 (Debian 12: admesh 0.98.4-2) reading a grain, a regular tetrahedron in STL, and writing it again, as a check of
# surfaces before a simulation does.
#
# Guess: the volume goes with the cube of the size, and the normals are the same at every size.
# Seen: at a size of 1e-3 the volume is given as 0.000000, and from 1e-6 on each normal that is written is 0 0 0, though the
# corners are kept and nothing is reported: a side of less than about 1e-12 has no direction. What tells inside from outside by
# the normals of the file finds neither. Scale grains to about 1 first (admesh --scale works on a file of micrometres).
#   size 1: volume 0.117851, normal of length 1.000
#   size 0.001: volume 0.000000, normal of length 1.000
#   size 1e-06: volume 0.000000, normal of length 0.000
set -euo pipefail
want=0.98.4-2
version=$(dpkg-query -W -f='${Version}' admesh 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs admesh $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
for size in 1 0.001 1e-06; do
  awk -v size="$size" 'BEGIN {
    h = sqrt(3) / 2; split("0 0 0", a); split("1 0 0", b); split("0.5 " h " 0", c); split("0.5 " h / 3 " " sqrt(2 / 3), d)
    print "solid grain"
    side(a, c, b); side(a, b, d); side(b, c, d); side(c, a, d)
    print "endsolid grain"
  }
  function corner(p) { printf "vertex %.9g %.9g %.9g\n", size * p[1], size * p[2], size * p[3] }
  function side(p, q, r) { print "facet normal 0 0 0\nouter loop"; corner(p); corner(q); corner(r); print "endloop\nendfacet" }
  ' > grain.stl
  admesh -a written.stl grain.stl > report
  volume=$(sed -n 's/.*Volume *: *//p' report)
  awk -v size="$size" -v volume="$volume" '/normal/ && !done { done = 1
    printf "size %s: volume %s, normal of length %.3f\n", size, volume, sqrt($3 * $3 + $4 * $4 + $5 * $5) }' written.stl
done > seen
cat seen
diff seen - <<'SEEN'
size 1: volume 0.117851, normal of length 1.000
size 0.001: volume 0.000000, normal of length 1.000
size 1e-06: volume 0.000000, normal of length 0.000
SEEN
