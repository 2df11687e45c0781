#!/usr/bin/env bash
# gsd 2.7.0 (Debian 12: python3-gsd 2.7.0-2+b1): what a frame holds of the properties that it does not write.
#
# Guess: properties that do not change (diameter, type) are written in the first frame and hold for all; velocities that a frame
# does not write are zero, or not there.
# Seen: what a frame leaves out comes from the first frame, velocities and images as well: a film of positions alone moves with
# the velocities of its start. Where the number of particles differs from that of the first frame, all comes from the defaults
# instead: every diameter is 1 and every type the first, without a word. Write all properties where the number changes.
#   as many, positions alone: diameters [2.0, 3.0] types [0, 1] velocities [4.0, 5.0]
#   one more, positions alone: diameters [1.0, 1.0, 1.0] types [0, 0, 0] velocities [0.0, 0.0, 0.0]
#   as many again: diameters [2.0, 3.0] types [0, 1] velocities [4.0, 5.0]
set -euo pipefail
want=2.7.0-2+b1
version=$(dpkg-query -W -f='${Version}' python3-gsd 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs python3-gsd $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
/usr/bin/python3 -W ignore - > seen <<'PYTHON'
import gsd.hoomd


def frame(number):
    result = gsd.hoomd.Snapshot()
    result.configuration.box = [10, 10, 1, 0, 0, 0]
    result.particles.N = number
    result.particles.types = ["small", "large"]
    result.particles.position = [[i, 0, 0] for i in range(number)]
    return result


with gsd.hoomd.open("film.gsd", "wb") as file:
    first = frame(2)
    first.particles.diameter = [2, 3]
    first.particles.typeid = [0, 1]
    first.particles.velocity = [[4, 0, 0], [5, 0, 0]]
    for step, each in enumerate((first, frame(2), frame(3), frame(2))):
        each.configuration.step = step
        file.append(each)
with gsd.hoomd.open("film.gsd", "rb") as file:
    for label, each in zip(("as many, positions alone", "one more, positions alone", "as many again"), file[1:]):
        particles = each.particles
        print(f"{label}: diameters {particles.diameter.tolist()} types {particles.typeid.tolist()} "
              f"velocities {particles.velocity[:, 0].tolist()}")
PYTHON
cat seen
diff seen - <<'SEEN'
as many, positions alone: diameters [2.0, 3.0] types [0, 1] velocities [4.0, 5.0]
one more, positions alone: diameters [1.0, 1.0, 1.0] types [0, 0, 0] velocities [0.0, 0.0, 0.0]
as many again: diameters [2.0, 3.0] types [0, 1] velocities [4.0, 5.0]
SEEN
