#!/usr/bin/env bash
# GROMACS 2022.5 (Debian 12: gromacs 2022.5-2): simple shear by `deform`, at rate 0.02 in a box of 5 nm: a particle without any
# interaction starts at z = 2 with velocity 1 along z, and one at z = 1 at rest.
#
# Guess: the first flies straight up, and when it leaves through the top and is back below, its velocity along x is less by that of
# the top, 0.1, as in any sheared cell (LAMMPS: remap v); the second stays where it is.
# Seen: both are carried along with the cell while their velocities in the file remain (0, 0, 1) and (0, 0, 0), also across the
# boundary. The velocities are those against the flow, but nothing makes them smaller where a particle climbs into faster flow:
# it is accelerated for nothing. The part of the viscosity that is carried by motion, all of it in a gas, is missing, and a
# trajectory has other velocities than displacements. No warning of it.
#   time 0.0, first: x, z = 2.00, 2.00, velocities 0.00, 1.00
#   time 0.0, second: x, z = 4.00, 1.00, velocities 0.00, 0.00
#   time 2.5, first: x, z = 2.16, 4.50, velocities 0.00, 1.00
#   time 2.5, second: x, z = 4.05, 1.00, velocities 0.00, 0.00
#   time 5.0, first: x, z = 1.95, 2.00, velocities 0.00, 1.00
#   time 5.0, second: x, z = 4.10, 1.00, velocities 0.00, 0.00
set -euo pipefail
want=2022.5-2
version=$(dpkg-query -W -f='${Version}' gromacs 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs gromacs $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > topol.top <<'TOP'
[ defaults ]
1 1 no 1 1
[ atomtypes ]
G 1 1.0 0 A 0 0
[ moleculetype ]
G 0
[ atoms ]
1 G 1 G G 1 0 1
[ system ]
free
[ molecules ]
G 2
TOP
{
  echo "free"
  echo 2
  printf '%5d%-5s%5s%5d%8.3f%8.3f%8.3f%8.4f%8.4f%8.4f\n' 1 G G 1 2 2 2 0 0 1
  printf '%5d%-5s%5s%5d%8.3f%8.3f%8.3f%8.4f%8.4f%8.4f\n' 2 G G 2 4 1 1 0 0 0
  echo "5 5 5 0 0 0 0 0 0"
} > conf.gro
cat > run.mdp <<'MDP'
integrator = md
dt = 0.002
nsteps = 2500
nstxout = 1250
nstvout = 1250
cutoff-scheme = verlet
verlet-buffer-tolerance = -1
rlist = 1.2
comm-mode = none
deform = 0 0 0 0 0.1 0
MDP
export GMX_MAXBACKUP=-1 OMP_NUM_THREADS=1
{
  gmx -quiet grompp -f run.mdp -c conf.gro -p topol.top -o run.tpr -maxwarn 1 # that comm-mode is none
  gmx -quiet mdrun -s run.tpr -deffnm run -ntmpi 1 -ntomp 1
} > messages 2>&1 || { cat messages; exit 1; }
gmx -quiet dump -f run.trr 2>> messages | awk '
  /time=/ { sub(/.*time=/, ""); time = $1 }
  /^ *[xv]\[ +[01]\]=/ {
    kind = /x\[/ ? "x" : "v"; particle = /\[ +0\]/ ? "first" : "second"
    sub(/.*{/, ""); sub(/}.*/, ""); gsub(/ /, ""); split($0, a, ",")
    value[particle, kind] = sprintf("%.2f, %.2f", a[1], a[3])
    if (particle == "second" && kind == "v")
      for (n = 1; n <= 2; ++n) {
        p = n == 1 ? "first" : "second"
        printf "time %.1f, %s: x, z = %s, velocities %s\n", time, p, value[p, "x"], value[p, "v"]
      }
  }' > seen
cat seen
diff seen - <<'SEEN'
time 0.0, first: x, z = 2.00, 2.00, velocities 0.00, 1.00
time 0.0, second: x, z = 4.00, 1.00, velocities 0.00, 0.00
time 2.5, first: x, z = 2.16, 4.50, velocities 0.00, 1.00
time 2.5, second: x, z = 4.05, 1.00, velocities 0.00, 0.00
time 5.0, first: x, z = 1.95, 2.00, velocities 0.00, 1.00
time 5.0, second: x, z = 4.10, 1.00, velocities 0.00, 0.00
SEEN
