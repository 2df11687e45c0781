#!/usr/bin/env bash
# LAMMPS 20220106 (Debian 12: lammps 20220106.git7586adbb6a+ds1-2+b2): shear by `fix deform`, and the forces of two discs that touch
# across the boundary.
#
# Guess: the forces that thermo and dump show are those of the positions and the cell (xy) of the same line.
# Seen: they are those of the cell one step before: the cell is deformed at the end of a step, after its forces. Discs held in
# place, whose contact is turned by the shear alone, have at xy = 0.12 the force that belongs to xy = 0.08. Stress and strain of
# one line so are a step apart, and a script that computes forces from a dump finds others. `run 0` brings them together.
#   xy 0.04: fx 0.0000 fy 100.0000, by the geometry 4.4006 99.0138
#   xy 0.08: fx 4.4006 fy 99.0138, by the geometry 8.5398 96.0726
#   xy 0.12: fx 8.5398 fy 96.0726, by the geometry 12.1637 91.2279
set -euo pipefail
want=20220106.git7586adbb6a+ds1-2+b2
version=$(dpkg-query -W -f='${Version}' lammps 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs lammps $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > shear.in <<'IN'
units lj
dimension 2
atom_style sphere
atom_modify map array
newton off
comm_modify vel yes
region cell prism 0 4 0 4 -0.5 0.5 0 0 0
create_box 1 cell
create_atoms 1 single 1 0.05 0
create_atoms 1 single 1 3.15 0
set type 1 diameter 1 density 1
pair_style gran/hooke 1000 0 0 0 0 0
pair_coeff * *
neighbor 0.3 bin
fix shear all deform 1 xy erate 10 remap none
timestep 0.001
variable distance equal sqrt(xy^2+0.9^2)
variable shown_x equal fx[1]
variable shown_y equal fy[1]
variable tilt equal xy
variable true_x equal 1000*(1-v_distance)*xy/v_distance
variable true_y equal 1000*(1-v_distance)*0.9/v_distance
thermo 1
thermo_style custom xy v_shown_x v_shown_y v_true_x v_true_y
thermo_modify format float %.4f
run 3
IN
lmp -in shear.in -log none -screen screen >/dev/null
awk 'seen && NF == 5 && $1 > 0 { printf "xy %.2f: fx %s fy %s, by the geometry %s %s\n", $1, $2, $3, $4, $5 }
     /^Xy / { seen = 1 } /^Loop/ { seen = 0 }' screen > seen
cat seen
diff seen - <<'SEEN'
xy 0.04: fx 0.0000 fy 100.0000, by the geometry 4.4006 99.0138
xy 0.08: fx 4.4006 fy 99.0138, by the geometry 8.5398 96.0726
xy 0.12: fx 8.5398 fy 96.0726, by the geometry 12.1637 91.2279
SEEN
