#!/usr/bin/env bash
# LAMMPS 20220106 (Debian 12: lammps 20220106.git7586adbb6a+ds1-2+b2): grains that grow, by `fix adapt ... diameter`, from 1 to
# 2 until they overlap, as packings are compressed: two grains 1.9 apart, held in place, atom_style sphere 1.
#
# Guess: they push each other from diameter 1.9 on, at least where the neighbour list is built at each step.
# Seen: no force at diameter 2 and overlap 0.1, with "Dangerous builds = 0": the list is built where grains have moved by half
# the skin, and these do not move. Built at each step it still reaches as far as the diameters at the start of the run did, up
# to the bins that they were sorted into: grains at 4 and 5.9 push each other, those at 5 and 6.9 do not. A `run 0` after it has
# the force of 100. Make the skin as large as the growth, or run in parts.
#   at 5, skin 0.3, list as needed: built 0 times, force 0, in a run 0 after it -100
#   at 5, skin 0.3, list each step: built 1000 times, force 0, in a run 0 after it -100
#   at 4, skin 0.3, list each step: built 1000 times, force -100, in a run 0 after it -100
#   at 5, skin 1.2, list as needed: built 0 times, force -100, in a run 0 after it -100
set -euo pipefail
want=20220106.git7586adbb6a+ds1-2+b2
version=$(dpkg-query -W -f='${Version}' lammps 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs lammps $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
grow() {  # where, skin, check
  cat > grow.in <<IN
units lj
dimension 2
atom_style sphere 1
atom_modify map array
newton off
comm_modify vel yes
region cell block 0 10 0 10 -0.5 0.5
create_box 1 cell
create_atoms 1 single $1 5 0
create_atoms 1 single \$($1+1.9) 5 0
set type 1 diameter 1 density 1
pair_style gran/hooke 1000 0 0 0 0 0
pair_coeff * *
neighbor $2 bin
neigh_modify every 1 delay 0 check $3
variable d equal 1+step/1000
fix grow all adapt 1 atom diameter v_d
fix hold all move linear 0 0 0
timestep 0.001
thermo_style custom step
run 1000
print "FORCE \$(fx[1]:%.0f)"
run 0
print "FORCE \$(fx[1]:%.0f)"
IN
  lmp -in grow.in -log none -screen screen
  when="each step"
  [ "$3" = no ] || when="as needed"
  built=$(awk '/^Neighbor list builds/ { print $5; exit }' screen)
  echo "at $1, skin $2, list $when: built $built times, force $(awk '/^FORCE/ { print $2 }' screen | paste -sd' ' |
    sed 's/ /, in a run 0 after it /')"
}
{
  grow 5 0.3 yes
  grow 5 0.3 no
  grow 4 0.3 no
  grow 5 1.2 yes
} > seen
cat seen
diff seen - <<'SEEN'
at 5, skin 0.3, list as needed: built 0 times, force 0, in a run 0 after it -100
at 5, skin 0.3, list each step: built 1000 times, force 0, in a run 0 after it -100
at 4, skin 0.3, list each step: built 1000 times, force -100, in a run 0 after it -100
at 5, skin 1.2, list as needed: built 0 times, force -100, in a run 0 after it -100
SEEN
