#!/usr/bin/env bash
# deSolve 1.34 of R (Debian 12: r-cran-desolve 1.34-1): the time at which an oscillator of frequency 1 that starts at 1 first passes
# zero, pi / 2, and a grain that falls from height 1 at gravity 1 touches the ground, sqrt(2): a rootfunc with method "radau".
#
# Guess: the time to within the tolerance, as method "lsoda" has it.
# Seen: radau stops with the state of that moment and the time of a later one, by most of an interval of the output times or less,
# both in attribute troot and in the last row, where height, velocity and energy are right to many digits, so that no check of
# them shows it: with outputs 0.5 apart a fall of 1.41 takes 1.80. A smaller tolerance helps only where it makes the steps shorter
# than that interval. Where the root is an event that goes on (events, root = TRUE) the times are right.
#   oscillator, lsoda, tolerance 1e-06, outputs 0.1 apart: troot 1.57079, last row 1.57079, height 0.00000, velocity -1.00000 (true time 1.57080)
#   oscillator, radau, tolerance 1e-06, outputs 0.1 apart: troot 1.63745, last row 1.63745, height 0.00000, velocity -1.00000 (true time 1.57080)
#   oscillator, radau, tolerance 1e-10, outputs 0.1 apart: troot 1.57475, last row 1.57475, height 0.00000, velocity -1.00000 (true time 1.57080)
#   fall, radau, tolerance 1e-06, outputs 0.5 apart: troot 1.79959, last row 1.79959, height 0.00000, velocity -1.41421 (true time 1.41421)
#   fall, radau, tolerance 1e-06, outputs 0.1 apart: troot 1.43745, last row 1.43745, height 0.00000, velocity -1.41421 (true time 1.41421)
#   fall, radau, tolerance 1e-06, outputs 0.01 apart: troot 1.41468, last row 1.41468, height 0.00000, velocity -1.41421 (true time 1.41421)
#   fall, radau, as an event: troot 1.41421 4.24264 
set -euo pipefail
want=1.34-1
version=$(dpkg-query -W -f='${Version}' r-cran-desolve 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs r-cran-desolve $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > roots.R <<'R'
library(deSolve)
oscillator <- function(time, state, ...) list(c(state[2], -state[1]))
fall <- function(time, state, ...) list(c(state[2], -1))
show <- function(name, motion, truth, method, tolerance, every) {
  run <- ode(c(1, 0), seq(0, 3, every), motion, NULL, method = method, rtol = tolerance, atol = tolerance,
             rootfunc = function(time, state, ...) state[1])
  end <- run[nrow(run), ]
  cat(sprintf("%s, %s, tolerance %g, outputs %g apart: troot %.5f, last row %.5f, height %.5f, velocity %.5f (true time %.5f)\n",
              name, method, tolerance, every, attributes(run)$troot, end[1], abs(end[2]), end[3], truth))
}
for (method in c("lsoda", "radau")) show("oscillator", oscillator, pi / 2, method, 1e-6, 0.1)
show("oscillator", oscillator, pi / 2, "radau", 1e-10, 0.1)
for (every in c(0.5, 0.1, 0.01)) show("fall", fall, sqrt(2), "radau", 1e-6, every)
bounce <- ode(c(1, 0), seq(0, 5, 0.1), fall, NULL, method = "radau", rootfunc = function(time, state, ...) state[1],
              events = list(func = function(time, state, ...) c(0, -state[2]), root = TRUE))
cat("fall, radau, as an event: troot", sprintf("%.5f", attributes(bounce)$troot), "\n")
R
Rscript --vanilla roots.R > seen 2> messages || { cat messages; exit 1; }
cat seen
diff seen - <<'SEEN'
oscillator, lsoda, tolerance 1e-06, outputs 0.1 apart: troot 1.57079, last row 1.57079, height 0.00000, velocity -1.00000 (true time 1.57080)
oscillator, radau, tolerance 1e-06, outputs 0.1 apart: troot 1.63745, last row 1.63745, height 0.00000, velocity -1.00000 (true time 1.57080)
oscillator, radau, tolerance 1e-10, outputs 0.1 apart: troot 1.57475, last row 1.57475, height 0.00000, velocity -1.00000 (true time 1.57080)
fall, radau, tolerance 1e-06, outputs 0.5 apart: troot 1.79959, last row 1.79959, height 0.00000, velocity -1.41421 (true time 1.41421)
fall, radau, tolerance 1e-06, outputs 0.1 apart: troot 1.43745, last row 1.43745, height 0.00000, velocity -1.41421 (true time 1.41421)
fall, radau, tolerance 1e-06, outputs 0.01 apart: troot 1.41468, last row 1.41468, height 0.00000, velocity -1.41421 (true time 1.41421)
fall, radau, as an event: troot 1.41421 4.24264 
SEEN
