#!/usr/bin/env bash
# GTS 0.7.6 (Debian 12: libgts-bin 0.7.6+darcs121130-5+b1): gtscheck, which, as its help has it, "checks that a surface defines a
# closed, orientable non self-intersecting manifold", on unit cubes in the format of GTS.
#
# Guess: a cube without one of its twelve triangles, or without its top, is not closed: a status other than 0.
# Seen: 0, as for the whole cube, and as for a single triangle. What is checked is orientable, manifold and not crossing itself:
# a turned triangle has status 2, two cubes through each other 3. The status alone lets open surfaces through, which have a
# volume by gts_surface_volume() all the same; the statistics of -v tell the number of boundary edges.
#   cube: status 0, boundary edges: 0
#   without the last triangle: status 0, boundary edges: 3
#   without a side: status 0, boundary edges: 4
#   a single triangle: status 0, boundary edges: 3
#   one turned: status 2, boundary edges: 0
#   two through each other: status 3, boundary edges: 0
set -euo pipefail
want=0.7.6+darcs121130-5+b1
version=$(dpkg-query -W -f='${Version}' libgts-bin 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs libgts-bin $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > cube.awk <<'AWK'
# cubes, each moved by x times its number, without the triangles from `first` on; the triangle `turned` the other way round
function edge(a, b, key) {
  key = a < b ? a " " b : b " " a
  if (!(key in known)) { known[key] = ++edges; list = list key "\n" }
  return known[key]
}
function triangle(a, b, c, e) {
  if (++n > first) return
  e = n == turned ? edge(a, c) " " edge(c, b) " " edge(b, a) : edge(a, b) " " edge(b, c) " " edge(c, a)
  faces++
  triangles = triangles e "\n"
}
BEGIN {
  split("1 2 4 3 5 7 8 6 1 5 6 2 3 4 8 7 2 6 8 4 1 3 7 5", c)
  for (cube = 0; cube < cubes; cube++) {
    for (k = 0; k < 8; k++) corners = corners int(k / 4) + 0.5 * cube " " int(k / 2) % 2 + 0.3 * cube " " k % 2 + 0.2 * cube "\n"
    n = 0
    for (k = 1; k <= 24; k += 4) {
      o = 8 * cube
      triangle(c[k] + o, c[k + 1] + o, c[k + 2] + o)
      triangle(c[k] + o, c[k + 2] + o, c[k + 3] + o)
    }
  }
  printf "%d %d %d\n%s%s%s", 8 * cubes, edges, faces, corners, list, triangles
}
AWK
check() { # NAME CUBES TRIANGLES TURNED
  awk -v cubes="$2" -v first="$3" -v turned="$4" -f cube.awk < /dev/null > cube.gts
  status=0
  gtscheck -v < cube.gts > /dev/null 2> report || status=$?
  echo "$1: status $status, $(grep -m 1 -o "boundary edges: [0-9]*" report)"
}
{
  check "cube" 1 12 0
  check "without the last triangle" 1 11 0
  check "without a side" 1 10 0
  check "a single triangle" 1 1 0
  check "one turned" 1 12 6
  check "two through each other" 2 12 0
} > seen
cat seen
diff seen - <<'SEEN'
cube: status 0, boundary edges: 0
without the last triangle: status 0, boundary edges: 3
without a side: status 0, boundary edges: 4
a single triangle: status 0, boundary edges: 3
one turned: status 2, boundary edges: 0
two through each other: status 3, boundary edges: 0
SEEN
