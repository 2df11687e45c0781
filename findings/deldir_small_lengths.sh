#!/usr/bin/env bash
# deldir 1.0-6 of R (Debian 12: r-cran-deldir 1.0-6-1+b1): the Voronoi areas of fifty grains in a square, by the unit of length.
#
# Guess: the areas add up to that of the square, whatever the unit.
# Seen: in units of a millionth each area is 0, and corners of cells are 0 or 1e-6: what is returned is rounded to six decimals,
# not digits, unless `digits` is given. At a width of 1 the sum is already off by 2e-6. Far from the origin it is worse than
# round-off, without a word: at 1e8 the areas of a square of width 1 add up to a negative number.
#   width 1: sum of areas 1.000002 of the square, cells without area 0
#   width 1e-06: sum of areas 0.000000 of the square, cells without area 50
#   width 1e-06, digits = 30: sum of areas 1.000000 of the square, cells without area 0
#   width 1, origin at 1e8: a sum below zero
set -euo pipefail
want=1.0-6-1+b1
version=$(dpkg-query -W -f='${Version}' r-cran-deldir 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs r-cran-deldir $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > areas.R <<'R'
suppressMessages(library(deldir))
set.seed(1)
x <- runif(50)
y <- runif(50)
report <- function(name, width, ...) {
  areas <- deldir(x * width, y * width, rw = c(0, width, 0, width), ...)$summary$dir.area
  cat(sprintf("%s: sum of areas %.6f of the square, cells without area %d\n", name, sum(areas) / width^2, sum(areas == 0)))
}
report("width 1", 1)
report("width 1e-06", 1e-6)
report("width 1e-06, digits = 30", 1e-6, digits = 30)
far <- sum(deldir(x + 1e8, y + 1e8, rw = 1e8 + c(0, 1, 0, 1))$summary$dir.area)
cat("width 1, origin at 1e8:", if (far < 0) "a sum below zero" else far, "\n")
R
Rscript --vanilla areas.R 2>messages | sed 's/ *$//' > seen
cat seen
diff seen - <<'SEEN'
width 1: sum of areas 1.000002 of the square, cells without area 0
width 1e-06: sum of areas 0.000000 of the square, cells without area 50
width 1e-06, digits = 30: sum of areas 1.000000 of the square, cells without area 0
width 1, origin at 1e8: a sum below zero
SEEN
