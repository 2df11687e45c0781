#!/usr/bin/env bash
# LAMMPS 20220106 (Debian 12: lammps 20220106.git7586adbb6a+ds1-2+b2): `pair_style granular` and `fix wall/gran granular` with
# hertz/material and mindlin, whose stiffness is that of the material, E = 1e6: a grain of radius 0.5 that overlaps by 0.01 with a
# grain like itself, with one of radius 50, and with a plate (zplane, and a region); the force over that of Hertz,
# 4/3 E' sqrt(R') overlap^1.5, where E' = E / (2 (1 - ratio^2)) for two bodies of one material and R' = 0.5 for a plate, and the
# tangential stiffness over that of Mindlin.
#
# Guess: 1 for each; or twice as much from plates, if they are taken for rigid ones.
# Seen: 1 between grains. From a plate the force is 1 + ratio times that of Hertz, 1.3 for a ratio of 0.3 and 1.5 for a material
# that keeps its volume, and the friction springs, which NULL has made from the material, are 0.50 to 0.63 of those of Mindlin.
# So a grain between plates is another than between two large grains, with half or less of its friction spring per force. For a
# plate of the same material give the wall E / (1 + ratio) and 2 E / ((1 + ratio) (2 - ratio)) for NULL, as in the last lines.
#   ratio 0, grain: force 1.000, stiffness 1.000
#   ratio 0, grain of radius 50: force 1.000, stiffness 1.000
#   ratio 0, plate: force 1.000, stiffness 0.500
#   ratio 0, region: force 1.000, stiffness 0.500
#   ratio 0, plate, converted: force 1.000, stiffness 1.000
#   ratio 0.3, grain: force 1.000, stiffness 1.000
#   ratio 0.3, grain of radius 50: force 1.000, stiffness 1.000
#   ratio 0.3, plate: force 1.300, stiffness 0.611
#   ratio 0.3, region: force 1.300, stiffness 0.611
#   ratio 0.3, plate, converted: force 1.000, stiffness 1.000
#   ratio 0.5, grain: force 1.000, stiffness 1.000
#   ratio 0.5, grain of radius 50: force 1.000, stiffness 1.000
#   ratio 0.5, plate: force 1.500, stiffness 0.633
#   ratio 0.5, region: force 1.500, stiffness 0.633
#   ratio 0.5, plate, converted: force 1.000, stiffness 1.000
set -euo pipefail
want=20220106.git7586adbb6a+ds1-2+b2
version=$(dpkg-query -W -f='${Version}' lammps 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs lammps $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
show() { # RATIO NAME R', then the commands that make what is below the grain, one for atoms and one for walls
  cat > contact.in <<IN
units si
atom_style sphere
atom_modify map array
newton off
comm_modify vel yes
boundary f f f
region cell block -60 60 -60 60 -101 10
create_box 1 cell
create_atoms 1 single 0 0 0.49
set atom 1 diameter 1 density 1000
$4
pair_style granular
pair_coeff * * hertz/material 1e6 0 $1 tangential mindlin NULL 1 0.5 damping mass_velocity
$5
variable force equal fz[1]
variable friction equal fx[1]
velocity all set 0 0 0
set atom 1 vx 1e-3
timestep 1e-3
thermo_style custom step v_force v_friction
run 1
variable hertz equal 4/3*1e6/(2*(1-$1^2))*sqrt($3)*0.01^1.5
variable mindlin equal 4*1e6/(2*(1+$1))/(2-$1)*sqrt($3*0.01)*1e-6
print "SEEN ratio $1, $2: force \$(v_force/v_hertz:%.3f), stiffness \$(-v_friction/v_mindlin:%.3f)"
IN
  lmp -in contact.in -log none > messages 2>&1 || { cat messages; exit 1; }
  sed -n 's/^SEEN //p' messages
}
for ratio in 0 0.3 0.5; do
  model="granular hertz/material 1e6 0 $ratio tangential mindlin NULL 1 0.5 damping mass_velocity"
  show $ratio "grain" 0.25 $'create_atoms 1 single 0 0 -0.5\nset atom 2 diameter 1 density 1000' ""
  show $ratio "grain of radius 50" "0.5*50/50.5" $'create_atoms 1 single 0 0 -50\nset atom 2 diameter 100 density 1000' ""
  show $ratio "plate" 0.5 "" "fix plate all wall/gran $model zplane 0 NULL"
  show $ratio "region" 0.5 "region below block -9 9 -9 9 0 9" "fix plate all wall/gran/region $model region below"
  wall=$(awk "BEGIN { print 1e6 / (1 + $ratio) }") spring=$(awk "BEGIN { print 2e6 / ((1 + $ratio) * (2 - $ratio)) }")
  model="granular hertz/material $wall 0 $ratio tangential mindlin $spring 1 0.5 damping mass_velocity"
  show $ratio "plate, converted" 0.5 "" "fix plate all wall/gran $model zplane 0 NULL"
done > seen
cat seen
diff seen - <<'SEEN'
ratio 0, grain: force 1.000, stiffness 1.000
ratio 0, grain of radius 50: force 1.000, stiffness 1.000
ratio 0, plate: force 1.000, stiffness 0.500
ratio 0, region: force 1.000, stiffness 0.500
ratio 0, plate, converted: force 1.000, stiffness 1.000
ratio 0.3, grain: force 1.000, stiffness 1.000
ratio 0.3, grain of radius 50: force 1.000, stiffness 1.000
ratio 0.3, plate: force 1.300, stiffness 0.611
ratio 0.3, region: force 1.300, stiffness 0.611
ratio 0.3, plate, converted: force 1.000, stiffness 1.000
ratio 0.5, grain: force 1.000, stiffness 1.000
ratio 0.5, grain of radius 50: force 1.000, stiffness 1.000
ratio 0.5, plate: force 1.500, stiffness 0.633
ratio 0.5, region: force 1.500, stiffness 0.633
ratio 0.5, plate, converted: force 1.000, stiffness 1.000
SEEN
