#!/usr/bin/env bash
# sasmodels 1.0.6 (Debian 12: python3-sasmodels 1.0.6-2), the models of SasView, from Python: the scattering of spheres of radius 50
# with log-normal radii of width w, at q = 1e-4, where it is that of q = 0: 52.36 exp(13.5 w^2).
#
# Guess: radius_pd=w has this effect, to a percent, as only a few sizes are summed (radius_pd_n, 35 by default).
# Seen: radius_pd alone is ignored: the spheres are of one size unless radius_pd_n is given as well, the default of which is 0 here.
# With it the sizes end at three widths, which is 8% too little at w = 0.2 and a fifth of it at 0.5, as intensity goes with the
# sixth power of the radius; the 8 widths that the distribution has for its own default are not taken, and would be 40% too
# little. So a fit finds spheres that are too large or too unequal. A name that no model has (radius_dp) is ignored, too. No
# error or warning in any case.
#   width 0.2: true 89.8, radius_pd 52.4, with radius_pd_n=35 82.5, and radius_pd_nsigma=8 88.8
#   width 0.5: true 1530.2, radius_pd 52.4, with radius_pd_n=35 306.0, and radius_pd_nsigma=8 889.4
#   radius_dp=0.5 52.4
set -euo pipefail
want=1.0.6-2
version=$(dpkg-query -W -f='${Version}' python3-sasmodels 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs python3-sasmodels $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > spheres.py <<'PYTHON'
import math

import numpy
from sasmodels.core import load_model
from sasmodels.data import empty_data1D
from sasmodels.direct_model import DirectModel

intensity = DirectModel(empty_data1D(numpy.array([1e-4])), load_model("sphere"))


def at_zero(**more):
    return intensity(radius=50, sld=1, sld_solvent=0, scale=1, background=0, radius_pd_type="lognormal", **more)[0]


for width in (0.2, 0.5):
    print(f"width {width}: true {at_zero() * math.exp(13.5 * width**2):.1f}, radius_pd {at_zero(radius_pd=width):.1f}, "
          f"with radius_pd_n=35 {at_zero(radius_pd=width, radius_pd_n=35):.1f}, and radius_pd_nsigma=8 "
          f"{at_zero(radius_pd=width, radius_pd_n=1000, radius_pd_nsigma=8):.1f}")
print(f"radius_dp=0.5 {at_zero(radius_dp=0.5, radius_pd_n=35):.1f}")
PYTHON
SAS_OPENCL=none /usr/bin/python3 spheres.py > seen 2> messages || { cat messages; exit 1; }
cat messages seen
[ ! -s messages ]
diff seen - <<'SEEN'
width 0.2: true 89.8, radius_pd 52.4, with radius_pd_n=35 82.5, and radius_pd_nsigma=8 88.8
width 0.5: true 1530.2, radius_pd 52.4, with radius_pd_n=35 306.0, and radius_pd_nsigma=8 889.4
radius_dp=0.5 52.4
SEEN
