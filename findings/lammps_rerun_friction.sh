#!/usr/bin/env bash
# LAMMPS 20220106 (Debian 12: lammps 20220106.git7586adbb6a+ds1-2+b2): forces of a dump, by `rerun`, as one wants them afterwards: two
# grains overlap by 0.1 and slide past each other by 0.02 in 200 steps, without spin (gran/hooke/history, friction 10), dumped with
# positions and velocities of all digits.
#
# Guess: the forces of the dump, or an error or warning that the springs of contacts are not in it.
# Seen: springs do not stretch in a rerun, not even from one frame to the next where every step was dumped: all contacts are
# without friction. Here the force along y is -3.50 in the run and 2.22, that of the normal alone, in the rerun. Nothing is said
# of it, and normal forces are right, so that force chains look well. Dump the forces in the run.
#   force at step 200: 99.88 along x, -3.50 along y
#   rerun, a frame in 1 steps: 99.75 along x, 2.22 along y
#   rerun, a frame in 10 steps: 99.75 along x, 2.22 along y
set -euo pipefail
want=20220106.git7586adbb6a+ds1-2+b2
version=$(dpkg-query -W -f='${Version}' lammps 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs lammps $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
grains() {
  cat <<'LAMMPS'
units lj
dimension 2
newton off
atom_style sphere
atom_modify map yes
comm_modify vel yes
region cell block -2 2 -2 2 -0.5 0.5
create_box 1 cell
create_atoms 1 single -0.45 0 0
create_atoms 1 single 0.45 0 0
set group all diameter 1 density 1
pair_style gran/hooke/history 1000 NULL 0 NULL 10 0
pair_coeff * *
neighbor 0.5 bin
timestep 0.001
variable x equal fx[2]
variable y equal fy[2]
thermo_style custom step v_x v_y
LAMMPS
}
run() { # FILE
  lmp -in "$1" -log none > messages 2>&1 || { cat messages; exit 1; }
  if grep WARNING messages | grep -v 'No fixes'; then exit 1; fi
  awk '$1 == 200 && NF == 3 { printf "%.2f along x, %.2f along y\n", $2, $3 }' messages
}
{
  grains
  cat <<'LAMMPS'
group left id 1
group right id 2
fix left left move linear 0 0 0
fix right right move linear 0 0.1 0
dump 1 all custom 1 dump.1 id x y vx vy
dump 10 all custom 10 dump.10 id x y vx vy
dump_modify 1 format float %.17g
dump_modify 10 format float %.17g
run 200
LAMMPS
} > in.run
{
  echo "force at step 200: $(run in.run)"
  for every in 1 10; do
    { grains; echo "rerun dump.$every dump x y vx vy"; } > in.rerun
    echo "rerun, a frame in $every steps: $(run in.rerun)"
  done
} > seen
cat seen
diff seen - <<'SEEN'
force at step 200: 99.88 along x, -3.50 along y
rerun, a frame in 1 steps: 99.75 along x, 2.22 along y
rerun, a frame in 10 steps: 99.75 along x, 2.22 along y
SEEN
