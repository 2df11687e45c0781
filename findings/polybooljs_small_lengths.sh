#!/usr/bin/env bash
# polybooljs 1.2.2 (npm): the union and the overlap of two equal polygons of 64 corners, their centres 1.3 radii apart, by the
# radius.
#
# Guess: areas by the square of the radius, from 1 to 1e-10: a grain is the same in metres as in diameters.
# Seen: so at 1. From 1e-4 to 1e-8 it is an exception, and at 1e-9 union and overlap are both empty, without a word: grains of a
# colloid in metres have no area. A length of 1e-10 counts as none, whatever the size of the polygons. Divide by a diameter
# first. polygon-clipping 0.15.7 is right at each size.
#   radius 1: union 5.53739, overlap 0.73571; polygon-clipping: union 5.53739, overlap 0.73571
#   radius 1e-7: Error; polygon-clipping: union 5.53739, overlap 0.73571
#   radius 1e-9: union 0.00000, overlap 0.00000; polygon-clipping: union 5.53739, overlap 0.73571
set -euo pipefail
command -v npm >/dev/null || { echo "needs npm"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-save --ignore-scripts --prefix . polybooljs@1.2.2 polygon-clipping@0.15.7 >/dev/null
cat > areas.mjs <<'NODE'
import polybool from 'polybooljs';
import clipping from 'polygon-clipping';
const ring = (x, radius) => Array.from({ length: 64 }, (_, i) =>
  [x + radius * Math.cos(i * Math.PI / 32), radius * Math.sin(i * Math.PI / 32)]);
const area = (ring) => Math.abs(ring.reduce((sum, a, i) => {
  const b = ring[(i + 1) % ring.length];
  return sum + (a[0] * b[1] - a[1] * b[0]) / 2;
}, 0));
const total = (rings, radius) => (rings.reduce((sum, ring) => sum + area(ring), 0) / radius ** 2).toFixed(5);
for (const radius of [1, 1e-7, 1e-9]) {
  const [first, second] = [ring(0, radius), ring(1.3 * radius, radius)];
  const [a, b] = [{ regions: [first], inverted: false }, { regions: [second], inverted: false }];
  let said;
  try {
    said = `union ${total(polybool.union(a, b).regions, radius)}, overlap ${total(polybool.intersect(a, b).regions, radius)}`;
  } catch (error) {
    said = error.name;
  }
  const union = total(clipping.union([first], [second]).flat(), radius);
  const overlap = total(clipping.intersection([first], [second]).flat(), radius);
  console.log(`radius ${radius}: ${said}; polygon-clipping: union ${union}, overlap ${overlap}`);
}
NODE
node areas.mjs > seen
cat seen
diff seen - <<'SEEN'
radius 1: union 5.53739, overlap 0.73571; polygon-clipping: union 5.53739, overlap 0.73571
radius 1e-7: Error; polygon-clipping: union 5.53739, overlap 0.73571
radius 1e-9: union 0.00000, overlap 0.00000; polygon-clipping: union 5.53739, overlap 0.73571
SEEN
