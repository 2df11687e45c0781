#!/usr/bin/env bash
# R 4.2.2, Octave 7.3, SciPy 1.10.1 (Debian 12: r-base-core 4.2.2.20221110-2, octave 7.3.0-2, python3-scipy 1.10.1-2),
# integrals as they come: the impulse of a contact, a force F sin(pi t)^1.5 for 0 < t < 1 and 0 after it, over 0 < t < 20, for
# F of 1 down to 1e-9, over F; exactly 0.556418.
#
# Guess: the same for each F, as the function is the same in other units.
# Seen: all have an absolute tolerance besides the relative one, and the looser of the two counts: 1.2e-4 in R, 1.5e-8 in
# SciPy, 1e-10 in Octave. In R a force of a millinewton is off by 1.2%, of a micronewton by 2%, with the message "OK"; at a
# nanonewton SciPy is off by 2%, `quad` of Octave by 9.6% and `integral` by 0.7%. Nothing warns. Give abs.tol = 0, epsabs = 0,
# AbsTol 0.
#   F 1: R 0.5564, SciPy 0.5564, Octave quad 0.5564, integral 0.5564
#   F 0.001: R 0.5630, SciPy 0.5564, Octave quad 0.5564, integral 0.5564
#   F 1e-06: R 0.5675, SciPy 0.5564, Octave quad 0.5564, integral 0.5564
#   F 1e-09: R 0.5675, SciPy 0.5675, Octave quad 0.6099, integral 0.5528
#   no absolute tolerance, F 1e-09: R 0.5564, SciPy 0.5564, Octave integral 0.5564
set -euo pipefail
for want in r-base-core=4.2.2.20221110-2 octave=7.3.0-2 python3-scipy=1.10.1-2; do
  version=$(dpkg-query -W -f='${Version}' "${want%%=*}" 2>/dev/null || true)
  [ "$version" = "${want#*=}" ] || { echo "needs ${want%%=*} ${want#*=}, found '${version:-none}'"; exit 77; }
done
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > impulse.R <<'R'
force <- function(t, F) F * pmax(sin(pi * t), 0)^1.5 * (t < 1)
for (F in c(1, 1e-3, 1e-6, 1e-9)) cat(sprintf("R %.4f\n", integrate(force, 0, 20, F = F)$value / F))
cat(sprintf("R %.4f\n", integrate(force, 0, 20, F = 1e-9, abs.tol = 0)$value / 1e-9))
R
cat > impulse.py <<'PYTHON'
import math

from scipy.integrate import quad


def impulse(F, **options):
    return quad(lambda t: F * max(math.sin(math.pi * t), 0) ** 1.5 * (t < 1), 0, 20, **options)[0] / F


for F in (1, 1e-3, 1e-6, 1e-9):
    print(f"SciPy {impulse(F):.4f}")
print(f"SciPy {impulse(1e-9, epsabs=0):.4f}")
PYTHON
cat > impulse.m <<'OCTAVE'
force = @(t, F) F * max(sin(pi * t), 0).^1.5 .* (t < 1);
for F = [1 1e-3 1e-6 1e-9]
  printf("Octave quad %.4f, integral %.4f\n", quad(@(t) force(t, F), 0, 20) / F, integral(@(t) force(t, F), 0, 20) / F);
end
printf("Octave integral %.4f\n", integral(@(t) force(t, 1e-9), 0, 20, "AbsTol", 0) / 1e-9);
OCTAVE
Rscript --vanilla impulse.R > R 2> messages || { cat messages; exit 1; }
/usr/bin/python3 impulse.py > scipy 2> messages || { cat messages; exit 1; }
octave-cli -q impulse.m > octave 2> messages || { cat messages; exit 1; }
printf '%s\n' "F 1" "F 0.001" "F 1e-06" "F 1e-09" "no absolute tolerance, F 1e-09" > names
paste -d '|' names R scipy octave | sed 's/|/: /; s/|/, /g' > seen
cat seen
diff seen - <<'SEEN'
F 1: R 0.5564, SciPy 0.5564, Octave quad 0.5564, integral 0.5564
F 0.001: R 0.5630, SciPy 0.5564, Octave quad 0.5564, integral 0.5564
F 1e-06: R 0.5675, SciPy 0.5564, Octave quad 0.5564, integral 0.5564
F 1e-09: R 0.5675, SciPy 0.5675, Octave quad 0.6099, integral 0.5528
no absolute tolerance, F 1e-09: R 0.5564, SciPy 0.5564, Octave integral 0.5564
SEEN
