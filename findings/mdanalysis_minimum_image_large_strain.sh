#!/usr/bin/env bash
# MDAnalysis 2.4.2 (Debian 12: python3-mdanalysis 2.4.2+dfsg1-1+b1): distances in a cell sheared far.
#
# Guess: calc_bonds(a, b, box) is the least distance over all images for any triclinic box that it accepts.
# Seen: right up to shear strain 1.2 of a cube; at 2.0 some 2 % and at 3.0 some 12 % of random distances are too
# long, by up to a third of the side, without a warning. A Lees-Edwards cell written with its accumulated strain meets this; write the strain
# reduced to (-1/2, 1/2], which is the same lattice.
#   strain 1.2: 0 of 4000 too long
#   strain 2.0: 78 of 4000 too long, by 1.57 at most (side 10)
#   strain 3.0: 477 of 4000 too long, by 3.68 at most (side 10)
#   strain 3.0 as 0.0: 0 of 4000 too long
set -euo pipefail
version=$(dpkg-query -W -f='${Version}' python3-mdanalysis 2>/dev/null || true)
[ "$version" = 2.4.2+dfsg1-1+b1 ] || { echo "needs python3-mdanalysis 2.4.2+dfsg1-1+b1, found '${version:-none}'"; exit 77; }

/usr/bin/python3 -W ignore - <<'PYTHON'
import sys
import numpy as np
from MDAnalysis.lib.distances import calc_bonds
from MDAnalysis.lib.mdamath import triclinic_box

side, count = 10.0, 4000
random = np.random.default_rng(1)

def cell_of(strain):
    return np.array([[side, 0, 0], [strain * side, side, 0], [0, 0, side]])

def too_long(cell, strain_given):
    a, b = random.random((2, count, 3)) @ cell
    d = b - a
    least = np.min([np.linalg.norm(d + p * cell[0] + q * cell[1] + r * cell[2], axis=1)
                    for p in range(-8, 9) for q in (-1, 0, 1) for r in (-1, 0, 1)], axis=0)
    box = triclinic_box(*cell_of(strain_given).astype(np.float32))
    return calc_bonds(a, b, box=box) - least

numbers = {}
for strain in (1.2, 2.0, 3.0):
    excess = too_long(cell_of(strain), strain)
    numbers[strain] = int((excess > 1e-3).sum())
    tail = f", by {excess.max():.2f} at most (side 10)" if numbers[strain] else ""
    print(f"strain {strain}: {numbers[strain]} of {count} too long{tail}")
reduced = int((too_long(cell_of(3.0), 0.0) > 1e-3).sum())
print(f"strain 3.0 as 0.0: {reduced} of {count} too long")
sys.exit(0 if numbers[1.2] == 0 and numbers[2.0] > 0 and numbers[3.0] > numbers[2.0] and reduced == 0 else 1)
PYTHON
