#!/usr/bin/env bash
# SciPy 1.10.1, geometry 0.4.7 of R, Octave 7.3 (Debian 12: python3-scipy 1.10.1-2, r-cran-geometry 0.4.7-1, octave 7.3.0-2):
# convex hulls and Delaunay triangulations of the same 60 random points, as the surfaces of grains and the tetrahedra in them.
#
# Guess: the triangles of a hull are a surface: their corners are all in the order that looks outwards, and the volume from them
# is that of the hull. Tetrahedra have one sense, too.
# Seen: in SciPy and R half of the triangles looks inwards, as Qhull gives them, so that the volume from them is anything of
# either sign, and so are normals, gaps and an .stl file made of them. In Octave all look inwards: the volume is negative. The
# volumes that these functions give themselves are right. Of the tetrahedra about half have a negative volume in all three. Turn
# them by the sign of the equations of the hull, or by the centre of the points.
#   scipy: 27 triangles look outwards, 27 inwards, volume from them 0.0468, as given 0.6062; negative tetrahedra 0.51
#   R: 27 triangles look outwards, 27 inwards, volume from them 0.0468, as given 0.6062; negative tetrahedra 0.51
#   Octave: 0 triangles look outwards, 54 inwards, volume from them -0.6062, as given 0.6062; negative tetrahedra 0.50
set -euo pipefail
for want in python3-scipy=1.10.1-2 r-cran-geometry=0.4.7-1 octave=7.3.0-2; do
  version=$(dpkg-query -W -f='${Version}' "${want%%=*}" 2>/dev/null || true)
  [ "$version" = "${want#*=}" ] || { echo "needs ${want%%=*} ${want#*=}, found '${version:-none}'"; exit 77; }
done
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > hull.py <<'PYTHON'
import numpy
from scipy.spatial import ConvexHull, Delaunay

points = numpy.random.RandomState(1).rand(60, 3)
numpy.savetxt("points", points, fmt="%.17g")
hull = ConvexHull(points)
numpy.savetxt("scipy_triangles", hull.simplices, fmt="%d")
numpy.savetxt("scipy_tetrahedra", Delaunay(points).simplices, fmt="%d")
open("scipy_volume", "w").write(f"{hull.volume:.4f}")
PYTHON
cat > hull.R <<'R'
suppressMessages(library(geometry))
points <- as.matrix(read.table("points"))
hull <- convhulln(points, "FA")
write.table(hull$hull - 1, "R_triangles", row.names = FALSE, col.names = FALSE)
write.table(delaunayn(points) - 1, "R_tetrahedra", row.names = FALSE, col.names = FALSE)
cat(sprintf("%.4f", hull$vol), file = "R_volume")
R
cat > hull.m <<'OCTAVE'
points = load("points");
[triangles, volume] = convhulln(points);
dlmwrite("Octave_triangles", triangles - 1, " ");
dlmwrite("Octave_tetrahedra", delaunayn(points) - 1, " ");
file = fopen("Octave_volume", "w"); fprintf(file, "%.4f", volume); fclose(file);
OCTAVE
cat > look.py <<'PYTHON'
import numpy

points = numpy.loadtxt("points")
for name in ("scipy", "R", "Octave"):
    corners = points[numpy.loadtxt(name + "_triangles").astype(int)]
    volumes = numpy.linalg.det(corners - points.mean(axis=0)) / 6
    four = points[numpy.loadtxt(name + "_tetrahedra").astype(int)]
    senses = numpy.linalg.det(four[:, 1:] - four[:, :1])
    print(f"{name}: {(volumes > 0).sum()} triangles look outwards, {(volumes < 0).sum()} inwards, volume from them "
          f"{volumes.sum():.4f}, as given {open(name + '_volume').read()}; negative tetrahedra {(senses < 0).mean():.2f}")
PYTHON
/usr/bin/python3 hull.py
Rscript --vanilla hull.R 2> messages || { cat messages; exit 1; }
octave-cli -q hull.m 2> messages || { cat messages; exit 1; }
/usr/bin/python3 look.py > seen
cat seen
diff seen - <<'SEEN'
scipy: 27 triangles look outwards, 27 inwards, volume from them 0.0468, as given 0.6062; negative tetrahedra 0.51
R: 27 triangles look outwards, 27 inwards, volume from them 0.0468, as given 0.6062; negative tetrahedra 0.51
Octave: 0 triangles look outwards, 54 inwards, volume from them -0.6062, as given 0.6062; negative tetrahedra 0.50
SEEN
