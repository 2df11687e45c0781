#!/usr/bin/env bash
# numDeriv 2016.8-1.1 of R (Debian 12: r-cran-numderiv 2016.8-1.1-3), hessian: the stiffness of one contact of two grains of
# diameter 1 on a line, of energy overlap^2 / 2, so that it is 1, at an overlap of 0.1, for several places of the first grain; and
# of grains with a diameter of 1e-6.
#
# Guess: 1 everywhere, to some eight digits, as the energy is a parabola and has one at every place.
# Seen: the first step of the extrapolation is a tenth of each coordinate, so that from 10 on the steps open the contact, and the
# number is a mean over grains that touch and grains that do not: 0.19 at 100, and at 1000 the contact has no stiffness. No
# warning, and the gradient (grad) is right. Where a coordinate is below 1.8e-5 the step is 1e-4, a hundred grains of a
# micrometre, which have neither a force nor a stiffness. With method.args = list(d = 1e-5) it is right at 1000.
#   diameter 1 at 0: force 1.000, stiffness 1.000
#   diameter 1 at 1: force 1.000, stiffness 1.000
#   diameter 1 at 2: force 1.000, stiffness 1.000
#   diameter 1 at 5: force 1.000, stiffness 1.004
#   diameter 1 at 10: force 1.000, stiffness 1.047
#   diameter 1 at 30: force 1.000, stiffness 0.761
#   diameter 1 at 100: force 1.000, stiffness 0.187
#   diameter 1 at 1000: force 1.000, stiffness -0.000
#   diameter 1e-06 at 1e-06: force -0.000, stiffness -0.000
#   diameter 1e-06 at 0.001: force 1.000, stiffness -0.000
#   with d = 1e-5:
#   diameter 1 at 1000: force 1.000, stiffness 1.000
set -euo pipefail
want=2016.8-1.1-3
version=$(dpkg-query -W -f='${Version}' r-cran-numderiv 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs r-cran-numderiv $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > stiffness.R <<'R'
library(numDeriv)
show <- function(place, diameter, ...) {
  energy <- function(x) max(0, diameter - abs(x[2] - x[1]))^2 / 2
  x <- c(place, place + 0.9 * diameter)
  force <- grad(energy, x)[2] / (-0.1 * diameter)
  cat(sprintf("diameter %g at %g: force %.3f, stiffness %.3f\n", diameter, place, force, hessian(energy, x, ...)[1, 1]))
}
for (place in c(0, 1, 2, 5, 10, 30, 100, 1000)) show(place, 1)
show(1e-6, 1e-6)
show(1e-3, 1e-6)
cat("with d = 1e-5:\n")
show(1000, 1, method.args = list(d = 1e-5))
R
Rscript --vanilla stiffness.R > seen 2> messages || { cat messages; exit 1; }
cat seen
diff seen - <<'SEEN'
diameter 1 at 0: force 1.000, stiffness 1.000
diameter 1 at 1: force 1.000, stiffness 1.000
diameter 1 at 2: force 1.000, stiffness 1.000
diameter 1 at 5: force 1.000, stiffness 1.004
diameter 1 at 10: force 1.000, stiffness 1.047
diameter 1 at 30: force 1.000, stiffness 0.761
diameter 1 at 100: force 1.000, stiffness 0.187
diameter 1 at 1000: force 1.000, stiffness -0.000
diameter 1e-06 at 1e-06: force -0.000, stiffness -0.000
diameter 1e-06 at 0.001: force 1.000, stiffness -0.000
with d = 1e-5:
diameter 1 at 1000: force 1.000, stiffness 1.000
SEEN
