#!/usr/bin/env bash
# LAMMPS 20220106 (Debian 12: lammps 20220106.git7586adbb6a+ds1-2+b2): shear pressure of a frictional contact.
#
# Guess: the xy component of `compute pressure` is symmetric in x and y, so that turning a pair by 90 degrees changes its
# sign at most.
# Seen: two overlapping spheres, one of them spinning (pair_style gran/hooke), have pxy = 0.00471 with their centres along
# x and 0 along y: pxy is the sum of r_x F_y alone. With friction r_x F_y and r_y F_x differ for each contact until
# torques balance, and none of pressure, stress/atom and the thermo output holds the second. Compare shear stresses of two
# codes in a steady state, or sum r_y F_x from the pairs (compute pair/local, fx + p1) as well.
#   along x: pxx 0.09 pyy 0 pxy 0.00471238898
#   along y: pxx 0 pyy 0.09 pxy 0
set -euo pipefail
want=20220106.git7586adbb6a+ds1-2+b2
version=$(dpkg-query -W -f='${Version}' lammps 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs lammps $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
for axis in x y; do
  if [ $axis = x ]; then at="0.45 0 0" beside="1.35 0 0"; else at="0 0.45 0" beside="0 1.35 0"; fi
  cat > "$axis.in" <<IN
units lj
atom_style sphere
newton off
comm_modify vel yes
region cell block -5 5 -5 5 -5 5
create_box 1 cell
create_atoms 1 single $at
create_atoms 1 single $beside
set type 1 diameter 1 density 1
set type 1 omega 0 0 1
pair_style gran/hooke 1000 300 50 20 10 1
pair_coeff * *
neighbor 0.3 bin
fix move all nve/sphere
compute p all pressure NULL virial
thermo_style custom c_p[1] c_p[2] c_p[4]
thermo_modify format float %.9g
run 0
IN
  lmp -in "$axis.in" -log none -screen "$axis.out" >/dev/null
  read -r xx yy xy < <(grep -A1 'c_p\[1\] c_p' "$axis.out" | tail -1)
  echo "along $axis: pxx $xx pyy $yy pxy $xy"
done > seen
cat seen
diff seen - <<'SEEN'
along x: pxx 0.09 pyy 0 pxy 0.00471238898
along y: pxx 0 pyy 0.09 pxy 0
SEEN
