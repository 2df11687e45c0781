#!/usr/bin/env bash
# Siconos 4.4.0 (Debian 12: python3-siconos 4.4.0+dfsg-2), contact dynamics without springs: a sphere falls half its radius onto
# a plate five diameters thick and stays there, restitution 0; in 1000 steps, all lengths by the radius.
#
# Guess: its centre ends one radius above the plate, less the way of a step, at every radius in metres.
# Seen: so for radii from 1 down to 0.002. A sphere of one millimetre falls into the plate and rests 2.6 radii below its surface,
# one of 0.5 mm hovers, turns and then sinks, one of 0.1 mm hovers 0.4 of its radius above: the collision library has lengths
# of its own. No error or warning. With SiconosBulletOptions().worldScale = 1 / radius, handed to run() as bullet_options, all
# end at 1.0.
#   radius 1: ends at 1.0 radii, with worldScale 1.0
#   radius 0.01: ends at 1.0 radii, with worldScale 1.0
#   radius 0.001: ends at -2.6 radii, with worldScale 1.0
#   radius 0.0005: ends at 0.5 radii, with worldScale 1.0
#   radius 0.0001: ends at 1.4 radii, with worldScale 1.0
set -euo pipefail
want=4.4.0+dfsg-2
version=$(dpkg-query -W -f='${Version}' python3-siconos 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs python3-siconos $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
/usr/bin/python3 -W ignore - > messages 2>&1 <<'PYTHON' || { cat messages; exit 1; }
import h5py
from siconos.io.mechanics_run import MechanicsHdf5Runner
from siconos.mechanics.collision.bullet import SiconosBulletOptions
from siconos.mechanics.collision.tools import Contactor


def rest(radius, scale):
    with MechanicsHdf5Runner("fall.hdf5", mode="w") as world:
        world.add_primitive_shape("sphere", "Sphere", (radius,))
        world.add_primitive_shape("plate", "Box", (100 * radius, 100 * radius, 10 * radius))
        world.add_object("grain", [Contactor("sphere")], translation=[0, 0, 1.5 * radius], velocity=[0] * 6, mass=1)
        world.add_object("ground", [Contactor("plate")], translation=[0, 0, -5 * radius])
        world.add_Newton_impact_friction_nsl("contact", mu=0.3, e=0)
    options = SiconosBulletOptions()
    options.worldScale = scale
    duration = 6 * (2 * radius / 9.81) ** 0.5
    with MechanicsHdf5Runner("fall.hdf5", mode="r+") as world:
        world.run(T=duration, h=duration / 1000, bullet_options=options)
    with h5py.File("fall.hdf5") as file:
        return file["data"]["dynamic"][-1, 4] / radius


with open("seen", "w") as seen:
    for radius in (1, 0.01, 0.001, 0.0005, 0.0001):
        plain, scaled = rest(radius, 1), rest(radius, 1 / radius)
        seen.write(f"radius {radius:g}: ends at {plain:.1f} radii, with worldScale {scaled:.1f}\n")
PYTHON
cat seen
diff seen - <<'SEEN'
radius 1: ends at 1.0 radii, with worldScale 1.0
radius 0.01: ends at 1.0 radii, with worldScale 1.0
radius 0.001: ends at -2.6 radii, with worldScale 1.0
radius 0.0005: ends at 0.5 radii, with worldScale 1.0
radius 0.0001: ends at 1.4 radii, with worldScale 1.0
SEEN
