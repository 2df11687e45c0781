#!/usr/bin/env bash
# matter-js 0.20.0 (npm: matter-js), rigid bodies in two dimensions: the mass and the inertia of a disc, Bodies.circle.
#
# Guess: mass is density times pi r^2 and inertia m r^2 / 2, at every radius, or those of a polygon close to the disc.
# Seen: the inertia is four times that of the shape, of each body, while masses are right: what a torque does is a quarter. The
# disc is a polygon of at most 26 sides, ten where r is 1, so 6% of its mass is missing; and its corners are rounded to three
# decimals: a disc of radius 0.001 is a square 27% too large, one of 0.0004 has no mass, and its inertia is NaN. No word of any.
# Keep radii near 100, then call Body.setInertia(body, body.inertia / 4).
#   radius 100: sides 26, mass 0.990, inertia 3.961 (torque: 0.252 of what it should do, with a quarter of the inertia 1.010)
#   radius 1: sides 10, mass 0.936, inertia 3.746 (torque: 0.267 of what it should do, with a quarter of the inertia 1.068)
#   radius 0.001: sides 10, mass 1.273, inertia 5.333
#   radius 0.0004: sides 10, mass 0.000, inertia NaN
set -euo pipefail
command -v npm >/dev/null || { echo "needs npm"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-save --ignore-scripts --prefix . matter-js@0.20.0 >/dev/null
cat > disc.mjs <<'NODE'
import Matter from 'matter-js';
const { Bodies, Body, Composite, Engine } = Matter;
const disc = (r) => Bodies.circle(0, 0, r, { density: 1, frictionAir: 0 });
const response = (r, share) => { // angular acceleration per torque over acceleration per force, in units of a true disc
  const engine = Engine.create({ gravity: { x: 0, y: 0, scale: 0 } });
  const body = disc(r);
  if (share !== 1) Body.setInertia(body, body.inertia * share);
  Composite.add(engine.world, body);
  body.force = { x: 1e-3 * r, y: 0 };
  body.torque = 1e-3 * r * r;
  Engine.update(engine, 1);
  return ((body.angularVelocity * r) / body.velocity.x / 2).toFixed(3);
};
for (const r of [100, 1, 0.001, 0.0004]) {
  const { vertices, mass, inertia } = disc(r);
  const [m, i] = [mass / (Math.PI * r * r), inertia / (mass * r * r / 2)];
  const turns = r < 1 ? '' : ` (torque: ${response(r, 1)} of what it should do, with a quarter of the inertia ${response(r, 0.25)})`;
  console.log(`radius ${r}: sides ${vertices.length}, mass ${m.toFixed(3)}, inertia ${i.toFixed(3)}${turns}`);
}
NODE
node disc.mjs > seen
cat seen
diff seen - <<'SEEN'
radius 100: sides 26, mass 0.990, inertia 3.961 (torque: 0.252 of what it should do, with a quarter of the inertia 1.010)
radius 1: sides 10, mass 0.936, inertia 3.746 (torque: 0.267 of what it should do, with a quarter of the inertia 1.068)
radius 0.001: sides 10, mass 1.273, inertia 5.333
radius 0.0004: sides 10, mass 0.000, inertia NaN
SEEN
