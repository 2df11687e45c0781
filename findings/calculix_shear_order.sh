#!/usr/bin/env bash
# CalculiX 2.20 (Debian 12: calculix-ccx 2.20-1): the stress of a cube (E = 1000, nu = 0) sheared by 0.01 in xz and by 0.02 in yz, which
# is 5 and 10, in both output files of one run: the table of *EL PRINT (.dat) and the field of *EL FILE (.frd).
#
# Guess: six components in one order in both files, and the same numbers.
# Seen: .dat has xx yy zz xy xz yz, the order of Abaqus, and .frd has xx yy zz xy yz zx, that of VTK: who reads both by place has
# two shear stresses exchanged, which neither the pressure shows nor a test in a plane. And .frd says 9.9996 and 4.9998 for a stress
# that is the same all over the cube: 0.004% are lost on the way from the points inside to the corners.
#   .dat: sxx,syy,szz,sxy,sxz,syz = 0.0000 0.0000 0.0000 0.0000 5.0000 10.0000
#   .frd: sxx,syy,szz,sxy,syz,szx = 0.0000 0.0000 0.0000 0.0000 9.9996 4.9998
set -euo pipefail
want=2.20-1
version=$(dpkg-query -W -f='${Version}' calculix-ccx 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs calculix-ccx $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
{
  cat <<'INP'
*NODE, NSET=ALL
1, 0, 0, 0
2, 1, 0, 0
3, 1, 1, 0
4, 0, 1, 0
5, 0, 0, 1
6, 1, 0, 1
7, 1, 1, 1
8, 0, 1, 1
*ELEMENT, TYPE=C3D8, ELSET=CUBE
1, 1, 2, 3, 4, 5, 6, 7, 8
*MATERIAL, NAME=SOFT
*ELASTIC
1000, 0
*SOLID SECTION, ELSET=CUBE, MATERIAL=SOFT
*STEP
*STATIC
*BOUNDARY
ALL, 2, 2
INP
  # u_x = 0.01 z, u_z = 0.02 y
  for node in 1 2 3 4; do echo "$node, 1, 1, 0"; done
  for node in 5 6 7 8; do echo "$node, 1, 1, 0.01"; done
  for node in 1 2 5 6; do echo "$node, 3, 3, 0"; done
  for node in 3 4 7 8; do echo "$node, 3, 3, 0.02"; done
  cat <<'INP'
*EL PRINT, ELSET=CUBE
S
*EL FILE
S
*END STEP
INP
} > cube.inp
ccx cube > messages 2>&1 || { cat messages; exit 1; }
{
  awk '/stresses/ { sub(/.*pnt.,/, ""); sub(/\).*/, ""); names = $0 }
       $1 == 1 && NF == 8 { printf ".dat: %s = %.4f %.4f %.4f %.4f %.4f %.4f\n", names, $3, $4, $5, $6, $7, $8; exit }' cube.dat
  awk '$1 == -4 { inside = $2 == "STRESS" }
       inside && $1 == -5 { names = names "," tolower($2) }
       inside && $1 == -1 {
         printf ".frd: %s =", substr(names, 2)
         for (n = 0; n < 6; ++n) printf " %.4f", substr($0, 14 + 12 * n, 12)
         printf "\n"
         exit
       }' cube.frd
} | sed 's/-0\.0000/0.0000/g' > seen
cat seen
diff seen - <<'SEEN'
.dat: sxx,syy,szz,sxy,sxz,syz = 0.0000 0.0000 0.0000 0.0000 5.0000 10.0000
.frd: sxx,syy,szz,sxy,syz,szx = 0.0000 0.0000 0.0000 0.0000 9.9996 4.9998
SEEN
