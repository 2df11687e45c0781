#!/usr/bin/env bash
# LAMMPS 20220106 (Debian 12: lammps 20220106.git7586adbb6a+ds1-2+b2): oscillatory shear by `fix deform ... xy wiggle 2 8`
# (amplitude 2, period 8), in one run or in several with output between them.
#
# Guess: the tilt at time t is 2 sin(2 pi t / 8), however the steps are divided among `run` commands, as the fix stays the same.
# Seen: each run begins a new oscillation from the tilt it finds, at its full rate: after runs to 1.5 and 2.2 the tilt is 2.89,
# beyond the amplitude, and not 1.98; after four runs of a quarter period it is 8, a mean strain that grows. Velocities given to
# what crosses jump with it. `run 2200 every 500` counts as parts too, and so does a restart file. `run ... start 0` cures it
# within one process; across restarts run whole periods.
#   one run to 2.2: tilt 1.98
#   runs to 1.5 and 2.2: tilt 2.89
#   one run with every 500 to 2.2: tilt 3.37
#   runs to 1.5 and 2.2 with start 0: tilt 1.98
#   four runs of a quarter period: tilt 8.00
#   restart file at 1.5, on to 2.2: tilt 2.89
set -euo pipefail
want=20220106.git7586adbb6a+ds1-2+b2
version=$(dpkg-query -W -f='${Version}' lammps 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs lammps $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > start.in <<'IN'
units lj
dimension 2
atom_style sphere
box tilt large
region cell prism 0 10 0 10 -0.5 0.5 0 0 0
create_box 1 cell
create_atoms 1 single 5 5 0
set type 1 diameter 1 density 1
IN
cat > shear.in <<'IN'
pair_style zero 1
pair_coeff * *
comm_modify vel yes
fix move all nve/sphere
fix shear all deform 1 xy wiggle 2 8 remap v flip no
timestep 0.001
thermo_style custom step xy
IN
tilt() {  # label, commands that begin, lines that run
  { cat "$2" shear.in; printf '%s\n' "${@:3}" "print \"SEEN $1: tilt \$(xy:%.2f)\""; } > all.in
  lmp -in all.in -log none | sed -n 's/^SEEN //p'
}
echo "box tilt large
read_restart shear.restart" > again.in
{
  tilt "one run to 2.2" start.in "run 2200"
  tilt "runs to 1.5 and 2.2" start.in "run 1500" "write_restart shear.restart" "run 700"
  tilt 'one run with every 500 to 2.2' start.in "run 2200 every 500 NULL"
  tilt "runs to 1.5 and 2.2 with start 0" start.in "run 1500" "run 700 start 0"
  tilt "four runs of a quarter period" start.in "run 2000" "run 2000" "run 2000" "run 2000"
  tilt "restart file at 1.5, on to 2.2" again.in "run 700"
} > seen
cat seen
diff seen - <<'SEEN'
one run to 2.2: tilt 1.98
runs to 1.5 and 2.2: tilt 2.89
one run with every 500 to 2.2: tilt 3.37
runs to 1.5 and 2.2 with start 0: tilt 1.98
four runs of a quarter period: tilt 8.00
restart file at 1.5, on to 2.2: tilt 2.89
SEEN
