#!/usr/bin/env bash
# Manifold 3.5.4 (npm: manifold-3d), solids and their overlaps: spheres and discs made with the default number of segments.
#
# Guess: a sphere has a few percent less volume than the true one, the same share at every radius.
# Seen: by default a segment has at least length 1 and at least 10 degrees: good at a radius of 100, but at 1 the sphere has 70%
# of its volume, and at 0.5 (diameters as the unit of length) and below it is an octahedron with 32%, discs are squares, and the
# overlap of two such spheres is 2% of what it should be. The status is NoError throughout. Give the number of segments: depths
# of a tenth need some 256.
#   radius 100: corners 326, volume 0.982, disc 0.995, overlap at a distance of 1.8 radii 0.894
#   radius 1: corners 18, volume 0.703, disc 0.900, overlap at a distance of 1.8 radii 0.128
#   radius 0.5: corners 6, volume 0.318, disc 0.637, overlap at a distance of 1.8 radii 0.022
#   radius 0.001: corners 6, volume 0.318, disc 0.637, overlap at a distance of 1.8 radii 0.022
#   radius 0.5, 256 segments: corners 16386, volume 1.000, disc 1.000, overlap at a distance of 1.8 radii 0.998
set -euo pipefail
command -v npm >/dev/null || { echo "needs npm"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-save --ignore-scripts --prefix . manifold-3d@3.5.4 >/dev/null
cat > solids.mjs <<'NODE'
import load from 'manifold-3d';
const library = await load();
library.setup();
const { CrossSection, Manifold } = library;
const shares = (r, segments) => {
  const [a, b] = [Manifold.sphere(r, segments), Manifold.sphere(r, segments).translate(1.8 * r, 0, 0)];
  const lens = (Math.PI / 12) * (4 * r + 1.8 * r) * (2 * r - 1.8 * r) ** 2;
  const [volume, disc] = [a.volume() / ((4 / 3) * Math.PI * r ** 3), CrossSection.circle(r, segments).area() / (Math.PI * r * r)];
  return `corners ${a.numVert()}, volume ${volume.toFixed(3)}, disc ${disc.toFixed(3)}, ` +
    `overlap at a distance of 1.8 radii ${(a.intersect(b).volume() / lens).toFixed(3)}`;
};
for (const r of [100, 1, 0.5, 0.001]) console.log(`radius ${r}: ${shares(r)}`);
console.log(`radius 0.5, 256 segments: ${shares(0.5, 256)}`);
NODE
node solids.mjs > seen
cat seen
diff seen - <<'SEEN'
radius 100: corners 326, volume 0.982, disc 0.995, overlap at a distance of 1.8 radii 0.894
radius 1: corners 18, volume 0.703, disc 0.900, overlap at a distance of 1.8 radii 0.128
radius 0.5: corners 6, volume 0.318, disc 0.637, overlap at a distance of 1.8 radii 0.022
radius 0.001: corners 6, volume 0.318, disc 0.637, overlap at a distance of 1.8 radii 0.022
radius 0.5, 256 segments: corners 16386, volume 1.000, disc 1.000, overlap at a distance of 1.8 radii 0.998
SEEN
