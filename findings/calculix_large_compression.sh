#!/usr/bin/env bash
# CalculiX 2.20 (Debian 12: calculix-ccx 2.20-1): a cube with a side of 1 of *ELASTIC, E = 150 and ratio 0.25, one element C3D8,
# in a static step with NLGEOM: its top is pressed down between plates without friction. The force on the top, and the stress and
# strain along the load in the .dat file.
#
# Guess: like rubber, the harder to press the flatter it is. At a height of 0.5 a law with logarithmic strains, as other programs
# take for the same keyword, has -208, *HYPERELASTIC, NEO HOOKE of the same moduli -149, and a linear one -75.
# Seen: -28. *ELASTIC is the law of Saint Venant and Kirchhoff: from a height of 0.58 on the force goes down again, so that a cube
# at 0.3 needs less than one at 0.8, and one that carries more than 28.9 cannot stand. Stress over strain in the .dat file is not
# E, 150, but 129 at 0.9 and 24 at 0.2, as the one is that of Cauchy and the other that of Green, -0.48 for a shortening by 0.8.
# No warning. Take *HYPERELASTIC for soft particles.
#   height 0.99: force -1.48 for -1.50; stress -1.47, strain -0.010, ratio 148
#   height 0.90: force -12.82 for -15.00; stress -12.24, strain -0.095, ratio 129
#   height 0.80: force -21.60 for -30.00; stress -19.82, strain -0.180, ratio 110
#   height 0.70: force -26.77 for -45.00; stress -23.75, strain -0.255, ratio 93
#   height 0.60: force -28.80 for -60.00; stress -24.83, strain -0.320, ratio 78
#   height 0.50: force -28.12 for -75.00; stress -23.68, strain -0.375, ratio 63
#   height 0.40: force -25.20 for -90.00; stress -20.83, strain -0.420, ratio 50
#   height 0.30: force -20.48 for -105.00; stress -16.68, strain -0.455, ratio 37
#   height 0.20: force -14.40 for -120.00; stress -11.61, strain -0.480, ratio 24
set -euo pipefail
want=2.20-1
version=$(dpkg-query -W -f='${Version}' calculix-ccx 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs calculix-ccx $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
for height in 0.99 0.9 0.8 0.7 0.6 0.5 0.4 0.3 0.2; do
  cat > cube.inp <<INP
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
*NSET, NSET=TOP
5, 6, 7, 8
*NSET, NSET=BOTTOM
1, 2, 3, 4
*NSET, NSET=LEFT
1, 4, 5, 8
*NSET, NSET=FRONT
1, 2, 5, 6
*MATERIAL, NAME=SOFT
*ELASTIC
150, 0.25
*SOLID SECTION, ELSET=CUBE, MATERIAL=SOFT
*BOUNDARY
BOTTOM, 3, 3
LEFT, 1, 1
FRONT, 2, 2
*STEP, NLGEOM, INC=1000
*STATIC
0.05, 1, 1e-6, 0.05
*BOUNDARY
TOP, 3, 3, $(awk "BEGIN { print $height - 1 }")
*NODE PRINT, NSET=TOP, TOTALS=ONLY, FREQUENCY=1000
RF
*EL PRINT, ELSET=CUBE, FREQUENCY=1000
S, E
*END STEP
INP
  OMP_NUM_THREADS=1 ccx -i cube > messages 2>&1 || { cat messages; exit 1; }
  awk -v height="$height" '
    /total force/ { what = "force"; next }
    /stresses/ { what = "stress"; next }
    /strains/ { what = "strain"; next }
    NF == 3 && what == "force" { force = $3 }
    NF == 8 && !seen[what]++ { along[what] = $5 }
    END {
      printf "height %.2f: force %.2f for %.2f; stress %.2f, strain %.3f, ratio %.0f\n",
        height, force, 150 * (height - 1), along["stress"], along["strain"], along["stress"] / along["strain"]
    }' cube.dat
done > seen
cat seen
diff seen - <<'SEEN'
height 0.99: force -1.48 for -1.50; stress -1.47, strain -0.010, ratio 148
height 0.90: force -12.82 for -15.00; stress -12.24, strain -0.095, ratio 129
height 0.80: force -21.60 for -30.00; stress -19.82, strain -0.180, ratio 110
height 0.70: force -26.77 for -45.00; stress -23.75, strain -0.255, ratio 93
height 0.60: force -28.80 for -60.00; stress -24.83, strain -0.320, ratio 78
height 0.50: force -28.12 for -75.00; stress -23.68, strain -0.375, ratio 63
height 0.40: force -25.20 for -90.00; stress -20.83, strain -0.420, ratio 50
height 0.30: force -20.48 for -105.00; stress -16.68, strain -0.455, ratio 37
height 0.20: force -14.40 for -120.00; stress -11.61, strain -0.480, ratio 24
SEEN
