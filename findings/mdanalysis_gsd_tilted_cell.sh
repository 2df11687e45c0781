#!/usr/bin/env bash
# MDAnalysis 2.4.2 (Debian 12: python3-mdanalysis 2.4.2+dfsg1-1+b1) reading a GSD file (python3-gsd 2.7.0-2+b1) whose cell is
# sheared: box [Lx, Ly, Lz, xy, xz, yz], as HOOMD writes it.
#
# Guess: xy = 0.8 is a shear of x with y: the second cell vector is (0.8 Ly, Ly, 0), as the schema of GSD has it.
# Seen: MDAnalysis takes xy, xz, yz for the cosines of alpha, beta, gamma, in this order. xy becomes a shear of y with z, also
# where the cell is flat, and distances across the boundary are wrong, without a word. At |xy| > 1 an angle is nan, and the
# cell counts as not periodic. Set `dimensions` from the box yourself, frame by frame.
#   xy 0.0: vectors [[10, 0, 0], [0, 8, 0], [0, 0, 1]], distance 1.414, in truth 1.414
#   xy 0.8: vectors [[10, 0, 0], [0, 8, 0], [0, 0.8, 0.6]], distance 1.183, in truth 2.786
#   xy 1.6: vectors [[0, 0, 0], [0, 0, 0], [0, 0, 0]], distance 11.402, in truth 3.929
set -euo pipefail
for pair in python3-mdanalysis=2.4.2+dfsg1-1+b1 python3-gsd=2.7.0-2+b1; do
  version=$(dpkg-query -W -f='${Version}' "${pair%%=*}" 2>/dev/null || true)
  [ "$version" = "${pair#*=}" ] || { echo "needs ${pair%%=*} ${pair#*=}, found '${version:-none}'"; exit 77; }
done
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
/usr/bin/python3 -W ignore - > seen <<'PYTHON'
import gsd.hoomd
import MDAnalysis
import numpy
from MDAnalysis.lib.distances import distance_array
from MDAnalysis.lib.mdamath import triclinic_vectors

for xy in (0.0, 0.8, 1.6):
    with gsd.hoomd.open("sheared.gsd", "wb") as file:
        frame = gsd.hoomd.Snapshot()
        frame.configuration.box = [10, 8, 1, xy, 0, 0]
        frame.particles.N = 2
        frame.particles.types = ["A"]
        frame.particles.position = [[-4.5, -3.5, 0], [4.5, 3.5, 0]]
        file.append(frame)
    universe = MDAnalysis.Universe("sheared.gsd")
    vectors = [[float(f"{x:.4g}") + 0.0 for x in row] for row in triclinic_vectors(universe.dimensions)]
    vectors = [[int(x) if x == int(x) else x for x in row] for row in vectors]
    first, second = universe.atoms.positions
    distance = distance_array(first, second, box=universe.dimensions)[0, 0]
    images = [(9 + 10 * i + 8 * xy * j, 7 + 8 * j) for i in range(-4, 5) for j in range(-2, 3)]
    print(f"xy {xy}: vectors {vectors}, distance {distance:.3f}, in truth {min(numpy.hypot(*d) for d in images):.3f}")
PYTHON
cat seen
diff seen - <<'SEEN'
xy 0.0: vectors [[10, 0, 0], [0, 8, 0], [0, 0, 1]], distance 1.414, in truth 1.414
xy 0.8: vectors [[10, 0, 0], [0, 8, 0], [0, 0.8, 0.6]], distance 1.183, in truth 2.786
xy 1.6: vectors [[0, 0, 0], [0, 0, 0], [0, 0, 0]], distance 11.402, in truth 3.929
SEEN
