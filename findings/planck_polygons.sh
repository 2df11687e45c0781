#!/usr/bin/env bash
# Planck 1.5.0 (npm: planck), rigid bodies in two dimensions: the mass of polygons, and how far apart they rest.
#
# Guess: the mass is density times area; what is not convex, too small or has too many corners is an error; grains that are
# pushed together touch.
# Seen: only the first twelve corners count, so a regular 24-gon in place of a disc has 42% of its mass, a 48-gon 7%; a star is
# its convex hull; a hexagon of radius 0.001 is a square of side 2. No word of any, though the corners are there to ask for.
# And polygons keep a gap of 0.015 to 0.02 from each other, whatever their size (discs do not): a packing of squares of side 0.1
# has 70% of its true density. Use lengths of 1 and more, twelve corners at most, and getFixtureList().getShape() to see.
#   24-gon: mass 0.417 of the true one, corners 12; 48-gon: 0.071, 12; star: 1.618, 5; hexagon of radius 0.001: 1539600.718, 4
#   pushed together: squares of side 1 are 0.015 apart, of side 0.1 0.019; discs of diameter 1 -0.005
set -euo pipefail
command -v npm >/dev/null || { echo "needs npm"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-save --ignore-scripts --prefix . planck@1.5.0 >/dev/null
cat > polygons.mjs <<'NODE'
import { Box, Circle, Polygon, World } from 'planck';
const world = () => new World({ gravity: { x: 0, y: 0 } });
const ring = (corners, radius, inner = 1) => Array.from({ length: corners }, (_, i) => {
  const r = i % 2 ? radius * inner : radius;
  return { x: r * Math.cos(2 * Math.PI * i / corners), y: r * Math.sin(2 * Math.PI * i / corners) };
});
const mass = (points) => {
  const body = world().createDynamicBody();
  const shape = body.createFixture({ shape: new Polygon(points), density: 1 }).getShape();
  const twice = points.reduce((sum, p, i) => {
    const q = points[(i + 1) % points.length];
    return sum + p.x * q.y - p.y * q.x;
  }, 0);
  return [(body.getMass() / (twice / 2)).toFixed(3), shape.m_vertices.length];
};
const words = (points) => mass(points).join(', ');
const [share, corners] = mass(ring(24, 1));
console.log(`24-gon: mass ${share} of the true one, corners ${corners}; 48-gon: ${words(ring(48, 1))}; ` +
  `star: ${words(ring(10, 1, 0.5))}; hexagon of radius 0.001: ${words(ring(6, 0.001))}`);
const gap = (size, shape) => { // between two bodies pushed together for a while
  const all = world();
  const bodies = [-size, size].map((x) => {
    const body = all.createDynamicBody({ position: { x, y: 0 }, fixedRotation: true });
    body.createFixture({ shape: shape(size / 2), density: 1 / size ** 2 });
    return body;
  });
  for (let i = 0; i < 4000; i++) {
    bodies.forEach((body, which) => body.applyForceToCenter({ x: which ? -size : size, y: 0 }, true));
    all.step(1 / 240);
  }
  return (bodies[1].getPosition().x - bodies[0].getPosition().x - size).toFixed(3);
};
const square = (half) => new Box(half, half);
console.log(`pushed together: squares of side 1 are ${gap(1, square)} apart, of side 0.1 ${gap(0.1, square)}; ` +
  `discs of diameter 1 ${gap(1, (half) => new Circle(half))}`);
NODE
node polygons.mjs > seen
cat seen
diff seen - <<'SEEN'
24-gon: mass 0.417 of the true one, corners 12; 48-gon: 0.071, 12; star: 1.618, 5; hexagon of radius 0.001: 1539600.718, 4
pushed together: squares of side 1 are 0.015 apart, of side 0.1 0.019; discs of diameter 1 -0.005
SEEN
