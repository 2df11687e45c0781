#!/usr/bin/env bash
# LAMMPS 20220106 (Debian 12: lammps 20220106.git7586adbb6a+ds1-2+b2): the Voronoi volumes of grains of diameter 1 at random places of a
# periodic cell of volume 1000, by compute voronoi/atom with pair_style gran/hooke and a neighbour skin of 0.1.
#
# Guess: they add up to 1000, as the cells fill space.
# Seen: they add up to up to 43% more: a cell is cut by those neighbours alone that lie within the range of the forces or, if they
# are in this part of the cell, of any; of images across the boundary only those within 1.1 are known. So cells at the
# boundary reach out of it, 13% in all for 100 grains, 0.8% still at a packing fraction of 0.52, and more in a sheared cell. No
# warning. comm_modify cutoff of half the cell or more makes it right.
#   30 grains, tilt 0: volumes add up to 1085
#   100 grains, tilt 0: volumes add up to 1126
#   300 grains, tilt 0: volumes add up to 1051
#   1000 grains, tilt 0: volumes add up to 1008
#   30 grains, tilt 4.9: volumes add up to 1433
#   300 grains, tilt 4.9: volumes add up to 1081
#   30 grains, tilt 0, cutoff 10: volumes add up to 1000
#   30 grains, tilt 4.9, cutoff 10: volumes add up to 1000
set -euo pipefail
want=20220106.git7586adbb6a+ds1-2+b2
version=$(dpkg-query -W -f='${Version}' lammps 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs lammps $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
volumes() { # NUMBER TILT MORE-OF-comm_modify
  cat > in.cells <<LAMMPS
units lj
atom_style sphere
comm_modify vel yes ${3:-}
newton off
region cell prism 0 10 0 10 0 10 $2 0 0
create_box 1 cell
create_atoms 1 random $1 1 cell
set type 1 diameter 1 density 1
pair_style gran/hooke 1000 NULL 0 NULL 0 0
pair_coeff * *
neighbor 0.1 bin
compute cells all voronoi/atom
compute sum all reduce sum c_cells[1]
thermo_style custom step vol c_sum
thermo_modify norm no
run 0
LAMMPS
  lmp -in in.cells -log none > messages 2>&1 || { cat messages; exit 1; }
  if grep WARNING messages | grep -v 'No fixes'; then exit 1; fi
  awk -v name="$1 grains, tilt $2${3:+, $3}" '/^Step/ { getline; printf "%s: volumes add up to %.0f\n", name, $3 }' messages
}
{
  for number in 30 100 300 1000; do volumes $number 0; done
  volumes 30 4.9
  volumes 300 4.9
  volumes 30 0 "cutoff 10"
  volumes 30 4.9 "cutoff 10"
} > seen
cat seen
diff seen - <<'SEEN'
30 grains, tilt 0: volumes add up to 1085
100 grains, tilt 0: volumes add up to 1126
300 grains, tilt 0: volumes add up to 1051
1000 grains, tilt 0: volumes add up to 1008
30 grains, tilt 4.9: volumes add up to 1433
300 grains, tilt 4.9: volumes add up to 1081
30 grains, tilt 0, cutoff 10: volumes add up to 1000
30 grains, tilt 4.9, cutoff 10: volumes add up to 1000
SEEN
