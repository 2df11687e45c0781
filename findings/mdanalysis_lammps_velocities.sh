#!/usr/bin/env bash
# MDAnalysis 2.4.2 (Debian 12: python3-mdanalysis 2.4.2+dfsg1-1+b1) reading the velocities of one state from a data file and
# from a dump of LAMMPS.
#
# Guess: both are left as they are, or both are turned from LAMMPS's Angstrom/fs into MDAnalysis's Angstrom/ps: times 1000.
# Seen: those of the data file are multiplied by 0.001, those of the dump are left: apart by 1000 for the same state, so by a
# million in the kinetic energy. For the data file the factor is also the wrong way round: 1 Angstrom/fs is 1000 Angstrom/ps.
# Positions agree. convert_units=False leaves both alone, which is what a file in lj units needs in any case.
#   data file: position [0.5, 0.25, 0.0] velocity [-0.0013, 0.0005, 0.0]
#   dump:      position [0.5, 0.25, 0.0] velocity [-1.3, 0.5, 0.0]
#   convert_units=False: velocity [-1.3, 0.5, 0.0]
#   factor from Angstrom/fs to Angstrom/ps: 0.001
set -euo pipefail
want=2.4.2+dfsg1-1+b1
version=$(dpkg-query -W -f='${Version}' python3-mdanalysis 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs python3-mdanalysis $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > one.data <<'DATA'
LAMMPS data file

1 atoms
1 atom types

0 10 xlo xhi
0 8 ylo yhi
0 1 zlo zhi

Masses

1 2

Atoms # atomic

1 1 0.5 0.25 0

Velocities

1 -1.3 0.5 0
DATA
cat > one.lammpstrj <<'DUMP'
ITEM: TIMESTEP
0
ITEM: NUMBER OF ATOMS
1
ITEM: BOX BOUNDS pp pp pp
0 10
0 8
0 1
ITEM: ATOMS id type x y z vx vy vz
1 1 0.5 0.25 0 -1.3 0.5 0
DUMP
/usr/bin/python3 -W ignore - > seen 2>messages <<'PYTHON' || { cat messages; exit 1; }
import MDAnalysis
from MDAnalysis.units import get_conversion_factor


def short(vectors):
    return [round(float(x), 6) for x in vectors[0]]


dump = {"format": "LAMMPSDUMP", "topology_format": "LAMMPSDUMP"}
data = MDAnalysis.Universe("one.data", atom_style="id type x y z").atoms
print("data file: position", short(data.positions), "velocity", short(data.velocities))
atoms = MDAnalysis.Universe("one.lammpstrj", **dump).atoms
print("dump:      position", short(atoms.positions), "velocity", short(atoms.velocities))
data = MDAnalysis.Universe("one.data", atom_style="id type x y z", convert_units=False).atoms
print("convert_units=False: velocity", short(data.velocities))
print("factor from Angstrom/fs to Angstrom/ps:", get_conversion_factor("speed", "Angstrom/fs", "Angstrom/ps"))
PYTHON
cat seen
diff seen - <<'SEEN'
data file: position [0.5, 0.25, 0.0] velocity [-0.0013, 0.0005, 0.0]
dump:      position [0.5, 0.25, 0.0] velocity [-1.3, 0.5, 0.0]
convert_units=False: velocity [-1.3, 0.5, 0.0]
factor from Angstrom/fs to Angstrom/ps: 0.001
SEEN
