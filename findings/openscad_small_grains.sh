#!/usr/bin/env bash
# OpenSCAD 2021.01 (Debian 12: openscad 2021.01-6) cutting a grain, a sphere of 12 by 24 corners, by the plane through its centre,
# as one makes fragments of grains: volume of the half as a share of that of the whole, at ever smaller radii.
#
# Guess: 0.500 at every radius, as coordinates are kept (the grain alone is exported with six digits at each).
# Seen: with the first boolean operation corners are rounded to multiples of 2^-20, about 1e-6: at a radius of 1e-4 (0.1 mm, where
# the unit is a metre) the half has 0.489, at 1e-5 0.430, with half of its triangles gone, and the status is
# 0; at 1e-6 it is empty, which is an error. Scale grains to about 1 first.
#   radius 1: whole 4.071 of r^3, half 332 triangles, 0.500 of the whole
#   radius 1e-3: whole 4.071 of r^3, half 332 triangles, 0.499 of the whole
#   radius 1e-4: whole 4.071 of r^3, half 308 triangles, 0.489 of the whole
#   radius 1e-5: whole 4.071 of r^3, half 154 triangles, 0.430 of the whole
set -euo pipefail
want=2021.01-6
version=$(dpkg-query -W -f='${Version}' openscad 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs openscad $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
volume() { # FILE.stl: by the tetrahedra to the origin
  awk 'BEGIN { n = 0 }
    $1 == "vertex" { x[n] = $2; y[n] = $3; z[n] = $4; n++ }
    n == 3 { n = 0; triangles++
      sum += x[0] * (y[1] * z[2] - z[1] * y[2]) + y[0] * (z[1] * x[2] - x[1] * z[2]) + z[0] * (x[1] * y[2] - y[1] * x[2]) }
    END { printf "%d %.9g\n", triangles, sum / 6 }' "$1"
}
for radius in 1 1e-3 1e-4 1e-5; do
  echo "sphere(r=$radius, \$fn=24);" > whole.scad
  echo "intersection() { sphere(r=$radius, \$fn=24); translate([-0.5, -0.5, 0]) cube(1); }" > half.scad
  [ "$radius" != 1 ] || sed -i 's/-0.5, -0.5, 0]) cube(1)/-5, -5, 0]) cube(10)/' half.scad
  for part in whole half; do
    openscad -o "$part.stl" "$part.scad" 2> messages || { cat messages; exit 1; }
  done
  read -r _ all <<< "$(volume whole.stl)"
  read -r triangles cut <<< "$(volume half.stl)"
  awk -v r="$radius" -v all="$all" -v cut="$cut" -v n="$triangles" 'BEGIN {
    printf "radius %s: whole %.3f of r^3, half %d triangles, %.3f of the whole\n", r, all / r ^ 3, n, cut / all }'
done > seen
cat seen
diff seen - <<'SEEN'
radius 1: whole 4.071 of r^3, half 332 triangles, 0.500 of the whole
radius 1e-3: whole 4.071 of r^3, half 332 triangles, 0.499 of the whole
radius 1e-4: whole 4.071 of r^3, half 308 triangles, 0.489 of the whole
radius 1e-5: whole 4.071 of r^3, half 154 triangles, 0.430 of the whole
SEEN
