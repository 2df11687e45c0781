#!/usr/bin/env bash
# LAMMPS 20220106 (Debian 12: lammps 20220106.git7586adbb6a+ds1-2+b2): a restart file of two frictional grains of pair_style
# granular, read by a new process, which "restores" that style from the file.
#
# Guess: the run goes on with the same forces, as with gran/hooke/history, whose style comes from the file in the same way.
# Seen: the springs of friction begin at zero, with linear_history and mindlin; with mindlin_rescale it is an error. "Unused
# restart file peratom fix info" among the output is the only sign. Where pair_style and pair_coeff are given again after
# read_restart, all springs are there.
#   gran/hooke/history: fy -0.04999, read -0.04999, style given again -0.04999
#   granular linear_history: fy -0.04999, read -0.00000, style given again -0.04999
#   granular mindlin: fy -0.00750, read -0.00000, style given again -0.00750
#   granular mindlin_rescale: fy -0.00750, read error, style given again -0.00750
set -euo pipefail
want=20220106.git7586adbb6a+ds1-2+b2
version=$(dpkg-query -W -f='${Version}' lammps 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs lammps $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
force() { { lmp -in "$1" -log none || true; } 2>&1 | sed -n 's/^SEEN //p' | grep . || echo error; }
restart() {  # label, pair_style, pair_coeff
  style="pair_style $2
pair_coeff * * ${3:-}"
  cat > write.in <<IN
units lj
atom_style sphere
atom_modify map array
newton off
comm_modify vel yes
region cell block -5 5 -5 5 -5 5
create_box 1 cell
create_atoms 1 single -0.5 0 0
create_atoms 1 single 0.49 0 0
set type 1 diameter 1 density 1
$style
neighbor 0.3 bin
set atom 1 omega 0 0 1
fix move all nve/sphere
timestep 0.0001
run 10
write_restart grains.restart
print "SEEN \$(fy[1]:%.5f)"
IN
  written=$(force write.in)
  read_on="comm_modify vel yes
neighbor 0.3 bin
fix move all nve/sphere
run 0
print \"SEEN \$(fy[1]:%.5f)\""
  printf '%s\n' "read_restart grains.restart" "$read_on" > read.in
  printf '%s\n' "read_restart grains.restart" "$style" "$read_on" > again.in
  echo "$1: fy $written, read $(force read.in), style given again $(force again.in)"
}
{
  restart gran/hooke/history "gran/hooke/history 1000 100 0 0 0.5 1"
  restart "granular linear_history" granular "hooke 1000 0 tangential linear_history 100 0 0.5"
  restart "granular mindlin" granular "hertz/material 1000 0 0.3 tangential mindlin 300 0 0.5"
  restart "granular mindlin_rescale" granular "hertz/material 1000 0 0.3 tangential mindlin_rescale 300 0 0.5"
} > seen
cat seen
diff seen - <<'SEEN'
gran/hooke/history: fy -0.04999, read -0.04999, style given again -0.04999
granular linear_history: fy -0.04999, read -0.00000, style given again -0.04999
granular mindlin: fy -0.00750, read -0.00000, style given again -0.00750
granular mindlin_rescale: fy -0.00750, read error, style given again -0.00750
SEEN
