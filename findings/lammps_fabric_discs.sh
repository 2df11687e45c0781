#!/usr/bin/env bash
# LAMMPS 20220106 (Debian 12: lammps 20220106.git7586adbb6a+ds1-2+b2): `compute fabric` of discs in a simulation of dimension 2:
# six around one, as isotropic as contacts in a plane can be, and a pair along x.
#
# Guess: in two dimensions the isotropic part is half the trace, and the fabric of the six is zero.
# Seen: a third of the trace is taken away and what is left is times 15/2, as in three dimensions: the six give 1.25, 1.25 and
# -2.5 along z, where no contact can be; the pair gives 5 and -2.5, which do not cancel. Use the difference xx - yy, which is
# right but for the factor (4 for discs, so 4/7.5 of it). The manual's formula says nothing of two dimensions, and takes away
# the whole trace.
#   six around one, 12 contact(s): xx 1.25 yy 1.25 zz -2.50 xy 0.00
#   a pair along x, 1 contact(s): xx 5.00 yy -2.50 zz -2.50 xy 0.00
set -euo pipefail
want=20220106.git7586adbb6a+ds1-2+b2
version=$(dpkg-query -W -f='${Version}' lammps 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs lammps $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > fabric.in <<'IN'
units lj
dimension 2
atom_style sphere
newton off
comm_modify vel yes
region cell block 0 10 0 10 -0.5 0.5
create_box 1 cell
include discs.in
set type 1 diameter 1 density 1
pair_style gran/hooke 1000 0 0 0 0 0
pair_coeff * *
compute fabric all fabric radius contact
thermo_style custom step c_fabric c_fabric[1] c_fabric[2] c_fabric[3] c_fabric[4]
run 0
print "SEEN $(c_fabric:%.0f) contact(s): xx $(c_fabric[1]:%.2f) yy $(c_fabric[2]:%.2f) &
zz $(c_fabric[3]:%.2f) xy $(abs(c_fabric[4]):%.2f)"
IN
run() { lmp -in fabric.in -log none | sed -n "s/^SEEN /$1, /p"; }
{
  { echo "create_atoms 1 single 5 5 0"
    for i in 0 1 2 3 4 5; do echo "create_atoms 1 single \$(5+0.99*cos($i*PI/3)) \$(5+0.99*sin($i*PI/3)) 0"; done; } > discs.in
  run "six around one"
  printf 'create_atoms 1 single %s 5 0\n' 5 5.99 > discs.in
  run "a pair along x"
} > seen
cat seen
diff seen - <<'SEEN'
six around one, 12 contact(s): xx 1.25 yy 1.25 zz -2.50 xy 0.00
a pair along x, 1 contact(s): xx 5.00 yy -2.50 zz -2.50 xy 0.00
SEEN
