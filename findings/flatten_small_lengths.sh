#!/usr/bin/env bash
# @flatten-js/core 1.6.15 (npm): two regular hexagons, turned by 0.1 and 0.37, next to each other and overlapping: their distance
# and the area they share, over the radius and its square, for radii of 1 down to 1e-5; and whether two circles touch whose
# centres are 2.5 radii apart.
#
# Guess: the same ratios for any length.
# Seen: the distance of hexagons of 1e-3, a millimetre in metres, is 0.37 or so where it is 0.591, and from 1e-3 on always:
# lengths are compared with 1e-6, squared or not. At 0.003 it begins to be off. Overlaps hold out to 1e-4; at 1e-5 what these
# two share is a whole hexagon, 2.598. Circles of 1e-6 with a gap of half a radius touch. No error, no warning. Distances are
# right after Utils.setTolerance(1e-14).
#   radius 1: distance 0.591, overlap 0.392, circles apart
#   radius 0.01: distance 0.591, overlap 0.392, circles apart
#   radius 0.003: distance 0.588, overlap 0.392, circles apart
#   radius 0.001: distance 0.371, overlap 0.392, circles apart
#   radius 0.0001: distance 0.371, overlap 0.392, circles apart
#   radius 0.00001: distance 0.371, overlap 2.598, circles apart
#   radius 0.000001: circles touch
set -euo pipefail
command -v npm >/dev/null || { echo "needs npm"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-save --ignore-scripts --prefix . @flatten-js/core@1.6.15 >/dev/null
cat > hexagons.mjs <<'NODE'
import flatten from '@flatten-js/core';
const { BooleanOperations, Circle, Polygon, point } = flatten;
function hexagon(radius, x, y, turn) {
  const angles = Array.from({ length: 6 }, (_, k) => turn + (2 * Math.PI * k) / 6);
  return new Polygon(angles.map((a) => [radius * (x + Math.cos(a)), radius * (y + Math.sin(a))]));
}
for (const radius of [1, 0.01, 0.003, 1e-3, 1e-4, 1e-5, 1e-6]) {
  const circles = new Circle(point(0, 0), radius).intersect(new Circle(point(2.5 * radius, 0), radius)).length;
  const touch = `circles ${circles ? 'touch' : 'apart'}`;
  const name = `radius ${radius === 1e-5 ? '0.00001' : radius}`;
  if (radius < 1e-5) {
    console.log(`${name}: ${touch}`);
    continue;
  }
  const grain = hexagon(radius, 0, 0, 0.1);
  const distance = grain.distanceTo(hexagon(radius, 2.5, 0.3, 0.37))[0] / radius;
  const overlap = BooleanOperations.intersect(grain, hexagon(radius, 1.3, 0.3, 0.37)).area() / radius ** 2;
  console.log(`${name}: distance ${distance.toFixed(3)}, overlap ${overlap.toFixed(3)}, ${touch}`);
}
NODE
node hexagons.mjs > seen
cat seen
diff seen - <<'SEEN'
radius 1: distance 0.591, overlap 0.392, circles apart
radius 0.01: distance 0.591, overlap 0.392, circles apart
radius 0.003: distance 0.588, overlap 0.392, circles apart
radius 0.001: distance 0.371, overlap 0.392, circles apart
radius 0.0001: distance 0.371, overlap 0.392, circles apart
radius 0.00001: distance 0.371, overlap 2.598, circles apart
radius 0.000001: circles touch
SEEN
