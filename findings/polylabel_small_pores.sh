#!/usr/bin/env bash
# polylabel 2.1.0 (npm) and shapely.ops.polylabel of Shapely 1.8.5 (Debian 12: python3-shapely 1.8.5-2+b1): the largest circle
# in a pore, here a triangle of corners (0, 0), (s, 0), (0, s), for pores of several sizes s, without more arguments, and with a
# precision of s / 10000. Printed are its radius and place, over s; true are 0.2929 s and (0.2929 s, 0.2929 s).
#
# Guess: the default precision is meant for the size, so that the numbers are the same for each s.
# Seen: the default is 1, in the units of the corners. Of a pore with a side of 1 or less, as where lengths are diameters of
# grains or in SI, polylabel hands back a corner of its bounding box and the radius 0, as if it had no room at all; Shapely has
# the centre of mass and a radius that is 20% too small, the same up to a size of 2, and 9% at 10. Nothing is said.
#   polylabel, s = 100: 0.2928 at (0.2930, 0.2930), by precision 0.2929 at (0.2929, 0.2929)
#   polylabel, s = 10: 0.2652 at (0.3125, 0.3125), by precision 0.2929 at (0.2929, 0.2929)
#   polylabel, s = 2: 0.2357 at (0.3333, 0.3333), by precision 0.2929 at (0.2929, 0.2929)
#   polylabel, s = 1: 0.0000 at (0.0000, 0.0000), by precision 0.2929 at (0.2929, 0.2929)
#   polylabel, s = 0.01: 0.0000 at (0.0000, 0.0000), by precision 0.2929 at (0.2929, 0.2929)
#   Shapely, s = 100: 0.2928 at (0.2930, 0.2930), by precision 0.2929 at (0.2929, 0.2929)
#   Shapely, s = 10: 0.2652 at (0.3125, 0.3125), by precision 0.2929 at (0.2929, 0.2929)
#   Shapely, s = 2: 0.2357 at (0.3333, 0.3333), by precision 0.2929 at (0.2929, 0.2929)
#   Shapely, s = 1: 0.2357 at (0.3333, 0.3333), by precision 0.2929 at (0.2929, 0.2929)
#   Shapely, s = 0.01: 0.2357 at (0.3333, 0.3333), by precision 0.2929 at (0.2929, 0.2929)
set -euo pipefail
want=1.8.5-2+b1
version=$(dpkg-query -W -f='${Version}' python3-shapely 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs python3-shapely $want, found '${version:-none}'"; exit 77; }
command -v npm >/dev/null || { echo "needs npm"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-save --ignore-scripts --prefix . polylabel@2.1.0 >/dev/null
cat > pore.mjs <<'NODE'
import polylabel from 'polylabel';
for (const s of [100, 10, 2, 1, 0.01]) {
  const pore = [[[0, 0], [s, 0], [0, s], [0, 0]]];
  const words = [polylabel(pore), polylabel(pore, s / 10000)]
    .map((circle) => `${(circle.distance / s).toFixed(4)} at (${[...circle].map((x) => (x / s).toFixed(4)).join(', ')})`);
  console.log(`polylabel, s = ${s}: ${words[0]}, by precision ${words[1]}`);
}
NODE
cat > pore.py <<'PYTHON'
from shapely.geometry import Polygon
from shapely.ops import polylabel

for s in (100, 10, 2, 1, 0.01):
    pore = Polygon([(0, 0), (s, 0), (0, s)])
    words = []
    for centre in (polylabel(pore), polylabel(pore, s / 10000)):
        words.append(f"{centre.distance(pore.exterior) / s:.4f} at ({centre.x / s:.4f}, {centre.y / s:.4f})")
    print(f"Shapely, s = {s}: {words[0]}, by precision {words[1]}")
PYTHON
{ node pore.mjs && /usr/bin/python3 pore.py; } > seen 2> messages || { cat messages; exit 1; }
cat seen
diff seen - <<'SEEN'
polylabel, s = 100: 0.2928 at (0.2930, 0.2930), by precision 0.2929 at (0.2929, 0.2929)
polylabel, s = 10: 0.2652 at (0.3125, 0.3125), by precision 0.2929 at (0.2929, 0.2929)
polylabel, s = 2: 0.2357 at (0.3333, 0.3333), by precision 0.2929 at (0.2929, 0.2929)
polylabel, s = 1: 0.0000 at (0.0000, 0.0000), by precision 0.2929 at (0.2929, 0.2929)
polylabel, s = 0.01: 0.0000 at (0.0000, 0.0000), by precision 0.2929 at (0.2929, 0.2929)
Shapely, s = 100: 0.2928 at (0.2930, 0.2930), by precision 0.2929 at (0.2929, 0.2929)
Shapely, s = 10: 0.2652 at (0.3125, 0.3125), by precision 0.2929 at (0.2929, 0.2929)
Shapely, s = 2: 0.2357 at (0.3333, 0.3333), by precision 0.2929 at (0.2929, 0.2929)
Shapely, s = 1: 0.2357 at (0.3333, 0.3333), by precision 0.2929 at (0.2929, 0.2929)
Shapely, s = 0.01: 0.2357 at (0.3333, 0.3333), by precision 0.2929 at (0.2929, 0.2929)
SEEN
