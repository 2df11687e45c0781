#!/usr/bin/env bash
# meshio 7.0.0 (Debian 12: python3-meshio 7.0.0-3) and rgl 1.0.1 of R (r-cran-rgl 1.0.1-1) reading two unit cubes, 3 apart, from
# an OBJ file with relative indices: each cube is its vertices and then its faces, and -1 is the last vertex so far, as the
# format has it and as some programs write it. The same file with indices from 1 is the check.
#
# Guess: the same two cubes, or an error.
# Seen: meshio takes one off every index, the negative ones as well, and leaves them negative: -1 is -2, which NumPy counts from
# the end of all points. Corners are those of another vertex of, mostly, another grain, without a word: both volumes are 0
# in place of 1. A grain alone in its file is an error of the index, if its first vertex is used. rgl hands on the indices as
# they stand, though for R a negative one means all but this.
#   from 1, meshio: indices 0 to 15, volumes 1.00 and 1.00
#   relative, meshio: indices -9 to -2, volumes 0.00 and 0.00
#   from 1, rgl: indices 1 to 16
#   relative, rgl: indices -8 to -1
set -euo pipefail
for pair in python3-meshio=7.0.0-3 r-cran-rgl=1.0.1-1; do
  version=$(dpkg-query -W -f='${Version}' "${pair%%=*}" 2>/dev/null || true)
  [ "$version" = "${pair#*=}" ] || { echo "needs ${pair%%=*} ${pair#*=}, found '${version:-none}'"; exit 77; }
done
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > cubes.py <<'PYTHON'
import meshio
import numpy

sides = ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3))
faces = [corners for a, b, c, d in sides for corners in ((a, b, c), (a, c, d))]
for relative in (False, True):
    lines = []
    for cube in range(2):
        lines += [f"v {x + 3 * cube} {y} {z}" for x in (0, 1) for y in (0, 1) for z in (0, 1)]
        lines += ["f " + " ".join(str(n - 8 if relative else n + 8 * cube + 1) for n in face) for face in faces]
    with open("relative.obj" if relative else "absolute.obj", "w") as file:
        file.write("\n".join(lines) + "\n")

for name in ("absolute", "relative"):
    mesh = meshio.read(f"{name}.obj")
    triangles = mesh.cells_dict["triangle"].astype(int)
    a, b, c = (mesh.points[triangles[:, k]] for k in range(3))
    parts = (a * numpy.cross(b, c)).sum(axis=1) / 6
    print(f"SEEN {'relative' if name == 'relative' else 'from 1'}, meshio: indices {triangles.min()} to {triangles.max()}, "
          f"volumes {parts[:12].sum():.2f} and {parts[12:].sum():.2f}")
PYTHON
/usr/bin/python3 cubes.py > messages 2>&1 || { cat messages; exit 1; }
cat > cubes.R <<'R'
options(rgl.useNULL = TRUE)
suppressMessages(library(rgl))
for (name in c("absolute", "relative")) {
  mesh <- readOBJ(paste0(name, ".obj"))
  cat(sprintf("SEEN %s, rgl: indices %d to %d\n", if (name == "relative") name else "from 1", min(mesh$it), max(mesh$it)))
}
R
Rscript --vanilla cubes.R >> messages 2>&1 || { cat messages; exit 1; }
sed -n 's/^SEEN //p' messages > seen
cat seen
diff seen - <<'SEEN'
from 1, meshio: indices 0 to 15, volumes 1.00 and 1.00
relative, meshio: indices -9 to -2, volumes 0.00 and 0.00
from 1, rgl: indices 1 to 16
relative, rgl: indices -8 to -1
SEEN
