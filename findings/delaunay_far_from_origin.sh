#!/usr/bin/env bash
# Qhull's Delaunay triangulation in R's geometry 0.4.7 (Debian 12: r-cran-geometry 0.4.7-1), SciPy 1.10.1 (python3-scipy
# 1.10.1-2) and Octave 7.3 (octave 7.3.0-2): fifty grains in a square of width 1, moved away from the origin as unwrapped
# positions are after much strain.
#
# Guess: all fifty are used until the distance eats up their digits, near 1e14; or there is an error or a warning before.
# Seen: geometry leaves out two at 1e4 and all but eleven, those of the rim, at 1e5; SciPy and Octave leave out a third at 1e6
# and the same at 1e7. No word of it, and the triangles still fill the hull at 1e5 and 1e7, so that the sum of their areas is
# right. Points are lifted to x^2 + y^2, which needs twice their digits, and what is then flat up to round-off is dropped. Take
# the mean off first, and count the points that are used.
#   points used (areas over that of the hull), at 0, 1e4, 1e5, 1e6, 1e7
#   geometry: 50 (1.00), 48 (1.00), 11 (1.00), 11 (1.00), 11 (1.00)
#   scipy: 50 (1.00), 50 (1.00), 50 (1.00), 34 (1.01), 11 (1.00)
#   octave: 50 (1.00), 50 (1.00), 50 (1.00), 35 (1.00), 11 (1.00)
set -euo pipefail
for wanted in r-cran-geometry=0.4.7-1 python3-scipy=1.10.1-2 octave=7.3.0-2; do
  version=$(dpkg-query -W -f='${Version}' "${wanted%%=*}" 2>/dev/null || true)
  [ "$version" = "${wanted#*=}" ] || { echo "needs ${wanted%%=*} ${wanted#*=}, found '${version:-none}'"; exit 77; }
done
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > triangulate.py <<'PYTHON'
import numpy
from scipy.spatial import Delaunay

points = numpy.random.RandomState(1).rand(50, 2)
numpy.savetxt("points.txt", points, fmt="%.17g")
for power in (0, 4, 5, 6, 7):
    numpy.savetxt(f"scipy{power}.txt", Delaunay(points + 10.0**power * (power > 0)).simplices + 1, fmt="%d")
PYTHON
cat > triangulate.R <<'R'
suppressMessages(library(geometry))
points <- as.matrix(read.table("points.txt"))
for (power in c(0, 4, 5, 6, 7)) {
  triangles <- delaunayn(points + 10^power * (power > 0))
  write.table(triangles, sprintf("geometry%d.txt", power), row.names = FALSE, col.names = FALSE)
}
R
cat > triangulate.m <<'OCTAVE'
points = load("points.txt");
for power = [0 4 5 6 7]
  moved = points + 10^power * (power > 0);
  dlmwrite(sprintf("octave%d.txt", power), delaunay(moved(:, 1), moved(:, 2)), " ");
end
OCTAVE
/usr/bin/python3 triangulate.py
Rscript --vanilla triangulate.R > messages 2>&1 || { cat messages; exit 1; }
octave-cli --no-init-file --quiet triangulate.m > messages 2>&1 || { cat messages; exit 1; }
/usr/bin/python3 - > seen <<'PYTHON'
import numpy
from scipy.spatial import ConvexHull

points = numpy.loadtxt("points.txt")
for name in ("geometry", "scipy", "octave"):
    words = []
    for power in (0, 4, 5, 6, 7):
        triangles = numpy.loadtxt(f"{name}{power}.txt", dtype=int) - 1
        a, b, c = (points[triangles[:, i]] for i in range(3))
        area = abs((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]).sum() / 2
        words.append(f"{len(numpy.unique(triangles))} ({area / ConvexHull(points).volume:.2f})")
    print(f"{name}: {', '.join(words)}")
PYTHON
cat seen
diff seen - <<'SEEN'
geometry: 50 (1.00), 48 (1.00), 11 (1.00), 11 (1.00), 11 (1.00)
scipy: 50 (1.00), 50 (1.00), 50 (1.00), 34 (1.01), 11 (1.00)
octave: 50 (1.00), 50 (1.00), 50 (1.00), 35 (1.00), 11 (1.00)
SEEN
