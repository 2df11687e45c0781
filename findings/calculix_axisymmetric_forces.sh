#!/usr/bin/env bash
# CalculiX 2.20 (Debian 12: calculix-ccx 2.20-1): a soft ring, inner radius 1, outer 2, height 1, E = 1000, nu = 0, of one
# axisymmetric element (CAX4), stretched by 1%. The stress is 10, the force 10 times the area 3 pi: 94.25.
#
# Guess: 94.25 on the nodes (*CLOAD) stretches it by 1%, and where it is stretched by 1% the nodes show (RF) 94.25.
# Seen: the first is so, forces that are given are those of the whole ring. Forces that are printed, reactions and their totals
# alike, are those of a wedge of two degrees: 180 times too small, in one and the same output file. So are volumes and energies
# of *EL PRINT, and a sphere pressed into a soft block seems 180 times softer. No word of it. Multiply by 180, or integrate the
# stress, which is right.
#   force: stretched by 0.010, stress 10.00, reaction 0.524, volume 0.0523, energy 0.00262
#   stretch: stretched by 0.010, stress 10.00, reaction 0.523, volume 0.0523, energy 0.00262
#   whole ring: stretched by 0.010, stress 10.00, reaction 94.248, volume 9.4248, energy 0.47124
set -euo pipefail
want=2.20-1
version=$(dpkg-query -W -f='${Version}' calculix-ccx 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs calculix-ccx $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
write() { # NAME, what is done to the upper side on standard input
  cat > "$1.inp" <<'INP'
*NODE, NSET=ALL
1, 1, 0
2, 2, 0
3, 2, 1
4, 1, 1
*ELEMENT, TYPE=CAX4, ELSET=RING
1, 1, 2, 3, 4
*NSET, NSET=BELOW
1, 2
*NSET, NSET=ABOVE
3, 4
*MATERIAL, NAME=SOFT
*ELASTIC
1000, 0
*SOLID SECTION, ELSET=RING, MATERIAL=SOFT
*STEP
*STATIC
*BOUNDARY
BELOW, 2, 2
INP
  cat >> "$1.inp"
  cat >> "$1.inp" <<'INP'
*NODE PRINT, NSET=ABOVE
U
*NODE PRINT, NSET=BELOW, TOTALS=ONLY
RF
*EL PRINT, ELSET=RING
S
*EL PRINT, ELSET=RING, TOTALS=ONLY
EVOL, ELSE
*END STEP
INP
  ccx "$1" > messages 2>&1 || { cat messages; exit 1; }
}
show() { # NAME, from the tables of NAME.dat
  awk -v name="$1" '
    NF == 0 { next }
    /^ *[a-z]/ { table = $1 " " $2; next }
    table ~ /^displacements/ { up = $3 }
    table ~ /^total force/ { force = -$2 }
    table ~ /^stresses/ { stress = $4 }
    table ~ /^total volume/ { volume = $1 }
    table ~ /^total internal/ { energy = $1 }
    END { printf "%s: stretched by %.3f, stress %.2f, reaction %.3f, volume %.4f, energy %.5f\n", name, up, stress, force, volume, energy }
  ' "$1.dat"
}
# shares of the two circles in the force of a uniform stress: 5 pi / 3 and 4 pi / 3
write force <<'INP'
*CLOAD
3, 2, 52.35988
4, 2, 41.88790
INP
write stretch <<'INP'
*BOUNDARY
ABOVE, 2, 2, 0.01
INP
{
  show force
  show stretch
  /usr/bin/python3 -c 'from math import pi
print(f"whole ring: stretched by 0.010, stress 10.00, reaction {30 * pi:.3f}, volume {3 * pi:.4f}, energy {0.15 * pi:.5f}")'
} > seen
cat seen
diff seen - <<'SEEN'
force: stretched by 0.010, stress 10.00, reaction 0.524, volume 0.0523, energy 0.00262
stretch: stretched by 0.010, stress 10.00, reaction 0.523, volume 0.0523, energy 0.00262
whole ring: stretched by 0.010, stress 10.00, reaction 94.248, volume 9.4248, energy 0.47124
SEEN
