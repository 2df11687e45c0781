#!/usr/bin/env bash
# LAMMPS 20220106 (Debian 12: lammps 20220106.git7586adbb6a+ds1-2+b2): shear by `fix deform ... remap v` at rate 0.1 in a cell of height
# 10, which is turned over from a tilt of 5 to -5 whenever it gets there (flip yes, the default); 2000 free particles with
# velocities along y alone. Whoever leaves through the top is back at the bottom, slower along x by 1.
#
# Guess: after n passages through the top the velocity along x is -n, for every particle, with flip as without.
# Seen: those who are on their way through the boundary when the cell is turned over, since the neighbour list was built last, are
# put back without the change of velocity: a dozen of 2000 each time, here, so that they have a velocity of strain rate
# times height too much, which heats a dense packing in a kick at every strain of 1. No warning. `flip no` does not have it, but
# its cell grows as slender as the strain is large.
#   flip no, skin 0.3: 0 of 2000 particles off, their energy 0.0000 a particle
#   flip yes, skin 0.1: 36 of 2000 particles off, their energy 0.0090 a particle
#   flip yes, skin 0.3: 36 of 2000 particles off, their energy 0.0090 a particle
#   flip yes, skin 1: 32 of 2000 particles off, their energy 0.0080 a particle
set -euo pipefail
want=20220106.git7586adbb6a+ds1-2+b2
version=$(dpkg-query -W -f='${Version}' lammps 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs lammps $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
shear() { # FLIP SKIN
  cat > in.shear <<LAMMPS
units lj
atom_style atomic
boundary p p p
region cell prism 0 10 0 10 0 10 0 0 0
create_box 1 cell
create_atoms 1 random 2000 3 cell
mass 1 1
velocity all create 1 7 loop all
velocity all set 0 NULL 0
pair_style zero 1
pair_coeff * *
neighbor $2 bin
timestep 0.01
fix move all nve
fix shear all deform 1 xy erate 0.1 remap v flip $1
dump last all custom 3400 dump.last vx iy
dump_modify last format float %.6f
run 3400
LAMMPS
  lmp -in in.shear -log none > messages 2>&1 || { cat messages; exit 1; }
  if grep WARNING messages; then exit 1; fi
  awk -v name="flip $1, skin $2" '
    /TIMESTEP/ { wrong = count = 0; energy = 0 }
    NF == 2 && $1 + 0 == $1 && $2 == int($2) { ++count; off = $1 + $2; energy += off * off / 2; if (off > 0.001 || off < -0.001) ++wrong }
    END { printf "%s: %d of %d particles off, their energy %.4f a particle\n", name, wrong, count, energy / count }' dump.last
}
{ shear no 0.3; shear yes 0.1; shear yes 0.3; shear yes 1; } > seen
cat seen
diff seen - <<'SEEN'
flip no, skin 0.3: 0 of 2000 particles off, their energy 0.0000 a particle
flip yes, skin 0.1: 36 of 2000 particles off, their energy 0.0090 a particle
flip yes, skin 0.3: 36 of 2000 particles off, their energy 0.0090 a particle
flip yes, skin 1: 32 of 2000 particles off, their energy 0.0080 a particle
SEEN
