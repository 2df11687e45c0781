#!/usr/bin/env bash
# LAMMPS 20220106 (Debian 12: lammps 20220106.git7586adbb6a+ds1-2+b2): a plate that oscillates, fix wall/gran with wiggle z 0.05 1.0
# (amplitude, period), under a grain held in place 0.51 above it: the force on the grain, in one run of 1000 steps of 0.001, and in one
# that goes on from a restart file of step 250.
#
# Guess: the same forces, as the step is in the file, or an error that the phase of the plate is not.
# Seen: the plate starts at the bottom of its way again, with the step at which the file was read for time 0: at step 250 it jumps by its
# amplitude, the force from 40 to 0, and is a quarter of a period late from then on. No warning; the fix says of itself that it writes
# to restart files, which is its friction. In one process, "run 250" and "run 750" go on as they should.
#   one run: 0: 0, 250: 40, 500: 90, 750: 40, 1000: 0
#   two runs: 0: 0, 250: 40, 250: 40, 500: 90, 750: 40, 1000: 0
#   from the restart file: 250: 0, 500: 40, 750: 90, 1000: 40
set -euo pipefail
want=20220106.git7586adbb6a+ds1-2+b2
version=$(dpkg-query -W -f='${Version}' lammps 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs lammps $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
grain() {
  cat <<'LAMMPS'
units lj
atom_style sphere
comm_modify vel yes
newton off
boundary p p f
region cell block 0 4 0 4 0 4
create_box 1 cell
create_atoms 1 single 2 2 0.51
set type 1 diameter 1 density 1
LAMMPS
}
plate() {
  cat <<'LAMMPS'
pair_style gran/hooke/history 1000 NULL 0 NULL 0.5 0
pair_coeff * *
timestep 0.001
fix held all move linear 0 0 0
fix plate all wall/gran hooke/history 1000 NULL 0 NULL 0.5 0 zplane 0 NULL wiggle z 0.05 1.0
variable force equal fcm(all,z)
thermo_style custom step v_force
thermo 250
LAMMPS
}
show() { # NAME FILE
  lmp -in "$2" -log none > messages 2>&1 || { cat messages; exit 1; }
  if grep WARNING messages; then exit 1; fi
  awk -v name="$1" '/^Step/ { inside = 1; next } /^Loop/ { inside = 0 } inside { out = out sprintf(", %d: %.0f", $1, $2) }
    END { print name ": " substr(out, 3) }' messages
}
{ grain; plate; echo run 1000; } > in.one
{ grain; plate; printf 'run 250\nwrite_restart half\nrun 750\n'; } > in.two
{ printf 'read_restart half\ncomm_modify vel yes\n'; plate; echo run 750; } > in.rest
{
  show "one run" in.one
  show "two runs" in.two
  show "from the restart file" in.rest
} > seen
cat seen
diff seen - <<'SEEN'
one run: 0: 0, 250: 40, 500: 90, 750: 40, 1000: 0
two runs: 0: 0, 250: 40, 250: 40, 500: 90, 750: 40, 1000: 0
from the restart file: 250: 0, 500: 40, 750: 90, 1000: 40
SEEN
