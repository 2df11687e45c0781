#!/usr/bin/env bash
# rgl 1.0.1 of R (Debian 12: r-cran-rgl 1.0.1-1): subdivision3d, which makes round grains of polyhedra.
#
# Guess: the coordinates are the first three rows of $vb; normalize = TRUE only changes how they are stored, or puts them on the
# unit sphere; the surface is that of Loop, of volume 2.377 after three refinements.
# Seen: the fourth row, 1 in the solids of rgl, grows to 7e8 after five refinements, and differs from point to point: the first
# three are the coordinates times it. normalize = TRUE divides by it each time, but it is also a weight of the next step, so that
# this is another shape with a volume larger by 14%. Neither is a sphere or the surface of Loop: volumes 2.275 and 2.586. Divide
# by $vb[4,], or refine with deform = FALSE and put the points on the sphere yourself.
#   icosahedron: $vb[4,] 1 to 1, radii of $vb[1:3,] 1.2 to 1.2, of points 1.176 to 1.176, volume 4.120
#   depth 1, FALSE: $vb[4,] 45 to 60, radii of $vb[1:3,] 40 to 54, of points 0.887 to 0.898, volume 2.627
#   depth 1, TRUE: $vb[4,] 15 to 18, radii of $vb[1:3,] 14 to 16, of points 0.915 to 0.959, volume 2.900
#   depth 3, FALSE: $vb[4,] 1.2e+05 to 2.1e+05, radii of $vb[1:3,] 1e+05 to 1.7e+05, of points 0.812 to 0.822, volume 2.275
#   depth 3, TRUE: $vb[4,] 15 to 18, radii of $vb[1:3,] 13 to 16, of points 0.845 to 0.875, volume 2.586
#   depth 5, FALSE: $vb[4,] 3.5e+08 to 7.2e+08, radii of $vb[1:3,] 2.9e+08 to 5.9e+08, of points 0.809 to 0.817, volume 2.255
#   depth 5, TRUE: $vb[4,] 15 to 18, radii of $vb[1:3,] 13 to 16, of points 0.841 to 0.869, volume 2.568
set -euo pipefail
want=1.0.1-1
version=$(dpkg-query -W -f='${Version}' r-cran-rgl 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs r-cran-rgl $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > refine.R <<'R'
options(rgl.useNULL = TRUE)
suppressWarnings(suppressMessages(library(rgl)))
volume <- function(points, corners) {
  a <- points[, corners[1, ]]; b <- points[, corners[2, ]]; c <- points[, corners[3, ]]
  sum(a[1, ] * (b[2, ] * c[3, ] - b[3, ] * c[2, ]) + a[2, ] * (b[3, ] * c[1, ] - b[1, ] * c[3, ]) +
      a[3, ] * (b[1, ] * c[2, ] - b[2, ] * c[1, ])) / 6
}
look <- function(name, mesh) {
  points <- sweep(mesh$vb[1:3, ], 2, mesh$vb[4, ], "/")
  radii <- sqrt(colSums(points^2))
  cat(sprintf("%s: $vb[4,] %.2g to %.2g, radii of $vb[1:3,] %.2g to %.2g, of points %.3f to %.3f, volume %.3f\n", name,
              min(mesh$vb[4, ]), max(mesh$vb[4, ]), min(sqrt(colSums(mesh$vb[1:3, ]^2))), max(sqrt(colSums(mesh$vb[1:3, ]^2))),
              min(radii), max(radii), volume(points, mesh$it)))
}
look("icosahedron", icosahedron3d())
for (depth in c(1, 3, 5)) for (normalize in c(FALSE, TRUE))
  look(sprintf("depth %d, %s", depth, normalize), subdivision3d(icosahedron3d(), depth, normalize = normalize))
R
Rscript --vanilla refine.R > seen 2> messages || { cat messages; exit 1; }
cat seen
diff seen - <<'SEEN'
icosahedron: $vb[4,] 1 to 1, radii of $vb[1:3,] 1.2 to 1.2, of points 1.176 to 1.176, volume 4.120
depth 1, FALSE: $vb[4,] 45 to 60, radii of $vb[1:3,] 40 to 54, of points 0.887 to 0.898, volume 2.627
depth 1, TRUE: $vb[4,] 15 to 18, radii of $vb[1:3,] 14 to 16, of points 0.915 to 0.959, volume 2.900
depth 3, FALSE: $vb[4,] 1.2e+05 to 2.1e+05, radii of $vb[1:3,] 1e+05 to 1.7e+05, of points 0.812 to 0.822, volume 2.275
depth 3, TRUE: $vb[4,] 15 to 18, radii of $vb[1:3,] 13 to 16, of points 0.845 to 0.875, volume 2.586
depth 5, FALSE: $vb[4,] 3.5e+08 to 7.2e+08, radii of $vb[1:3,] 2.9e+08 to 5.9e+08, of points 0.809 to 0.817, volume 2.255
depth 5, TRUE: $vb[4,] 15 to 18, radii of $vb[1:3,] 13 to 16, of points 0.841 to 0.869, volume 2.568
SEEN
