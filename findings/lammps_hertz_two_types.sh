#!/usr/bin/env bash
# LAMMPS 20220106 (Debian 12: lammps 20220106.git7586adbb6a+ds1-2+b2), `pair_style granular` with hertz/material and mindlin: two
# grains of radius 0.5 and of two types, whose coefficients are given for all pairs at once (pair_coeff * *), or for each type
# (pair_coeff 1 1 and 2 2), so that those of 1 2 are mixed, as the manual describes. Force over that of Hertz, and the
# tangential stiffness over that of Mindlin, with 1 / E' = (1 - ratio^2) (1 / E1 + 1 / E2).
#
# Guess: 1 for each, as both types are of one material but for the last lines, where one is a thousand times as hard.
# Seen: given for all pairs it is 1. A mixed contact has linear springs, whose constants are those of the law without the radius
# of the contact: 20 times too stiff at an overlap of 0.01 and 10 times at 0.04, in friction as well. Of moduli of 1e6 and 1e9 the
# mean is the geometric one, 317 times too stiff. No warning. Give pair_coeff 1 2, too, with 2 E1 E2 / (E1 + E2) where the ratios
# are equal, as in the last lines.
#   for all, overlap 0.01: force 1.00, stiffness 1.00
#   for each type, overlap 0.01: force 20.00, stiffness 20.00
#   soft on hard, for each type, overlap 0.01: force 316.54, stiffness 316.54
#   soft on hard, with 1 2, overlap 0.01: force 1.00, stiffness 1.00
#   for all, overlap 0.04: force 1.00, stiffness 1.00
#   for each type, overlap 0.04: force 10.00, stiffness 10.00
#   soft on hard, for each type, overlap 0.04: force 158.27, stiffness 158.27
#   soft on hard, with 1 2, overlap 0.04: force 1.00, stiffness 1.00
set -euo pipefail
want=20220106.git7586adbb6a+ds1-2+b2
version=$(dpkg-query -W -f='${Version}' lammps 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs lammps $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
show() { # NAME OVERLAP HARDER COEFFICIENTS
  cat > contact.in <<IN
units si
atom_style sphere
atom_modify map array
newton off
comm_modify vel yes
boundary f f f
region cell block -5 5 -5 5 -5 5
create_box 2 cell
variable place equal 0.5-$2
create_atoms 1 single 0 0 \${place}
create_atoms 2 single 0 0 -0.5
set type * diameter 1 density 1000
pair_style granular
$4
velocity all set 0 0 0
set atom 1 vx 1e-3
timestep 1e-3
variable force equal fz[1]
variable friction equal fx[1]
thermo_style custom step v_force v_friction
run 1
variable both equal 1e6/(1+1/$3)
variable hertz equal 4/3*v_both/(1-0.3^2)*sqrt(0.25)*$2^1.5
variable mindlin equal 4*v_both/1.3/1.7*sqrt(0.25*$2)*1e-6
print "SEEN $1, overlap $2: force \$(v_force/v_hertz:%.2f), stiffness \$(-v_friction/v_mindlin:%.2f)"
IN
  lmp -in contact.in -log none > messages 2>&1 || { cat messages; exit 1; }
  sed -n 's/^SEEN //p' messages
}
law() { echo "hertz/material $1 0 0.3 tangential mindlin NULL 1 0.5 damping mass_velocity"; }
all="pair_coeff * * $(law 1e6)"
each="pair_coeff 1 1 $(law 1e6)"$'\n'"pair_coeff 2 2 $(law 1e6)"
hard="pair_coeff 1 1 $(law 1e6)"$'\n'"pair_coeff 2 2 $(law 1e9)"
for overlap in 0.01 0.04; do
  show "for all" $overlap 1 "$all"
  show "for each type" $overlap 1 "$each"
  show "soft on hard, for each type" $overlap 1000 "$hard"
  show "soft on hard, with 1 2" $overlap 1000 "$hard"$'\n'"pair_coeff 1 2 $(law 1.998002e6)"
done > seen
cat seen
diff seen - <<'SEEN'
for all, overlap 0.01: force 1.00, stiffness 1.00
for each type, overlap 0.01: force 20.00, stiffness 20.00
soft on hard, for each type, overlap 0.01: force 316.54, stiffness 316.54
soft on hard, with 1 2, overlap 0.01: force 1.00, stiffness 1.00
for all, overlap 0.04: force 1.00, stiffness 1.00
for each type, overlap 0.04: force 10.00, stiffness 10.00
soft on hard, for each type, overlap 0.04: force 158.27, stiffness 158.27
soft on hard, with 1 2, overlap 0.04: force 1.00, stiffness 1.00
SEEN
