#!/usr/bin/env bash
# mdtraj 1.9.7 (Debian 12: python3-mdtraj 1.9.7-6) reading and writing GSD files (python3-gsd 2.7.0-2+b1) of a sheared cell,
# box [Lx, Ly, Lz, xy, xz, yz].
#
# Guess: what gsd wrote is read as the cell (10, 0), (6.4, 8), and written again as the same box.
# Seen: reading takes the matrix of the vectors by its rows instead of its columns: the first vector gets the length 11.87 of
# (10, 6.4), the second 8, and all is turned. Writing stores the tilt as a length, 6.4, where the file has the ratio 0.8 (LAMMPS
# and GSD differ in this), so the sheared cell that HOOMD then reads has a second vector of (51.2, 8). Cells without tilt are
# right both ways. Write DCD or XTC, or put the box right with gsd.
#   xy 0: read [[10, 0, 0], [0, 8, 0], [0, 0, 6]]
#   xy 0.8: read [[11.87, 0, 0], [4.312, 6.738, 0], [0, 0, 6]]
#   vectors (10, 0, 0), (0, 8, 0), (0, 0, 6): written [10, 8, 6, 0, 0, 0]
#   vectors (10, 0, 0), (6.4, 8, 0), (0, 0, 6): written [10, 8, 6, 6.4, 0, 0]
set -euo pipefail
for pair in python3-mdtraj=1.9.7-6 python3-gsd=2.7.0-2+b1; do
  version=$(dpkg-query -W -f='${Version}' "${pair%%=*}" 2>/dev/null || true)
  [ "$version" = "${pair#*=}" ] || { echo "needs ${pair%%=*} ${pair#*=}, found '${version:-none}'"; exit 77; }
done
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
/usr/bin/python3 -W ignore - > seen 2>messages <<'PYTHON' || { cat messages; exit 1; }
import gsd.hoomd
import mdtraj
import numpy


def short(values):
    rounded = [float(f"{x:.4g}") if abs(x) > 1e-4 else 0.0 for x in values]
    return [int(x) if x == int(x) else x for x in rounded]


topology = mdtraj.Topology()
topology.add_atom("A", None, topology.add_residue("disc", topology.add_chain()))
for xy in (0, 0.8):
    with gsd.hoomd.open("read.gsd", "wb") as file:
        frame = gsd.hoomd.Snapshot()
        frame.configuration.box = [10, 8, 6, xy, 0, 0]
        frame.particles.N = 1
        frame.particles.types = ["A"]
        file.append(frame)
    vectors = mdtraj.load("read.gsd", top=topology).unitcell_vectors[0]
    print(f"xy {xy}: read {[short(vector) for vector in vectors]}")
for tilt in (0, 6.4):
    trajectory = mdtraj.Trajectory(numpy.zeros((1, 1, 3), dtype=numpy.float32), topology)
    trajectory.unitcell_vectors = numpy.array([[[10, 0, 0], [tilt, 8, 0], [0, 0, 6]]], dtype=numpy.float32)
    trajectory.save("written.gsd")
    with gsd.hoomd.open("written.gsd", "rb") as file:
        print(f"vectors (10, 0, 0), ({tilt}, 8, 0), (0, 0, 6): written {short(file[0].configuration.box)}")
PYTHON
cat seen
diff seen - <<'SEEN'
xy 0: read [[10, 0, 0], [0, 8, 0], [0, 0, 6]]
xy 0.8: read [[11.87, 0, 0], [4.312, 6.738, 0], [0, 0, 6]]
vectors (10, 0, 0), (0, 8, 0), (0, 0, 6): written [10, 8, 6, 0, 0, 0]
vectors (10, 0, 0), (6.4, 8, 0), (0, 0, 6): written [10, 8, 6, 6.4, 0, 0]
SEEN
