#!/usr/bin/env bash
# LAMMPS 20220106 (Debian 12: lammps 20220106.git7586adbb6a+ds1-2+b2): energy of rotation of two-dimensional discs.
#
# Guess: with `fix nve/sphere disc` a disc of mass 1 and radius 0.5 has the moment of inertia m r^2 / 2 = 0.125, in its motion
# and in `compute erotate/sphere`.
# Seen: it moves with 0.125 (change of spin for its torque), but erotate/sphere counts it with that of a sphere, 0.1, with or
# without `disc`, which it is never told. An energy balance of spinning discs is off by a fifth of their rotation: multiply by
# 1.25.
#   without disc: inertia in motion 0.1000, in erotate/sphere 0.1000
#   with disc:    inertia in motion 0.1250, in erotate/sphere 0.1000
set -euo pipefail
want=20220106.git7586adbb6a+ds1-2+b2
version=$(dpkg-query -W -f='${Version}' lammps 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs lammps $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
spin() {  # label, disc or nothing
  cat > spin.in <<IN
units lj
dimension 2
atom_style sphere
newton off
comm_modify vel yes
region cell block -5 5 -5 5 -0.5 0.5
create_box 1 cell
create_atoms 1 single 0.45 0 0
create_atoms 1 single 1.35 0 0
set type 1 diameter 1 mass 1
set atom 1 omega 0 0 1
pair_style gran/hooke 1000 300 50 20 0.5 1
pair_coeff * *
neighbor 0.3 bin
fix flat all enforce2d
fix move all nve/sphere $2
timestep 1e-6
compute rotation all erotate/sphere
compute each all property/atom omegaz tqz
compute sum all reduce sum c_each[1] c_each[2]
compute square all reduce sumsq c_each[1]
variable spin equal c_sum[1]
variable torque equal c_sum[2]
variable energy equal c_rotation
variable square equal c_square
thermo_style custom step v_spin v_torque v_energy v_square
run 0
variable spin0 equal \${spin}
variable torque0 equal \${torque}
variable counted equal 2*\${energy}/\${square}
run 1
variable moved equal 1e-6*v_torque0/(v_spin-v_spin0)
print "SEEN $1 inertia in motion \$(v_moved:%.4f), in erotate/sphere \$(v_counted:%.4f)"
IN
  lmp -in spin.in -log none -screen screen >/dev/null
  sed -n 's/^SEEN //p' screen
}
{ spin "without disc:" ""; spin "with disc:   " disc; } > seen
cat seen
diff seen - <<'SEEN'
without disc: inertia in motion 0.1000, in erotate/sphere 0.1000
with disc:    inertia in motion 0.1250, in erotate/sphere 0.1000
SEEN
