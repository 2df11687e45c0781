#!/usr/bin/env bash
# LAMMPS 20220106 (Debian 12: lammps 20220106.git7586adbb6a+ds1-2+b2): a restart file of frictional grains (gran/hooke/history),
# read in a process that has had such a pair style before: after `clear`, as in a loop over parameters.
#
# Guess: the run goes on as it does where the file is read by a new process.
# Seen: a new process has the friction force of 1.41 again; after `clear` the springs of all contacts begin at zero, and it is
# 0.008. The history is stored under a name with a count of the pair styles of the process (NEIGH_HISTORY_HH0), which is then
# another one. "Unused restart file peratom fix info" in the output is the only sign. Start a process for each restart.
#   written: fx -82.4339 fy -1.4112
#   new process: fx -82.4339 fy -1.4112
#   after clear: fx -82.4341 fy -0.0083
set -euo pipefail
want=20220106.git7586adbb6a+ds1-2+b2
version=$(dpkg-query -W -f='${Version}' lammps 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs lammps $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > write.in <<'IN'
units lj
atom_style sphere
atom_modify map array
newton off
comm_modify vel yes
region cell block -5 5 -5 5 -5 5
create_box 1 cell
create_atoms 1 single 0.45 0 0
create_atoms 1 single 1.35 0 0
set type 1 diameter 1 density 1
set atom 1 omega 0 0 1 vx 0.1
pair_style gran/hooke/history 1000 300 0 0 10 1
pair_coeff * *
neighbor 0.3 bin
fix move all nve/sphere
timestep 0.001
run 10
write_restart history.restart
print "SEEN written: fx $(fx[1]:%.4f) fy $(fy[1]:%.4f)"
IN
read_on() {  # label, lines before
  printf '%s\n' "${@:2}" "read_restart history.restart" "comm_modify vel yes" "neighbor 0.3 bin" "fix move all nve/sphere" "run 0" \
    "print \"SEEN $1: fx \$(fx[1]:%.4f) fy \$(fy[1]:%.4f)\""
}
read_on "new process" > new.in
read_on "after clear" "newton off" "read_restart history.restart" clear "newton off" > clear.in
for part in write new clear; do
  lmp -in $part.in -log none -screen screen >/dev/null
  sed -n 's/^SEEN //p' screen
done > seen
cat seen
diff seen - <<'SEEN'
written: fx -82.4339 fy -1.4112
new process: fx -82.4339 fy -1.4112
after clear: fx -82.4341 fy -0.0083
SEEN
