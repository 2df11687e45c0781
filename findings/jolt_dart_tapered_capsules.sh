#!/usr/bin/env bash
# Jolt (npm: jolt-physics 1.1.0), TaperedCapsuleShape, and DART 6.12.1 (Debian 12: libdart-dev 6.12.1+dfsg4-12+b2, compiled by
# g++), MultiSphereConvexHullShape: a grain that is the hull of two spheres of radius a and b, whose centres are 1 apart; with a
# = b it is CapsuleShape. Printed are volume, mass at a density of 1, and moments of a mass of 1, across and along the axis,
# over their true values, and the place of the centre of mass.
#
# Guess: 1.00 for all, to a percent, and for a = b the same as CapsuleShape.
# Seen: both take boxes. The volume is that of the bounding box, 1.5 to 2.5 times too large. In Jolt the mass of a body is
# another number, of a box as wide as the mean of a and b, so that it is not the density times GetVolume(), from 10% too small
# to 53% too large; the centre of mass is half as far from the middle as it is, and moments are 0.66 to 1.66 of what they are.
# In DART the moment about the axis is up to 84% too large. CapsuleShape is right in both.
#   0.5, 0.5, Jolt CapsuleShape: volume 1.00, mass 1.00, centre 0.00 for 0.00, across 1.00, along 1.00
#   0.5, 0.5, Jolt TaperedCapsuleShape: volume 1.53, mass 1.53, centre 0.00 for 0.00, across 1.38, along 1.45
#   0.6, 0.3, Jolt TaperedCapsuleShape: volume 2.23, mass 1.25, centre -0.15 for -0.30, across 1.51, along 1.04
#   0.5, 0.1, Jolt TaperedCapsuleShape: volume 2.50, mass 0.90, centre -0.20 for -0.39, across 1.66, along 0.66
#   0.5, 0.5, DART CapsuleShape: volume 1.00, along 1.00
#   0.5, 0.5, DART MultiSphereConvexHullShape: volume 1.53, along 1.45
#   0.6, 0.3, DART MultiSphereConvexHullShape: volume 2.23, along 1.84
#   0.5, 0.1, DART MultiSphereConvexHullShape: volume 2.50, along 1.83
set -euo pipefail
want=6.12.1+dfsg4-12+b2
for package in libdart-dev libdart-external-ikfast-dev; do
  version=$(dpkg-query -W -f='${Version}' $package 2>/dev/null || true)
  [ "$version" = "$want" ] || { echo "needs $package $want, found '${version:-none}'"; exit 77; }
done
for tool in g++ npm; do command -v $tool >/dev/null || { echo "needs $tool"; exit 77; }; done
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-save --ignore-scripts --prefix . jolt-physics@1.1.0 >/dev/null
cat > dart.cpp <<'CPP'
#include <cstdio>
#include <dart/dynamics/CapsuleShape.hpp>
#include <dart/dynamics/MultiSphereConvexHullShape.hpp>

using namespace dart::dynamics;

// volume, moment of a mass of 1 about the axis
void show(double a, double b, const char* name, const Shape& shape) {
    std::printf("%g %g %s %.17g %.17g\n", a, b, name, shape.getVolume(), shape.computeInertia(1)(2, 2));
}

int main() {
    show(0.5, 0.5, "CapsuleShape", CapsuleShape(0.5, 1));
    for (const auto& [a, b] : {std::pair{0.5, 0.5}, {0.6, 0.3}, {0.5, 0.1}}) {
        MultiSphereConvexHullShape::Spheres spheres{{a, Eigen::Vector3d(0, 0, -0.5)}, {b, Eigen::Vector3d(0, 0, 0.5)}};
        show(a, b, "MultiSphereConvexHullShape", MultiSphereConvexHullShape(spheres));
    }
}
CPP
g++ -std=c++17 -I/usr/include/eigen3 -o dart dart.cpp -ldart
./dart > dart.txt
cat > grains.mjs <<'NODE'
import load_jolt from 'jolt-physics/wasm-compat';
import { readFileSync } from 'node:fs';

// the hull is made of the spheres between both, cut into slices
function integral(a, b) {
  const sums = [0, 0, 0, 0, 0], steps = 2000;
  for (let n = 0; n < steps; ++n) {
    const z = -1.5 + (3 * (n + 0.5)) / steps;
    let radius2 = 0;
    for (let m = 0; m <= 400; ++m) radius2 = Math.max(radius2, (a + ((b - a) * m) / 400) ** 2 - (z + 0.5 - m / 400) ** 2);
    const area = Math.PI * radius2;
    [area, area * z, area * z * z, (area * radius2) / 4, (area * radius2) / 2].forEach((x, k) => (sums[k] += (x * 3) / steps));
  }
  const [volume, first, second, across, along] = sums;
  return { volume, centre: first / volume, across: (second + across) / volume - (first / volume) ** 2, along: along / volume };
}

const jolt = await load_jolt();
function show(name, a, b, seen) {
  const true_ = integral(a, b);
  const words = Object.entries(seen).map(([what, value]) =>
    what === 'centre' ? `centre ${value.toFixed(2)} for ${true_.centre.toFixed(2)}`
      : `${what} ${(value / (true_[what] ?? true_.volume)).toFixed(2)}`);
  console.log(`${a}, ${b}, ${name}: ${words.join(', ')}`);
}
function jolt_seen(shape) {
  const properties = shape.GetMassProperties(), mass = properties.mMass; // at a density of 1000
  const across = properties.mInertia.GetAxisX().GetX() / mass, along = properties.mInertia.GetAxisY().GetY() / mass;
  return { volume: shape.GetVolume(), mass: mass / 1000, centre: shape.GetCenterOfMass().GetY(), across, along };
}
show('Jolt CapsuleShape', 0.5, 0.5, jolt_seen(new jolt.CapsuleShape(0.5, 0.5)));
for (const [a, b] of [[0.5, 0.5], [0.6, 0.3], [0.5, 0.1]]) {
  show('Jolt TaperedCapsuleShape', a, b, jolt_seen(new jolt.TaperedCapsuleShapeSettings(0.5, b, a).Create().Get()));
}
for (const line of readFileSync('dart.txt', 'utf8').trim().split('\n')) {
  const [a, b, name, volume, along] = line.split(' ');
  show(`DART ${name}`, Number(a), Number(b), { volume, along });
}
NODE
node grains.mjs > seen 2> messages || { cat messages; exit 1; }
cat seen
diff seen - <<'SEEN'
0.5, 0.5, Jolt CapsuleShape: volume 1.00, mass 1.00, centre 0.00 for 0.00, across 1.00, along 1.00
0.5, 0.5, Jolt TaperedCapsuleShape: volume 1.53, mass 1.53, centre 0.00 for 0.00, across 1.38, along 1.45
0.6, 0.3, Jolt TaperedCapsuleShape: volume 2.23, mass 1.25, centre -0.15 for -0.30, across 1.51, along 1.04
0.5, 0.1, Jolt TaperedCapsuleShape: volume 2.50, mass 0.90, centre -0.20 for -0.39, across 1.66, along 0.66
0.5, 0.5, DART CapsuleShape: volume 1.00, along 1.00
0.5, 0.5, DART MultiSphereConvexHullShape: volume 1.53, along 1.45
0.6, 0.3, DART MultiSphereConvexHullShape: volume 2.23, along 1.84
0.5, 0.1, DART MultiSphereConvexHullShape: volume 2.50, along 1.83
SEEN
