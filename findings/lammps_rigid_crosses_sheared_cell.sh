#!/usr/bin/env bash
# LAMMPS 20220106 (Debian 12: lammps 20220106.git7586adbb6a+ds1-2+b2): rigid clumps (fix rigid, fix rigid/nve) in a cell sheared
# by `fix deform ... remap v`, at rate 0.1 and height 10: what leaves through the top is back at the bottom, 1 slower along x.
#
# Guess: a clump is given the velocity of the flow at its other side as a single grain is, since `remap v` is made for this.
# Seen: a grain goes from 0.4 to -0.6, a clump keeps its 0.4, without a warning: after each crossing it is faster than what is
# around it by rate times height, which damping then turns into heat. Shear clumps between walls.
#   fix nve/sphere, remap v: vx 0.4 becomes -0.6 at y 8.0
#   fix rigid, remap v: vx 0.4 becomes 0.4 at y 8.0
#   fix rigid/nve, remap v: vx 0.4 becomes 0.4 at y 8.0
set -euo pipefail
want=20220106.git7586adbb6a+ds1-2+b2
version=$(dpkg-query -W -f='${Version}' lammps 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs lammps $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > cross.in <<'IN'
units lj
dimension 2
atom_style sphere
atom_modify map array
newton off
comm_modify vel yes
region cell prism 0 10 0 10 -0.5 0.5 0 0 0
create_box 1 cell
create_atoms 1 single 5 8 0
create_atoms 1 single 5.5 8.3 0
create_atoms 1 single 5 8.6 0
set type 1 diameter 1
pair_style zero 1
pair_coeff * *
velocity all set 0.4 1 0
fix move all ${style}
fix plane all enforce2d
fix shear all deform 1 xy erate 0.1 remap v
timestep 0.01
thermo_style custom step xy
thermo_modify lost error
run 1000
print "SEEN fix $(v_label), remap v: vx 0.4 becomes $(vx[1]:%.1f) at y $(y[1]:%.1f)"
IN
for style in nve/sphere "rigid single" "rigid/nve single"; do
  sed "s|\$(v_label)|${style% *}|" cross.in > run.in
  lmp -in run.in -log none -var style "$style" | sed -n 's/^SEEN //p'
done > seen
cat seen
diff seen - <<'SEEN'
fix nve/sphere, remap v: vx 0.4 becomes -0.6 at y 8.0
fix rigid, remap v: vx 0.4 becomes 0.4 at y 8.0
fix rigid/nve, remap v: vx 0.4 becomes 0.4 at y 8.0
SEEN
