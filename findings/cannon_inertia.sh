#!/usr/bin/env bash
# cannon-es 0.20.0 (npm), rigid bodies in three dimensions: how grains turn.
#
# Guess: a sphere has 2 m r^2 / 5 and rolls down a slope with g sin(a) / 1.4; a rod has the same moments in its own axes however
# it lies when it is made; a polyhedron has its own volume.
# Seen: the inertia of each body is that of a box around it, in the axes of the world at the time when mass or shape was set. A
# sphere has 2 m r^2 / 3, that of a hollow one, and rolls with g sin(a) / 1.67. A rod (4 by 1 by 1) made with its quaternion
# turned by 90 degrees about z has the small moment on the wrong axis of its own. `volume()` of a polyhedron is that of the
# sphere around it: 25 times too large for a tetrahedron. No word of any. Set body.inertia and body.invInertia yourself, then
# call body.updateInertiaWorld(true).
#   sphere: inertia 0.6667 0.6667 0.6667, rolls with g sin(a) / 1.667; own inertia set: / 1.400
#   rod along x: inertia 0.1667 1.4167 1.4167, made turned: 1.4167 0.1667 1.4167
#   tetrahedron of volume 0.1667: volume 4.1888
set -euo pipefail
command -v npm >/dev/null || { echo "needs npm"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-save --ignore-scripts --prefix . cannon-es@0.20.0 >/dev/null
cat > turn.mjs <<'NODE'
import { Body, Box, ConvexPolyhedron, Plane, Quaternion, Sphere, Vec3, World } from 'cannon-es';
const words = (v) => [v.x, v.y, v.z].map((x) => x.toFixed(4)).join(' ');
const sphere = () => new Body({ mass: 1, shape: new Sphere(1), position: new Vec3(0, 0, 1), linearDamping: 0, angularDamping: 0 });
const rolling = (ball) => { // g sin(a) over the acceleration after a second
  const world = new World({ gravity: new Vec3(10 * Math.sin(0.2), 0, -10 * Math.cos(0.2)) });
  Object.assign(world.defaultContactMaterial, { friction: 0.9, restitution: 0 });
  world.addBody(new Body({ mass: 0, shape: new Plane() }));
  world.addBody(ball);
  for (let i = 0; i < 1000; i++) world.step(1 / 1000);
  return (10 * Math.sin(0.2) / ball.velocity.x).toFixed(3);
};
const mended = sphere();
mended.inertia.set(0.4, 0.4, 0.4);
mended.invInertia.set(2.5, 2.5, 2.5);
mended.updateInertiaWorld(true);
console.log(`sphere: inertia ${words(sphere().inertia)}, rolls with g sin(a) / ${rolling(sphere())}; ` +
  `own inertia set: / ${rolling(mended)}`);
const rod = (quaternion) => new Body({ mass: 1, shape: new Box(new Vec3(2, 0.5, 0.5)), quaternion }).inertia;
const turned = new Quaternion().setFromAxisAngle(new Vec3(0, 0, 1), Math.PI / 2);
console.log(`rod along x: inertia ${words(rod(new Quaternion()))}, made turned: ${words(rod(turned))}`);
const vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]].map((v) => new Vec3(...v));
const grain = new ConvexPolyhedron({ vertices, faces: [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]] });
console.log(`tetrahedron of volume ${(1 / 6).toFixed(4)}: volume ${grain.volume().toFixed(4)}`);
NODE
node turn.mjs > seen
cat seen
diff seen - <<'SEEN'
sphere: inertia 0.6667 0.6667 0.6667, rolls with g sin(a) / 1.667; own inertia set: / 1.400
rod along x: inertia 0.1667 1.4167 1.4167, made turned: 1.4167 0.1667 1.4167
tetrahedron of volume 0.1667: volume 4.1888
SEEN
