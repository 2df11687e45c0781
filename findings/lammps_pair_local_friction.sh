#!/usr/bin/env bash
# LAMMPS 20220106 (Debian 12: lammps 20220106.git7586adbb6a+ds1-2+b2): contact forces by `compute pair/local` of frictional
# grains, as one needs them for force chains, fabric and stress.
#
# Guess: `force fx fy fz` of a pair is the force that acts on its particles.
# Seen: fx fy fz are the normal part alone. Two touching spheres, one of them spinning (gran/hooke/history), are pushed by
# (-100, -2.618) while pair/local has (-100, 0), without a warning. The friction is in p1 p2 p3, its size in p4: add p1 p2 p3
# to fx fy fz. `force` is the size of the normal part.
#   on the particle: -100 -2.6179939
#   pair/local, force fx fy fz: 100 -100 0 0
#   pair/local, p1 p2 p3 p4: 0 -2.61799 0 2.61799
set -euo pipefail
want=20220106.git7586adbb6a+ds1-2+b2
version=$(dpkg-query -W -f='${Version}' lammps 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs lammps $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > pair.in <<'IN'
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
set atom 1 omega 0 0 1
pair_style gran/hooke/history 1000 300 50 20 0.5 1
pair_coeff * *
neighbor 0.3 bin
fix move all nve/sphere
compute force all pair/local force fx fy fz
compute more all pair/local p1 p2 p3 p4
dump force all local 1 force.dump c_force[1] c_force[2] c_force[3] c_force[4]
dump more all local 1 more.dump c_more[1] c_more[2] c_more[3] c_more[4]
run 0
print "SEEN on the particle: $(fx[1]:%.8g) $(fy[1]:%.8g)"
IN
lmp -in pair.in -log none -screen screen >/dev/null
{
  sed -n 's/^SEEN //p' screen
  echo "pair/local, force fx fy fz: $(tail -1 force.dump)"
  echo "pair/local, p1 p2 p3 p4: $(tail -1 more.dump)"
} | sed -E 's/ *$//; s/-0( |$)/0\1/g' > seen
cat seen
diff seen - <<'SEEN'
on the particle: -100 -2.6179939
pair/local, force fx fy fz: 100 -100 0 0
pair/local, p1 p2 p3 p4: 0 -2.61799 0 2.61799
SEEN
