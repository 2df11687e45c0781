#!/usr/bin/env bash
# LIGGGHTS 3.8.0 (Debian 12: liggghts 3.8.0+repack1-9+b2): contacts across the periodic boundary of a triclinic cell, as one needs
# for homogeneous shear.
#
# Guess: two grains that overlap across the boundary repel each other, in a cell made by `region prism` as in one by `region
# block`; or triclinic cells are refused.
# Seen: in a prism, sheared or not, they go through each other, without an error or a warning: the contacts across all three
# boundaries are missing, and those inside are there. A sheared packing so leaks, and its pressure is too low. (LAMMPS, of which
# it is a branch, has them.)
#   block, inside: force 11582.8
#   block, across: force 11582.8
#   prism 0, inside: force 11582.8
#   prism 0, across: force 0
#   prism 3, inside: force 11582.8
#   prism 3, across: force 0
set -euo pipefail
want=3.8.0+repack1-9+b2
version=$(dpkg-query -W -f='${Version}' liggghts 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs liggghts $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
force() {  # label, region, second grain
  cat > two.in <<IN
units si
soft_particles yes
atom_style granular
boundary p p p
newton off
communicate single vel yes
region cell $2 units box
create_box 1 cell
neighbor 0.3 bin
neigh_modify delay 0
fix m1 all property/global youngsModulus peratomtype 1e6
fix m2 all property/global poissonsRatio peratomtype 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.5
fix m4 all property/global coefficientFriction peratomtypepair 1 0.5
pair_style gran model hertz tangential history
pair_coeff * *
timestep 1e-5
create_atoms 1 single 5 0.2 5 units box
create_atoms 1 single $3 units box
set type 1 density 1000 diameter 1
fix move all nve/sphere
dump each all custom 1 two.dump id fy
dump_modify each sort id
run 1
IN
  liggghts -in two.in > screen 2>&1
  ! grep -E '^(ERROR|WARNING)' screen
  echo "$1: force $(tail -1 two.dump | awk '{print $2 < 0 ? -$2 : $2 + 0}')"
}
{
  force "block, inside" "block 0 10 0 10 0 10" "5 1.1 5"
  force "block, across" "block 0 10 0 10 0 10" "5 9.3 5"
  force "prism 0, inside" "prism 0 10 0 10 0 10 0 0 0" "5 1.1 5"
  force "prism 0, across" "prism 0 10 0 10 0 10 0 0 0" "5 9.3 5"
  force "prism 3, inside" "prism 0 10 0 10 0 10 3 0 0" "5 1.1 5"
  force "prism 3, across" "prism 0 10 0 10 0 10 3 0 0" "8 9.3 5"
} > seen
cat seen
diff seen - <<'SEEN'
block, inside: force 11582.8
block, across: force 11582.8
prism 0, inside: force 11582.8
prism 0, across: force 0
prism 3, inside: force 11582.8
prism 3, across: force 0
SEEN
