#!/usr/bin/env bash
# LAMMPS 20220106 (Debian 12: lammps 20220106.git7586adbb6a+ds1-2+b2): `minimize` of one and the same packing of soft discs of
# diameter 1, with energies of 1, 1e-3, 1e-6, 1e-9 and 1e-12 at a contact: joules of soft grains, or close to jamming.
#
# Guess: the unit of energy has no say: tolerance 1e-6 is a part of the energy, and cg needs as many steps at each.
# Seen: cg, the default, moves no grain further in a step than the number of its force, so that at 1e-3 it does not arrive in
# 10000 steps and at 1e-6 hardly leaves, and 1e-8 is added to the energy that the tolerance is a part of: at 1e-9 it is content
# after one step, "energy tolerance", with the forces it began with. fire, whose time step was set to fit, does so at 1e-12.
# Ask for fmax afterwards, choose units so that energies are near 1, or use fire, a time step that fits and tolerance 0.
#   cg 1: energy tolerance, energy 0.0163, largest force 0.0013
#   cg 1e-3: max iterations, energy 0.0260, largest force 0.0711
#   cg 1e-6: max iterations, energy 0.9765, largest force 8.0310
#   cg 1e-9: energy tolerance, energy 1.1458, largest force 9.6766
#   fire 1: energy tolerance, energy 0.0078, largest force 0.0008
#   fire 1e-9: energy tolerance, energy 0.0078, largest force 0.0282
#   fire 1e-12: energy tolerance, energy 1.1181, largest force 9.2563
#   fire 1e-12, tolerance 0: max iterations, energy 0.0078, largest force 0.0000
set -euo pipefail
want=20220106.git7586adbb6a+ds1-2+b2
version=$(dpkg-query -W -f='${Version}' lammps 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs lammps $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > minimize.in <<'IN'
units lj
dimension 2
atom_style atomic
region cell block 0 10 0 10 -0.5 0.5
create_box 1 cell
create_atoms 1 random 120 7000007 cell
mass 1 1
pair_style soft 1.0
pair_coeff * * ${energy} 1.0
timestep $(0.005/sqrt(v_energy))
min_style ${style}
minimize ${tolerance} 0 10000 40000
variable pe equal pe/v_energy
variable largest equal fmax/v_energy
print "SEEN energy $(v_pe:%.4f), largest force $(v_largest:%.4f)"
IN
relax() { # STYLE ENERGY TOLERANCE NAME
  lmp -in minimize.in -var style "$1" -var energy "$2" -var tolerance "$3" -log none > messages || { cat messages; exit 1; }
  echo "$4: $(sed -n 's/.*Stopping criterion = //p' messages), $(sed -n 's/^SEEN //p' messages)"
}
{
  for energy in 1 1e-3 1e-6 1e-9; do relax cg $energy 1e-6 "cg $energy"; done
  for energy in 1 1e-9 1e-12; do relax fire $energy 1e-6 "fire $energy"; done
  relax fire 1e-12 0 "fire 1e-12, tolerance 0"
} > seen
cat seen
diff seen - <<'SEEN'
cg 1: energy tolerance, energy 0.0163, largest force 0.0013
cg 1e-3: max iterations, energy 0.0260, largest force 0.0711
cg 1e-6: max iterations, energy 0.9765, largest force 8.0310
cg 1e-9: energy tolerance, energy 1.1458, largest force 9.6766
fire 1: energy tolerance, energy 0.0078, largest force 0.0008
fire 1e-9: energy tolerance, energy 0.0078, largest force 0.0282
fire 1e-12: energy tolerance, energy 1.1181, largest force 9.2563
fire 1e-12, tolerance 0: max iterations, energy 0.0078, largest force 0.0000
SEEN
