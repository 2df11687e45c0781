#!/usr/bin/env bash
# LAMMPS 20220106 (Debian 12: lammps 20220106.git7586adbb6a+ds1-2+b2), fix nve/asphere: a lone ellipsoid of 1 by 2 by 3 and
# density 1 turns without torque, with an angular momentum of (3, 1, 2), which is a turn in 2.1 at the start; its energy of
# rotation over that at the start, and the largest that it can have with this angular momentum, about its long axis.
#
# Guess: the energy is kept, or swings about its value, as that of a flight or a spring does with fix nve.
# Seen: it rises, until the ellipsoid spins about its long axis, the motion of the largest energy, 1.758 times that of the
# start: with 21 steps in a turn that is so well before the end, with 42 steps 29% are gained, with 105 steps 1.3%. The
# angular momentum is kept. A gas of such grains without friction heats itself. Half the step makes an eighth of the gain,
# while it is small; watch the energy.
#   step 0.1, time 300: energy 1.679, angular momentum 3.000 1.000 2.000
#   step 0.1, time 1000: energy 1.758, angular momentum 3.000 1.000 2.000
#   step 0.05, time 1000: energy 1.290, angular momentum 3.000 1.000 2.000
#   step 0.02, time 1000: energy 1.013, angular momentum 3.000 1.000 2.000
#   step 0.01, time 1000: energy 1.002, angular momentum 3.000 1.000 2.000
#   largest possible: 1.758
set -euo pipefail
want=20220106.git7586adbb6a+ds1-2+b2
version=$(dpkg-query -W -f='${Version}' lammps 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs lammps $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > turn.in <<'IN'
units lj
atom_style ellipsoid
atom_modify map array
region cell block -10 10 -10 10 -10 10
create_box 1 cell
create_atoms 1 single 0 0 0
set type 1 shape 1 2 3
set type 1 density 1
set type 1 quat 0 0 1 0
set atom 1 angmom 3 1 2
pair_style zero 1
pair_coeff * *
compute energy all erotate/asphere
compute moment all property/atom angmomx angmomy angmomz
compute moments all reduce sum c_moment[1] c_moment[2] c_moment[3]
thermo_style custom step c_energy c_moments[1] c_moments[2] c_moments[3]
thermo_modify norm no
fix turn all nve/asphere
timestep ${step}
run 0
variable start equal $(c_energy)
variable steps equal round(${time}/${step})
run ${steps}
variable moment string "$(c_moments[1]:%.3f) $(c_moments[2]:%.3f) $(c_moments[3]:%.3f)"
print "SEEN step ${step}, time ${time}: energy $(c_energy/v_start:%.3f), angular momentum ${moment}"
IN
for case in "0.1 300" "0.1 1000" "0.05 1000" "0.02 1000" "0.01 1000"; do
  read -r step time <<< "$case"
  lmp -in turn.in -log none -var step "$step" -var time "$time" | sed -n 's/^SEEN //p'
done > seen
/usr/bin/python3 >> seen <<'PYTHON'
mass, axes, moment = 3.141592653589793, (0.5, 1, 1.5), (3, 1, 2)
inertia = [mass / 5 * (sum(a * a for a in axes) - axis * axis) for axis in axes]
start = sum(m * m / i for m, i in zip(moment, inertia))
print(f"largest possible: {sum(m * m for m in moment) / min(inertia) / start:.3f}")
PYTHON
cat seen
diff seen - <<'SEEN'
step 0.1, time 300: energy 1.679, angular momentum 3.000 1.000 2.000
step 0.1, time 1000: energy 1.758, angular momentum 3.000 1.000 2.000
step 0.05, time 1000: energy 1.290, angular momentum 3.000 1.000 2.000
step 0.02, time 1000: energy 1.013, angular momentum 3.000 1.000 2.000
step 0.01, time 1000: energy 1.002, angular momentum 3.000 1.000 2.000
largest possible: 1.758
SEEN
