#!/usr/bin/env bash
# OIMO 1.0.9 (npm: oimo), rigid bodies in three dimensions: mass and moments of inertia of a cylinder of density 1, across and along its
# axis, by its size; a sphere and a box beside it.
#
# Guess: those of the closed forms.
# Seen: the moment along the axis of a cylinder is r^2 / 2, without its mass: that of a disc-like grain of density 10 a 63rd of what it
# is, that of one of a centimetre 160 times too much, so that it hardly rolls and does not spin down as it should. Mass and the
# moment across are right, and a cylinder of mass 1 is, too.
#   sphere 1, density 1: mass 4.19 (4.19), across 1.68 (1.68), along 1.68 (1.68)
#   cube 2, density 1: mass 8.00 (8.00), across 5.33 (5.33), along 5.33 (5.33)
#   cylinder 1, 2, density 1: mass 6.28 (6.28), across 3.66 (3.67), along 0.500 (3.14)
#   cylinder 1, 2, density 10: mass 62.8 (62.8), across 36.6 (36.7), along 0.500 (31.4)
#   cylinder 0.1, 0.2, density 1: mass 0.00628 (0.00628), across 0.0000366 (0.0000367), along 0.00500 (0.0000314)
#   cylinder 0.01, 0.02, density 1000: mass 0.00628 (0.00628), across 3.66e-7 (3.67e-7), along 0.0000500 (3.14e-7)
set -euo pipefail
command -v npm >/dev/null || { echo "needs npm"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-save --ignore-scripts --prefix . oimo@1.0.9 >/dev/null
cat > moments.cjs <<'NODE'
const oimo = require('oimo');
const world = new oimo.World({ timestep: 1 / 60, gravity: [0, 0, 0], worldscale: 1 });
let place = 0;
function show(name, type, size, density, mass, across, along) {
  const body = world.add({ type, size, pos: [(place += 10), 0, 0], move: true, density });
  const moments = body.localInertia.elements;
  const digits = (value) => value.toPrecision(3);
  console.log(`${name}, density ${density}: mass ${digits(body.mass)} (${digits(mass)}), across ${digits(moments[0])} (${digits(across)}), `
    + `along ${digits(moments[4])} (${digits(along)})`);
}
function cylinder(radius, height, density) {
  const mass = density * Math.PI * radius ** 2 * height;
  show(`cylinder ${radius}, ${height}`, 'cylinder', [radius, height], density, mass, (mass * (3 * radius ** 2 + height ** 2)) / 12,
    (mass * radius ** 2) / 2);
}
const ball = (4 / 3) * Math.PI;
show('sphere 1', 'sphere', [1], 1, ball, 0.4 * ball, 0.4 * ball);
show('cube 2', 'box', [2, 2, 2], 1, 8, 16 / 3, 16 / 3);
cylinder(1, 2, 1);
cylinder(1, 2, 10);
cylinder(0.1, 0.2, 1);
cylinder(0.01, 0.02, 1000);
NODE
node moments.cjs > seen 2> messages || { cat seen messages; exit 1; }
cat seen
diff seen - <<'SEEN'
sphere 1, density 1: mass 4.19 (4.19), across 1.68 (1.68), along 1.68 (1.68)
cube 2, density 1: mass 8.00 (8.00), across 5.33 (5.33), along 5.33 (5.33)
cylinder 1, 2, density 1: mass 6.28 (6.28), across 3.66 (3.67), along 0.500 (3.14)
cylinder 1, 2, density 10: mass 62.8 (62.8), across 36.6 (36.7), along 0.500 (31.4)
cylinder 0.1, 0.2, density 1: mass 0.00628 (0.00628), across 0.0000366 (0.0000367), along 0.00500 (0.0000314)
cylinder 0.01, 0.02, density 1000: mass 0.00628 (0.00628), across 3.66e-7 (3.67e-7), along 0.0000500 (3.14e-7)
SEEN
