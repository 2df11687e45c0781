#!/usr/bin/env bash
# LAMMPS 20220106 (Debian 12: lammps 20220106.git7586adbb6a+ds1-2+b2): density and diameter of a grain (atom_style sphere, whose
# data files have a diameter and a density in each row) by `set`.
#
# Guess: density and diameter are properties of the grain, and the order in which they are set does not matter.
# Seen: the grain has a mass, not a density: a diameter set afterwards leaves the mass as it was, and a grain made smaller by half
# is eight times as dense, without a word. `fix adapt`, which changes diameters in the course of a run, keeps the density
# instead. Set the density last.
#   density 2, then diameter 0.5: mass 1.0472
#   diameter 0.5, then density 2: mass 0.1309
#   density 2, then fix adapt diameter 0.5: mass 0.1309
set -euo pipefail
want=20220106.git7586adbb6a+ds1-2+b2
version=$(dpkg-query -W -f='${Version}' lammps 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs lammps $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
mass() {  # label, three commands
  cat > one.in <<IN
units lj
atom_style sphere 1
atom_modify map array
newton off
comm_modify vel yes
region cell block 0 10 0 8 0 6
create_box 1 cell
create_atoms 1 single 1 1 0
$2
$3
pair_style gran/hooke 1000 0 0 0 0 0
pair_coeff * *
variable half equal 0.5
$4
fix move all nve/sphere
run 1
print "SEEN $1: mass \$(mass[1]:%.4f)"
IN
  lmp -in one.in -log none -screen screen >/dev/null
  sed -n 's/^SEEN //p' screen
}
{
  mass "density 2, then diameter 0.5" "set type 1 density 2" "set type 1 diameter 0.5" ""
  mass "diameter 0.5, then density 2" "set type 1 diameter 0.5" "set type 1 density 2" ""
  mass "density 2, then fix adapt diameter 0.5" "set type 1 density 2" "" "fix adapt all adapt 1 atom diameter v_half"
} > seen
cat seen
diff seen - <<'SEEN'
density 2, then diameter 0.5: mass 1.0472
diameter 0.5, then density 2: mass 0.1309
density 2, then fix adapt diameter 0.5: mass 0.1309
SEEN
