#!/usr/bin/env bash
# MDAnalysis 2.4.2 and mdtraj 1.9.7 (Debian 12: python3-mdanalysis 2.4.2+dfsg1-1+b1, python3-mdtraj 1.9.7-6), ASE 3.22.1
# beside them: an extended XYZ file whose positions are not the first columns after the element.
#
# Guess: a reader either follows Properties=, or refuses a file whose columns it cannot know.
# Seen: both take columns two to four as x, y, z whatever Properties says: radius 0.5 and position (1, 2, 0) give
# (0.5, 1, 2), no warning; the cell of Lattice= is dropped as well. ASE reads both. Write pos before every other number.
#   ASE        [[1.0, 2.0, 0.0], [3.0, 4.0, 0.0]]
#   MDAnalysis [[0.5, 1.0, 2.0], [0.75, 3.0, 4.0]] cell None
#   mdtraj     [[0.5, 1.0, 2.0], [0.75, 3.0, 4.0]]
set -euo pipefail
for pair in python3-mdanalysis=2.4.2+dfsg1-1+b1 python3-mdtraj=1.9.7-6 python3-ase=3.22.1-3+deb12u1; do
  version=$(dpkg-query -W -f='${Version}' "${pair%%=*}" 2>/dev/null || true)
  [ "$version" = "${pair#*=}" ] || { echo "needs ${pair%%=*} ${pair#*=}, found '${version:-none}'"; exit 77; }
done
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cat > "$folder/discs.xyz" <<'XYZ'
2
Lattice="10.0 0.0 0.0 2.0 10.0 0.0 0.0 0.0 1.0" Properties=species:S:1:radius:R:1:pos:R:3
Ar 0.5 1.0 2.0 0.0
Ne 0.75 3.0 4.0 0.0
XYZ

/usr/bin/python3 -W ignore - "$folder/discs.xyz" <<'PYTHON'
import sys
import ase.io
import MDAnalysis
from mdtraj.formats import XYZTrajectoryFile

path = sys.argv[1]
right = ase.io.read(path, format="extxyz").positions.tolist()
universe = MDAnalysis.Universe(path)
analysis = universe.atoms.positions.tolist()
with XYZTrajectoryFile(path) as file:
    trajectory = file.read()[0].tolist()
print("ASE       ", right)
print("MDAnalysis", analysis, "cell", universe.dimensions)
print("mdtraj    ", trajectory)
shifted = [[0.5, 1, 2], [0.75, 3, 4]]
sys.exit(0 if right == [[1, 2, 0], [3, 4, 0]] and analysis == shifted and universe.dimensions is None
         and trajectory == shifted else 1)
PYTHON
