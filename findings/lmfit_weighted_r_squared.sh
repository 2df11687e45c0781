#!/usr/bin/env bash
# lmfit 1.1.0 (Debian 12: python3-lmfit 1.1.0-1), Model.fit with weights = 1 / error bar, as its manual says: the flow curve of a
# yield-stress fluid, stress = yield + k rate^0.5, and a straight line through the same points, by the units of the stress. The
# error bars are the same for all points, so that the fits do not depend on them.
#
# Guess: R-squared of the right law is next to 1, that of the line smaller, and both have no units.
# Seen: `rsquared`, also in `fit_report()`, sets the weighted residuals against the stresses as they are, and so is
# 1 - (1 - R^2) / error^2 by the number that the error bar is: in Pa a straight line has 0.994 for 0.904, and in kPa the right law
# has -78. Without weights it is right. The parameters, their errors and chi-square are right.
#   Pa, no weights: right law 0.9987 (true 0.9987), line 0.9039 (true 0.9039)
#   Pa, weights 1 / error bar: right law 0.9999 (true 0.9987), line 0.9940 (true 0.9039)
#   kPa, no weights: right law 0.9987 (true 0.9987), line 0.9039 (true 0.9039)
#   kPa, weights 1 / error bar: right law -78.0796 (true 0.9987), line -6007.1375 (true 0.9039)
set -euo pipefail
want=1.1.0-1
version=$(dpkg-query -W -f='${Version}' python3-lmfit 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs python3-lmfit $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > flow.py <<'PYTHON'
import numpy
from lmfit import Model

generator = numpy.random.default_rng(1)
rate = numpy.logspace(-2, 2, 41)
error = 4.0
stress = 100 + 40 * rate**0.5 + error * generator.normal(size=rate.size)
law = Model(lambda rate, rest, k: rest + k * rate**0.5, independent_vars=["rate"])
line = Model(lambda rate, rest, k: rest + k * rate, independent_vars=["rate"])
for units, factor in (("Pa", 1), ("kPa", 1e-3)):
    for name, weights in (("no weights", None), ("weights 1 / error bar", 1 / (error * factor))):
        answers = []
        for model in (law, line):
            fit = model.fit(stress * factor, rate=rate, rest=factor, k=factor, weights=weights)
            residual = stress * factor - fit.best_fit
            spread = stress * factor - factor * stress.mean()
            answers.append(f"{fit.rsquared:.4f} (true {1 - (residual**2).sum() / (spread**2).sum():.4f})")
        print(f"{units}, {name}: right law {answers[0]}, line {answers[1]}")
PYTHON
/usr/bin/python3 flow.py > seen 2> messages || { cat messages; exit 1; }
cat seen
diff seen - <<'SEEN'
Pa, no weights: right law 0.9987 (true 0.9987), line 0.9039 (true 0.9039)
Pa, weights 1 / error bar: right law 0.9999 (true 0.9987), line 0.9940 (true 0.9039)
kPa, no weights: right law 0.9987 (true 0.9987), line 0.9039 (true 0.9039)
kPa, weights 1 / error bar: right law -78.0796 (true 0.9987), line -6007.1375 (true 0.9039)
SEEN
