#!/usr/bin/env bash
# GROMACS 2022.5 (Debian 12: gromacs 2022.5-2), gmx editconf of a .gro file: two particles at a distance of 0.474 nm across
# the boundary of a periodic cell with a skewed box, or of 0.283 in a cubic one, turned by 90 or 30 degrees (-rotate), or
# along their principal axes (-princ); the least distance over all images, from the file that is written.
#
# Guess: the cell turns with the particles; or, where that is no cell of GROMACS, an error; distances stay.
# Seen: positions and velocities are turned, the cell is left as it is: distances across the boundary are 0.212 for 0.474,
# 0.132 for 0.283. In a dense packing particles of the two sides are inside of each other. The log has no word of it. Turn
# only what is not periodic.
#   skewed: 0.474, -rotate 0 0 90 0.212, -rotate 0 0 30 0.161, -princ 0.202
#   cubic: 0.283, -rotate 0 0 90 0.283, -rotate 0 0 30 0.306, -princ 0.132
set -euo pipefail
want=2022.5-2
version=$(dpkg-query -W -f='${Version}' gromacs 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs gromacs $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cell() {
  printf 'two\n    2\n    1ARG     AR    1   0.100   0.100   0.100\n    1ARG     AR    2   %s   %s   0.100\n%s\n' "$1" "$1" "$2"
}
cell 0.950 '   1.00000   1.00000   1.00000   0.00000   0.00000   0.30000   0.00000   0.00000   0.00000' > skewed.gro
cell 0.900 '   1.00000   1.00000   1.00000' > cubic.gro
cat > least.py <<'PYTHON'
import itertools
import sys

import numpy

lines = open(sys.argv[1]).read().splitlines()
first, second = [numpy.array([float(line[20 + 8 * k:28 + 8 * k]) for k in range(3)]) for line in lines[2:4]]
box = [float(word) for word in lines[4].split()] + [0] * 6
edges = numpy.array([[box[0], box[3], box[4]], [box[5], box[1], box[6]], [box[7], box[8], box[2]]])
images = itertools.product(range(-3, 4), repeat=3)
print(f"{min(numpy.linalg.norm(first - second + numpy.array(image) @ edges) for image in images):.3f}")
PYTHON
for name in skewed cubic; do
  words="$name: $(/usr/bin/python3 least.py $name.gro)"
  for turn in '-rotate 0 0 90' '-rotate 0 0 30' -princ; do
    echo 0 | gmx -quiet editconf -f $name.gro -o turned.gro $turn > messages 2>&1 || { cat messages; exit 1; }
    ! grep -iq warning messages
    words+=", $turn $(/usr/bin/python3 least.py turned.gro)"
    rm turned.gro
  done
  echo "$words"
done > seen
cat seen
diff seen - <<'SEEN'
skewed: 0.474, -rotate 0 0 90 0.212, -rotate 0 0 30 0.161, -princ 0.202
cubic: 0.283, -rotate 0 0 90 0.283, -rotate 0 0 30 0.306, -princ 0.132
SEEN
