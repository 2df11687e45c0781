#!/usr/bin/env bash
# LAMMPS 20220106 (Debian 12: lammps 20220106.git7586adbb6a+ds1-2+b2): two grains in a periodic cell so small that they touch each
# other on both sides, one of them spinning (gran/hooke/history), as in the unit cell of a chain or lattice.
#
# Guess: the friction of the two contacts is opposite and cancels, however often the neighbour list is built.
# Seen: as long as the list is not built anew. When it is, the springs of contacts are kept by the ids of the two grains, and
# both contacts get the spring of one: a net force across the chain appears from nothing, and grows. Repeat the cell until no
# pair of grains touches twice.
#   list built 0 times: fx -32.076 fy 0.000
#   list built 10 times: fx -32.076 fy 2.612
set -euo pipefail
want=20220106.git7586adbb6a+ds1-2+b2
version=$(dpkg-query -W -f='${Version}' lammps 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs lammps $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
for check in yes no; do
  cat > chain.in <<IN
units lj
atom_style sphere
atom_modify map array
newton off
comm_modify vel yes cutoff 1.5
region cell block 0 1.85 0 10 -5 5
create_box 1 cell
create_atoms 1 single 0.2 5 0
create_atoms 1 single 1.1 5 0
set type 1 diameter 1 density 1
set atom 1 omega 0 0 1
pair_style gran/hooke/history 1000 300 0 0 10 1
pair_coeff * *
neighbor 0.05 bin
neigh_modify every 1 delay 0 check $check
fix move all nve/sphere
timestep 0.001
run 10
print "SEEN \$(fx[1]:%.3f) fy \$(abs(fy[1]):%.3f)"
IN
  lmp -in chain.in -log none -screen screen >/dev/null
  echo "list built $(awk '/^Neighbor list builds/ { print $5 }' screen) times: fx $(sed -n 's/^SEEN //p' screen)"
done > seen
cat seen
diff seen - <<'SEEN'
list built 0 times: fx -32.076 fy 0.000
list built 10 times: fx -32.076 fy 2.612
SEEN
