#!/usr/bin/env bash
# LAMMPS 20220106 (Debian 12: lammps 20220106.git7586adbb6a+ds1-2+b2): one run of twenty steps, and two of ten, of two grains with
# damping (gran/hooke).
#
# Guess: the same to the last digit, as nothing happens between the two.
# Seen: the forces differ by 2 per cent after twenty steps. Each `run` computes the forces anew before its first step, now with
# the velocities of the full step, where the steps themselves use those of the half step. Without damping, or with
# `run 10 pre no`, both agree. A run continued from a restart file therefore is not the run that went on.
#   damped, 20: x 0.426152048 fx -1.44996
#   damped, 10 and 10: x 0.426160830 fx -1.48290
#   damped, 10 and 10 pre no: x 0.426152048 fx -1.44996
#   elastic, 20: x 0.418180419 fx -34.36084
#   elastic, 10 and 10: x 0.418180419 fx -34.36084
set -euo pipefail
want=20220106.git7586adbb6a+ds1-2+b2
version=$(dpkg-query -W -f='${Version}' lammps 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs lammps $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
in_parts() {  # label, damping, runs
  cat > parts.in <<IN
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
set atom 1 vx 0.1 omega 0 0 1
pair_style gran/hooke 1000 300 $2 0.5 1
pair_coeff * *
neighbor 0.3 bin
fix move all nve/sphere
timestep 0.001
IN
  printf '%s\n' "${@:3}" "print \"SEEN $1: x \$(x[1]:%.9f) fx \$(fx[1]:%.5f)\"" >> parts.in
  lmp -in parts.in -log none -screen screen >/dev/null
  sed -n 's/^SEEN //p' screen
}
{
  in_parts "damped, 20" "50 20" "run 20"
  in_parts "damped, 10 and 10" "50 20" "run 10" "run 10"
  in_parts "damped, 10 and 10 pre no" "50 20" "run 10" "run 10 pre no"
  in_parts "elastic, 20" "0 0" "run 20"
  in_parts "elastic, 10 and 10" "0 0" "run 10" "run 10"
} > seen
cat seen
diff seen - <<'SEEN'
damped, 20: x 0.426152048 fx -1.44996
damped, 10 and 10: x 0.426160830 fx -1.48290
damped, 10 and 10 pre no: x 0.426152048 fx -1.44996
elastic, 20: x 0.418180419 fx -34.36084
elastic, 10 and 10: x 0.418180419 fx -34.36084
SEEN
