#!/usr/bin/env bash
# Rapier 0.21.0 (npm: @dimforge/rapier2d-compat), rigid bodies in a plane, colliders of density 1: mass and moment of inertia, the
# latter about the centre of mass and as it is felt by a blow (applyTorqueImpulse).
#
# Guess: the area of the shape, with its rounded border, and the integral of r^2 over it.
# Seen: the border of rounded shapes, which collides, has no mass: a square with a border of 0.2 has half of its mass and a
# quarter of its moment. A triangle has the moment about the origin of its coordinates, a corner here, in place of that about
# its centre of mass, three times too large, and a mesh of triangles is off as well; the same triangle as a convex hull is
# right. No word of it. Give the collider numbers of your own by setMassProperties.
#   square: mass 1.000 for 1.000, moment 0.167 for 0.167, by a blow 0.167
#   square with a border of 0.2: mass 1.000 for 1.926, moment 0.167 for 0.611, by a blow 0.167
#   triangle: mass 0.500 for 0.500, moment 0.167 for 0.056, by a blow 0.167
#   triangle as a hull: mass 0.500 for 0.500, moment 0.056 for 0.056, by a blow 0.056
#   mesh of an L: mass 3.000 for 3.000, moment 4.667 for 1.833, by a blow 4.667
#   two squares with borders, 1.35 apart: distance -0.05
set -euo pipefail
command -v npm >/dev/null || { echo "needs npm"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-save --ignore-scripts --prefix . @dimforge/rapier2d-compat@0.21.0 >/dev/null
cat > masses.mjs <<'NODE'
import rapier from '@dimforge/rapier2d-compat';
await rapier.init();
const { ColliderDesc, RigidBodyDesc, World } = rapier;
const world = new World({ x: 0, y: 0 });
const show = (name, shape, mass, moment) => {
  const body = world.createRigidBody(RigidBodyDesc.dynamic());
  world.createCollider(shape.setDensity(1).setCollisionGroups(0), body);
  world.step();
  body.applyTorqueImpulse(1, true);
  console.log(`${name}: mass ${body.mass().toFixed(3)} for ${mass.toFixed(3)}, moment ${body.principalInertia().toFixed(3)} ` +
    `for ${moment.toFixed(3)}, by a blow ${(1 / body.angvel()).toFixed(3)}`);
};
const corners = [{ x: 0, y: 0 }, { x: 1, y: 0 }, { x: 0, y: 1 }];
const points = new Float32Array(corners.flatMap(({ x, y }) => [x, y]));
const r = 0.2; // of the border: four rectangles and four quarter discs around a square of side 1
const quarters = 4 * (Math.PI * r ** 2 / 4), centroid = 0.5 + 4 * r / (3 * Math.PI);
const roundMoment = 1 / 6 + 4 * (r * (1 + r ** 2) / 12 + r * (0.5 + r / 2) ** 2) +
  Math.PI * r ** 4 / 2 + quarters * 2 * (centroid ** 2 - (4 * r / (3 * Math.PI)) ** 2);
show('square', ColliderDesc.cuboid(0.5, 0.5), 1, 1 / 6);
show('square with a border of 0.2', ColliderDesc.roundCuboid(0.5, 0.5, r), 1 + 4 * r + Math.PI * r ** 2, roundMoment);
show('triangle', ColliderDesc.triangle(...corners), 0.5, 1 / 18);
show('triangle as a hull', ColliderDesc.convexHull(points), 0.5, 1 / 18);
const ell = new Float32Array([0, 0, 2, 0, 2, 1, 1, 1, 1, 2, 0, 2]); // three squares
show('mesh of an L', ColliderDesc.trimesh(ell, new Uint32Array([0, 1, 2, 0, 2, 3, 0, 3, 5, 3, 4, 5])), 3, 11 / 6);
const pair = [0, 1.35].map((x) => world.createCollider(ColliderDesc.roundCuboid(0.5, 0.5, r).setTranslation(x, 0)));
const contact = pair[0].contactCollider(pair[1], 1);
console.log(`two squares with borders, 1.35 apart: distance ${contact.distance.toFixed(2)}`);
NODE
node masses.mjs > seen 2> messages || { cat messages; exit 1; }
cat seen
diff seen - <<'SEEN'
square: mass 1.000 for 1.000, moment 0.167 for 0.167, by a blow 0.167
square with a border of 0.2: mass 1.000 for 1.926, moment 0.167 for 0.611, by a blow 0.167
triangle: mass 0.500 for 0.500, moment 0.167 for 0.056, by a blow 0.167
triangle as a hull: mass 0.500 for 0.500, moment 0.056 for 0.056, by a blow 0.056
mesh of an L: mass 3.000 for 3.000, moment 4.667 for 1.833, by a blow 4.667
two squares with borders, 1.35 apart: distance -0.05
SEEN
