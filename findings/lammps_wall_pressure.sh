#!/usr/bin/env bash
# LAMMPS 20220106 (Debian 12: lammps 20220106.git7586adbb6a+ds1-2+b2): the pressure of a column of N grains of diameter 1 between two
# plates (fix wall/gran, zplane), pressed together so that every contact, also that with a plate, has the force 10; a box of 2 by 2.
#
# Guess: the pressure along z is force over area, 2.5, for any N, as it is where the column goes on periodically.
# Seen: contacts with plates are not in compute pressure, nor in compute stress/atom: N - 1 of N lengths count. A grain
# between plates has no pressure, ten grains have a tenth too little, and a packing is short of a grain's thickness. The fix has no
# fix_modify virial; no warning. Take the force on the plates, over their area.
#   1 between plates: pressure 0.000, by stress/atom 0.000
#   2 between plates: pressure 1.256, by stress/atom 1.256
#   10 between plates: pressure 2.252, by stress/atom 2.252
#   100 between plates: pressure 2.475, by stress/atom 2.475
#   10 periodic: pressure 2.500, by stress/atom 2.500
set -euo pipefail
want=20220106.git7586adbb6a+ds1-2+b2
version=$(dpkg-query -W -f='${Version}' lammps 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs lammps $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
column() { # NUMBER BOUNDARY
  # contacts of depth 0.01: with a plate 0.01, between grains 0.01; stiffness 1000
  awk -v n="$1" -v ends="$2" 'BEGIN {
    height = ends == "p" ? 0.99 * n : 0.99 * (n - 1) + 0.98
    print "units lj\natom_style sphere\ncomm_modify vel yes\nnewton off\nboundary p p " ends
    print "region cell block 0 2 0 2 0 " height "\ncreate_box 1 cell"
    for (k = 0; k < n; ++k) print "create_atoms 1 single 1 1 " 0.49 + 0.99 * k
    print "set type 1 diameter 1 density 1\npair_style gran/hooke 1000 NULL 0 NULL 0 0\npair_coeff * *"
    if (ends == "f") print "fix plates all wall/gran hooke 1000 NULL 0 NULL 0 0 zplane 0 " height
    print "compute each all stress/atom NULL virial\ncompute sum all reduce sum c_each[3]"
    print "variable each equal -c_sum/vol\nthermo_style custom step pzz v_each lz\nthermo_modify norm no\nrun 0"
  }' > in.column
  lmp -in in.column -log none > messages 2>&1 || { cat messages; exit 1; }
  if grep WARNING messages | grep -v -e 'No fixes' -e 'non-periodic'; then exit 1; fi
  awk -v n="$1" -v ends="$2" '/^Step/ { getline
    printf "%d %s: pressure %.3f, by stress/atom %.3f\n", n, ends == "p" ? "periodic" : "between plates", $2, $3 }' messages
}
{ column 1 f; column 2 f; column 10 f; column 100 f; column 10 p; } | sed "s/-0.000/0.000/" > seen
cat seen
diff seen - <<'SEEN'
1 between plates: pressure 0.000, by stress/atom 0.000
2 between plates: pressure 1.256, by stress/atom 1.256
10 between plates: pressure 2.252, by stress/atom 2.252
100 between plates: pressure 2.475, by stress/atom 2.475
10 periodic: pressure 2.500, by stress/atom 2.500
SEEN
