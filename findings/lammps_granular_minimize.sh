#!/usr/bin/env bash
# LAMMPS 20220106 (Debian 12: lammps 20220106.git7586adbb6a+ds1-2+b2): `minimize` with a granular pair style, here the harmonic
# repulsion of frictionless discs (gran/hooke without damping), as one packs them.
#
# Guess: the elastic energy k overlap^2 / 2 = 5 is the potential energy, and any minimiser pushes the discs apart.
# Seen: granular styles have no energy: pe is 0. cg, sd and hftn stop at their first line search with the discs where they were
# and their forces of 100, as if converged ("quadratic factors are zero", "trust region too small"), without error or
# warning. fire and quickmin, which look at forces alone, push them apart. Ask for fmax afterwards.
#   cg: pe 0 distance 0.90 force 100.00
#   sd: pe 0 distance 0.90 force 100.00
#   hftn: pe 0 distance 0.90 force 100.00
#   quickmin: pe 0 distance 1.03 force 0.00
#   fire: pe 0 distance 1.03 force 0.00
set -euo pipefail
want=20220106.git7586adbb6a+ds1-2+b2
version=$(dpkg-query -W -f='${Version}' lammps 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs lammps $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
for style in cg sd hftn quickmin fire; do
  cat > "$style.in" <<IN
units lj
dimension 2
atom_style sphere
atom_modify map array
newton off
comm_modify vel yes
region cell block -5 5 -5 5 -0.5 0.5
create_box 1 cell
create_atoms 1 single 0 0 0
create_atoms 1 single 0.9 0 0
set type 1 diameter 1 density 1
pair_style gran/hooke 1000 0 0 0 0 0
pair_coeff * *
neighbor 0.3 bin
fix flat all enforce2d
min_style $style
minimize 0 1e-10 1000 1000
variable apart equal x[2]-x[1]
print "SEEN $style: pe \$(pe) distance \$(v_apart:%.2f) force \$(abs(fx[1]):%.2f)"
IN
  lmp -in "$style.in" -log none -screen "$style.out" >/dev/null
  grep -h '^  Stopping criterion' "$style.out"
  sed -n 's/^SEEN //p' "$style.out" >> seen
done
cat seen
diff seen - <<'SEEN'
cg: pe 0 distance 0.90 force 100.00
sd: pe 0 distance 0.90 force 100.00
hftn: pe 0 distance 0.90 force 100.00
quickmin: pe 0 distance 1.03 force 0.00
fire: pe 0 distance 1.03 force 0.00
SEEN
