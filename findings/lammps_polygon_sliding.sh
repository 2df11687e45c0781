#!/usr/bin/env bash
# LAMMPS 20220106 (Debian 12: lammps 20220106.git7586adbb6a+ds1-2+b2): a rounded square that slides along the side of another, at
# one depth, without friction and damping (pair_style body/rounded/polygon).
#
# Guess: the force is along the normal of the sides and changes little, as two corners lie in each other's side all the way.
# Seen: from 20 in the middle it goes to 50 as the corners come near each other, with a force of 5 along the sides, and falls to 40
# where they meet: corners count with the sides beside them, each as a contact of its own. Flat sides are bumpy, and resist
# sliding without friction.
#   shift 0, skin 2.0: fx 40.00 fy 0.00
#   shift 0.01, skin 2.0: fx 49.98 fy 0.33
#   shift 0.2, skin 2.0: fx 42.86 fy 5.08
#   shift 0.5, skin 2.0: fx 20.00 fy 0.00
#   shift 1.5, skin 2.0: fx 20.00 fy 0.00
#   shift 1.9, skin 2.0: fx 29.39 fy -1.04
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
for shift in 0 0.01 0.2 0.5 1.5 1.9; do force $shift 2.0; done > seen
cat seen
diff seen - <<'SEEN'
shift 0, skin 2.0: fx 40.00 fy 0.00
shift 0.01, skin 2.0: fx 49.98 fy 0.33
shift 0.2, skin 2.0: fx 42.86 fy 5.08
shift 0.5, skin 2.0: fx 20.00 fy 0.00
shift 1.5, skin 2.0: fx 20.00 fy 0.00
shift 1.9, skin 2.0: fx 29.39 fy -1.04
SEEN
