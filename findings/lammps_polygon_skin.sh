#!/usr/bin/env bash
# LAMMPS 20220106 (Debian 12: lammps 20220106.git7586adbb6a+ds1-2+b2): contacts of rounded polygons (atom_style body rounded/polygon,
# pair_style body/rounded/polygon), and the skin of the neighbour list.
#
# Guess: the skin decides how often the list is built, not which bodies touch.
# Seen: the list is made for the circles through the corners alone: the rounding and the cutoff of the pair style are left out.
# Two squares of side 2, rounded by 0.5, whose sides overlap by 0.1, have no force with a skin of 0.1 once they are shifted by
# 0.5, or with one of 0.5 once they are shifted by 1.7, and go through each other, without a word. The skin must be as large as
# the diameter of the rounding at least, here 1.
#   shift 0.5, skin 0.1: fx 0.00 fy 0.00
#   shift 0.5, skin 0.5: fx 20.00 fy 0.00
#   shift 0.5, skin 1.0: fx 20.00 fy 0.00
#   shift 1.7, skin 0.1: fx 0.00 fy 0.00
#   shift 1.7, skin 0.5: fx 0.00 fy 0.00
#   shift 1.7, skin 1.0: fx 24.87 fy -1.62
set -euo pipefail
want=20220106.git7586adbb6a+ds1-2+b2
version=$(dpkg-query -W -f='${Version}' lammps 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs lammps $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
square=$'1 19\n4\n1 1 4 0 0 0\n-1 -1 0\n1 -1 0\n1 1 0\n-1 1 0\n1.0'  # side 2, rounded by 0.5
force() {  # shift of the second square along the side, skin
  cat > two.data <<DATA
two squares

2 atoms
2 bodies
1 atom types
-20 20 xlo xhi
-20 20 ylo yhi
-0.5 0.5 zlo zhi

Atoms

1 1 1 1 0 0 0
2 1 1 1 2.9 $1 0

Bodies

1 $square
2 $square
DATA
  cat > two.in <<IN
units lj
dimension 2
atom_modify map array
atom_style body rounded/polygon 1 8
read_data two.data
pair_style body/rounded/polygon 0 0 0 1.0 0.5
pair_coeff * * 100 0
comm_modify vel yes cutoff 12
neighbor $2 bin
fix move all nve/body
fix flat all enforce2d
run 0
print "SEEN shift $1, skin $2: fx \$(fx[2]:%.2f) fy \$(fy[2]:%.2f)"
IN
  lmp -in two.in -log none -screen screen >/dev/null
  sed -n "s/^SEEN //p" screen | sed -E "s/-0\.00/0.00/g"
}
for shift in 0.5 1.7; do for skin in 0.1 0.5 1.0; do force $shift $skin; done; done > seen
cat seen
diff seen - <<'SEEN'
shift 0.5, skin 0.1: fx 0.00 fy 0.00
shift 0.5, skin 0.5: fx 20.00 fy 0.00
shift 0.5, skin 1.0: fx 20.00 fy 0.00
shift 1.7, skin 0.1: fx 0.00 fy 0.00
shift 1.7, skin 0.5: fx 0.00 fy 0.00
shift 1.7, skin 1.0: fx 24.87 fy -1.62
SEEN
