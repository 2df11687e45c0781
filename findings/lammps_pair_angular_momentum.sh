#!/usr/bin/env bash
# LAMMPS 20220106 (Debian 12: lammps 20220106.git7586adbb6a+ds1-2+b2): two frictional grains of diameter 1 on their own, 0.9
# apart, that spin until they have parted; and the same two, turned about each other as one body (fix move rotate) by one
# radian.
#
# Guess: angular momentum stays; and where they turn as one body nothing slides, so there is no friction.
# Seen: gran/hooke, gran/hooke/history and gran/hertz/history lose 3 to 6 per cent of the angular momentum in this one contact:
# friction turns each grain at an arm of its radius, 0.5, and acts at 0.45. pair_style granular keeps it. But with all of them,
# granular as well, turning as one is friction of up to 0.4 of the normal force, as sliding is taken at the radius, where
# overlapping grains do slide (LIGGGHTS 3.8.0 and Yade 2023.02a have none). Both go with the overlap over the diameter: soft
# grains see them.
#   gran/hooke: angular momentum 0.935, friction turning as one 1.3 of normal 100.0
#   gran/hooke/history: angular momentum 0.963, friction turning as one 30.0 of normal 100.0
#   gran/hertz/history: angular momentum 0.968, friction turning as one 4.7 of normal 15.8
#   granular hooke linear_history: angular momentum 1.000, friction turning as one 30.0 of normal 100.0
#   granular hertz mindlin: angular momentum 1.000, friction turning as one 4.7 of normal 11.6
set -euo pipefail
want=20220106.git7586adbb6a+ds1-2+b2
version=$(dpkg-query -W -f='${Version}' lammps 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs lammps $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > pair.in <<'IN'
units lj
atom_style sphere
atom_modify map array
newton off
comm_modify vel yes
boundary f f f
region cell block -5 5 -5 5 -5 5
create_box 1 cell
create_atoms 1 single -0.45 0 0
create_atoms 1 single 0.45 0 0
set type 1 diameter 1 density 1
set type 1 omega 0 0 1
pair_style ${style}
pair_coeff * * ${coefficients}
neighbor 0.3 bin
timestep 0.0005
IN
cat pair.in - > spin.in <<'IN'
fix move all nve/sphere
compute omega all property/atom omegaz
variable each atom 0.1*mass*c_omega+mass*(x*vy-y*vx)
compute momentum all reduce sum v_each
thermo_style custom step c_momentum
run 0
variable start equal c_momentum
variable first equal ${start}
run 1000
print "SEEN angular momentum $(v_start/v_first:%.3f)"
IN
cat pair.in - > turn.in <<'IN'
fix move all move rotate 0 0 0 0 0 1 $(2*PI)
run 2000
variable along equal (fy[2]*x[2]-fx[2]*y[2])/0.45
variable normal equal (fx[2]*x[2]+fy[2]*y[2])/0.45
print "SEEN friction turning as one $(v_along:%.1f) of normal $(v_normal:%.1f)"
IN
while IFS='|' read -r label style coefficients; do
  run() { lmp -in "$1" -log none -var style "$style" -var coefficients "$coefficients" | sed -n 's/^SEEN //p'; }
  echo "$label: $(run spin.in), $(run turn.in)"
done > seen <<'CASES'
gran/hooke|gran/hooke 1000 300 0 50 10 1|
gran/hooke/history|gran/hooke/history 1000 300 0 0 10 1|
gran/hertz/history|gran/hertz/history 1000 300 0 0 10 1|
granular hooke linear_history|granular|hooke 1000 0 tangential linear_history 300 0 10
granular hertz mindlin|granular|hertz/material 1000 0 0.3 tangential mindlin 300 0 10
CASES
cat seen
diff seen - <<'SEEN'
gran/hooke: angular momentum 0.935, friction turning as one 1.3 of normal 100.0
gran/hooke/history: angular momentum 0.963, friction turning as one 30.0 of normal 100.0
gran/hertz/history: angular momentum 0.968, friction turning as one 4.7 of normal 15.8
granular hooke linear_history: angular momentum 1.000, friction turning as one 30.0 of normal 100.0
granular hertz mindlin: angular momentum 1.000, friction turning as one 4.7 of normal 11.6
SEEN
