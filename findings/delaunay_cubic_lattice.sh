#!/usr/bin/env bash
# Delaunay tetrahedra of the 125 points of a simple cubic lattice, 5 along each side, as one fills a grain with a network or with
# finite elements: by SciPy 1.10.1 (Debian 12: python3-scipy 1.10.1-2), geometry 0.4.7 of R (r-cran-geometry 0.4.7-1) and
# Octave 7.3 (octave 7.3.0-2). Their volumes, and how many triangles inside the cube have a tetrahedron on one side alone where
# those of no volume are left out; and the same by SciPy where each point is moved by up to 1e-3 along each axis.
#
# Guess: six for each of the 64 small cubes, which are cut alike; as the eight corners of each lie on a sphere, which diagonals
# it has is a matter of chance, but neighbours share them, as in every triangulation.
# Seen: of the 144 squares between small cubes 46 to 64 have one diagonal on one side and the other one on the other, four
# triangles each that have no partner: elements are not joined there, and bonds cross. SciPy has a flat tetrahedron in each such
# place, of which a stiffness matrix is singular; R and Octave take them out, and nothing is left to see, as the volumes add up
# to 64. One half is numbered the other way round. Where points are moved a little all are joined, and 327 of 700 are nearly flat.
#   scipy.lattice: 466 tetrahedra, 82 flat, 82 below 0.001, 192 turned, sum of sizes 64.0; 220 triangles inside have one side
#   geometry.lattice: 384 tetrahedra, 0 flat, 0 below 0.001, 191 turned, sum of sizes 64.0; 184 triangles inside have one side
#   octave.lattice: 384 tetrahedra, 0 flat, 0 below 0.001, 190 turned, sum of sizes 64.0; 256 triangles inside have one side
#   scipy.moved: 700 tetrahedra, 0 flat, 327 below 0.001, 355 turned, sum of sizes 64.1; 0 triangles inside have one side
set -euo pipefail
for pair in python3-scipy=1.10.1-2 r-cran-geometry=0.4.7-1 octave=7.3.0-2; do
  version=$(dpkg-query -W -f='${Version}' "${pair%%=*}" 2>/dev/null || true)
  [ "$version" = "${pair#*=}" ] || { echo "needs ${pair%%=*} ${pair#*=}, found '${version:-none}'"; exit 77; }
done
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > scipy_makes.py <<'PYTHON'
import numpy
from scipy.spatial import Delaunay

lattice = numpy.array([(x, y, z) for z in range(5) for y in range(5) for x in range(5)], dtype=float)
moved = lattice + numpy.random.RandomState(1).uniform(-1e-3, 1e-3, lattice.shape)
for name, points in (("lattice", lattice), ("moved", moved)):
    numpy.savetxt(f"{name}.points", points, fmt="%.17g")
    numpy.savetxt(f"scipy.{name}", Delaunay(points).simplices + 1, fmt="%d")
PYTHON
/usr/bin/python3 scipy_makes.py
cat > made.R <<'R'
points <- as.matrix(read.table("lattice.points"))
write.table(geometry::delaunayn(points), "geometry.lattice", row.names = FALSE, col.names = FALSE)
R
Rscript --vanilla made.R > messages 2>&1 || { cat messages; exit 1; }
cat > made.m <<'OCTAVE'
tetrahedra = delaunayn(load("lattice.points"));
dlmwrite("octave.lattice", tetrahedra, " ");
OCTAVE
octave-cli --no-init-file --quiet made.m > messages 2>&1 || { cat messages; exit 1; }
cat > look.py <<'PYTHON'
from collections import Counter

import numpy

for name in ("scipy.lattice", "geometry.lattice", "octave.lattice", "scipy.moved"):
    points = numpy.loadtxt(name.split(".")[1] + ".points")
    tetrahedra = numpy.loadtxt(name, dtype=int) - 1
    volumes = numpy.linalg.det(points[tetrahedra[:, 1:]] - points[tetrahedra[:, :1]]) / 6
    flat = abs(volumes) < 1e-12
    faces = Counter(tuple(sorted(numpy.delete(t, n))) for t in tetrahedra[~flat] for n in range(4))
    alone = [numpy.round(points[list(face)]) for face, times in faces.items() if times == 1]
    inside = sum(not any((face[:, k] == end).all() for k in range(3) for end in (0, 4)) for face in alone)
    print(f"{name}: {len(volumes)} tetrahedra, {flat.sum()} flat, {(abs(volumes) < 1e-3).sum()} below 0.001, "
          f"{(volumes < -1e-12).sum()} turned, sum of sizes {abs(volumes).sum():.1f}; {inside} triangles inside have one side")
PYTHON
/usr/bin/python3 look.py > seen
cat seen
diff seen - <<'SEEN'
scipy.lattice: 466 tetrahedra, 82 flat, 82 below 0.001, 192 turned, sum of sizes 64.0; 220 triangles inside have one side
geometry.lattice: 384 tetrahedra, 0 flat, 0 below 0.001, 191 turned, sum of sizes 64.0; 184 triangles inside have one side
octave.lattice: 384 tetrahedra, 0 flat, 0 below 0.001, 190 turned, sum of sizes 64.0; 256 triangles inside have one side
scipy.moved: 700 tetrahedra, 0 flat, 327 below 0.001, 355 turned, sum of sizes 64.1; 0 triangles inside have one side
SEEN
