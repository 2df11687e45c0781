#!/usr/bin/env bash
# circular 0.4-95 of R (Debian 12: r-cran-circular 0.4-95-1): the axes of 1000 rods, which scatter about the x axis with a
# standard deviation of 20 degrees, as angles from 0 to 180 degrees, without and with the modulo "pi" and the type "directions";
# and the same by hand, with the angles doubled and the answers halved. True are about 0 degrees, 20 degrees and an order of
# exp(-2 (20 degrees)^2), which is 0.784.
#
# Guess: data with the modulo pi are axes, and spreads are in degrees as the data and the mean are.
# Seen: the modulo changes nothing, so that the mean axis of rods along x is about y, 97 degrees, next to no order is left, and
# the fit of von Mises agrees with it. The type, which the manual calls not used yet, doubles the mean once it has been made, 97
# to 14. Spreads are in radians, while means, medians and ranges are in the degrees of the data: rods that scatter by 20.7
# degrees have a standard deviation of 0.361.
#   axes: mean 97.2, median 134.3, order 0.277, kappa 0.58
#   axes, modulo pi: mean 97.2, median 134.3, order 0.277, kappa 0.58
#   axes, modulo pi, directions: mean 14.3, median 88.5, order 0.277, kappa 0.58
#   axes, doubled by hand: mean -0.2, median -0.7, order 0.771, kappa 2.54
#   angles in degrees: mean -0.22, range 136.4
#     spreads: sd 0.361, angular.deviation 0.355, meandeviation 0.287; sd of plain numbers 20.7
set -euo pipefail
want=0.4-95-1
version=$(dpkg-query -W -f='${Version}' r-cran-circular 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs r-cran-circular $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > axes.R <<'R'
suppressMessages(library(circular))
set.seed(1)
scatter <- rnorm(1000, sd = 20)
show <- function(name, angles, factor = 1) {
  fit <- mle.vonmises(angles)
  cat(sprintf("%s: mean %.1f, median %.1f, order %.3f, kappa %.2f\n", name, mean(angles) / factor, median(angles) / factor,
    rho.circular(angles), fit$kappa))
}
axes <- scatter %% 180
show("axes", circular(axes, units = "degrees"))
show("axes, modulo pi", circular(axes, units = "degrees", modulo = "pi"))
show("axes, modulo pi, directions", circular(axes, units = "degrees", modulo = "pi", type = "directions"))
show("axes, doubled by hand", circular(2 * axes, units = "degrees"), 2)
angles <- circular(scatter, units = "degrees")
cat(sprintf("angles in degrees: mean %.2f, range %.1f\n", mean(angles), range(angles)))
cat(sprintf("  spreads: sd %.3f, angular.deviation %.3f, meandeviation %.3f; sd of plain numbers %.1f\n", sd(angles),
  angular.deviation(angles), meandeviation(angles), stats::sd(scatter)))
R
Rscript --vanilla axes.R > seen 2> messages || { cat messages; exit 1; }
cat seen
diff seen - <<'SEEN'
axes: mean 97.2, median 134.3, order 0.277, kappa 0.58
axes, modulo pi: mean 97.2, median 134.3, order 0.277, kappa 0.58
axes, modulo pi, directions: mean 14.3, median 88.5, order 0.277, kappa 0.58
axes, doubled by hand: mean -0.2, median -0.7, order 0.771, kappa 2.54
angles in degrees: mean -0.22, range 136.4
  spreads: sd 0.361, angular.deviation 0.355, meandeviation 0.287; sd of plain numbers 20.7
SEEN
