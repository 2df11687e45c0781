#!/usr/bin/env bash
# LAMMPS 20220106 (Debian 12: lammps 20220106.git7586adbb6a+ds1-2+b2): an ensemble of packings with the seeds 1, 2, 3 … of
# `create_atoms 1 random 500 SEED` and `velocity all create 1 SEED`.
#
# Guess: other seeds give other, independent places and velocities.
# Seen: the places of seed 2 are twice those of seed 1, and those of seed 3 the sum of both, modulo the cell: the generator
# multiplies its seed and nothing else, so that seed s is s times seed 1. The nearest pair of seed 1 is s times as far apart at
# seed s, and so is the pair of most alike velocities, but for the scale: the same grains meet in every packing. Means over the
# seeds 1 to 64 scatter twice as much as independent ones do. Draw the seeds themselves at random, up to 2^31.
#   x(2) - 2 x(1) modulo the cell at most 0.00000000, x(3) - x(2) - x(1) at most 0.00000000
#   pair nearest at seed 1: at seeds 1 to 5 0.0003 0.0005 0.0008 0.0010 0.0013
#   pair of most alike velocities: 0.0012 0.0024 0.0037 0.0049 0.0061
#   mean of a coordinate over 64 seeds scatters by 0.069 for seeds 1 to 64, 0.037 for seeds drawn at random, 0.036 expected
set -euo pipefail
want=20220106.git7586adbb6a+ds1-2+b2
version=$(dpkg-query -W -f='${Version}' lammps 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs lammps $want, found '${version:-none}'"; exit 77; }
/usr/bin/python3 -c 'import numpy' 2>/dev/null || { echo "needs python3-numpy"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > places.in <<'IN'
units lj
dimension 2
atom_style sphere
region cell block 0 1 0 1 -0.5 0.5
create_box 1 cell
pair_style zero 0.1
pair_coeff * *
label next
create_atoms 1 random 500 ${seed} cell
set type 1 diameter 0.01
velocity all create 1 ${seed}
write_dump all custom ${seed}.places id x y vx vy modify sort id format float %.9g
delete_atoms group all compress yes
next seed
jump SELF next
IN
drawn=$(/usr/bin/python3 -c 'import random; random.seed(1); print(*(random.randrange(100, 2**31 - 1) for _ in range(64)))')
lmp -in places.in -var seed $(seq 1 64) $drawn -log none > messages || { cat messages; exit 1; }
/usr/bin/python3 - $drawn > seen <<'PYTHON'
import sys
import numpy


def read(seeds):
    return numpy.array([numpy.loadtxt(f"{seed}.places", skiprows=9)[:, 1:] for seed in seeds])


row, drawn = read(range(1, 65)), read(sys.argv[1:])
places, velocities = row[..., :2], row[..., 2:]


def wrap(lengths):
    return lengths - numpy.round(lengths)


def nearest(vectors, wrap):  # their distance at seeds 1 to 5
    distances = numpy.linalg.norm(wrap(vectors[0][:, None] - vectors[0]), axis=2)
    numpy.fill_diagonal(distances, 9)
    i, j = divmod(distances.argmin(), len(distances))
    return " ".join(f"{numpy.linalg.norm(wrap(vectors[k, i] - vectors[k, j])):.4f}" for k in range(5))


print(f"x(2) - 2 x(1) modulo the cell at most {abs(wrap(places[1] - 2 * places[0])).max():.8f}, "
      f"x(3) - x(2) - x(1) at most {abs(wrap(places[2] - places[1] - places[0])).max():.8f}")
print(f"pair nearest at seed 1: at seeds 1 to 5 {nearest(places, wrap)}")
print(f"pair of most alike velocities: {nearest(velocities, lambda v: v)}")
print(f"mean of a coordinate over 64 seeds scatters by {places.mean(axis=0).std():.3f} for seeds 1 to 64, "
      f"{drawn[..., :2].mean(axis=0).std():.3f} for seeds drawn at random, {(12 * 64)**-0.5:.3f} expected")
PYTHON
cat seen
diff seen - <<'SEEN'
x(2) - 2 x(1) modulo the cell at most 0.00000000, x(3) - x(2) - x(1) at most 0.00000000
pair nearest at seed 1: at seeds 1 to 5 0.0003 0.0005 0.0008 0.0010 0.0013
pair of most alike velocities: 0.0012 0.0024 0.0037 0.0049 0.0061
mean of a coordinate over 64 seeds scatters by 0.069 for seeds 1 to 64, 0.037 for seeds drawn at random, 0.036 expected
SEEN
