#!/usr/bin/env bash
# Open Babel 3.1.1 (Debian 12: python3-openbabel 3.1.1+dfsg-9+b3) converting two particles in a periodic cell (PDB) to a data
# file of LAMMPS; to .gro beside it.
#
# Guess: the box of the data file is the cell, with its tilt; or it is an error where that is not possible.
# Seen: whatever the cell, the box is an upright cube, from the least of all coordinates less 0.5 to the greatest plus 0.5, along
# each axis. A cell of 20 by 10 by 5 becomes one of 8 times its volume, a sheared one of 3.4 times, and one whose particles lie
# close together is too small. No warning; .gro, CIF and POSCAR have the cell. Write the lines of the box yourself.
#   20 by 10 by 5: box -0.5 to 19.5 three times, tilt none, 8.00 of the volume; gro 2.00000 1.00000 0.50000
#   strain 1: box -0.5 to 14.5 three times, tilt none, 3.38 of the volume; gro 1.00000 0.99999 1.00000 0.00000 0.00000 0.99999
#   close together: box -0.5 to 2.5 three times, tilt none, 0.03 of the volume; gro 1.00000 1.00000 1.00000
set -euo pipefail
want=3.1.1+dfsg-9+b3
version=$(dpkg-query -W -f='${Version}' python3-openbabel 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs python3-openbabel $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
/usr/bin/python3 -W ignore - > seen 2>messages <<'PYTHON' || { cat messages; exit 1; }
from openbabel import pybel


def convert(name, lengths, gamma, points):
    rows = ["CRYST1{:9.3f}{:9.3f}{:9.3f}{:7.2f}{:7.2f}{:7.2f} P 1           1".format(*lengths, 90, 90, gamma)]
    for i, point in enumerate(points, 1):
        rows.append("HETATM{:5d}  C   UNL  {:4d}    {:8.3f}{:8.3f}{:8.3f}  1.00  0.00           C".format(i, i, *point))
    packing = pybel.readstring("pdb", "\n".join(rows) + "\nEND\n")
    lines = [line.split() for line in packing.write("lmpdat").splitlines()]
    boxes = [line[:2] for line in lines if line[2:] in (["xlo", "xhi"], ["ylo", "yhi"], ["zlo", "zhi"])]
    assert boxes[0] == boxes[1] == boxes[2]
    low, high = map(float, boxes[0])
    tilt = "none" if not any("xy" in line for line in lines) else "some"
    gro = " ".join(packing.write("gro").splitlines()[-1].split()[:3 if gamma == 90 else 6])
    print(f"{name}: box {low:g} to {high:g} three times, tilt {tilt}, "
          f"{(high - low) ** 3 / packing.unitcell.GetCellVolume():.2f} of the volume; gro {gro}")


convert("20 by 10 by 5", (20, 10, 5), 90, [(1, 2, 3), (19, 9, 4)])
convert("strain 1", (10, 10 * 2**0.5, 10), 45, [(1, 2, 3), (14, 9, 6)])
convert("close together", (10, 10, 10), 90, [(1, 1, 1), (2, 2, 2)])
PYTHON
cat seen
diff seen - <<'SEEN'
20 by 10 by 5: box -0.5 to 19.5 three times, tilt none, 8.00 of the volume; gro 2.00000 1.00000 0.50000
strain 1: box -0.5 to 14.5 three times, tilt none, 3.38 of the volume; gro 1.00000 0.99999 1.00000 0.00000 0.00000 0.99999
close together: box -0.5 to 2.5 three times, tilt none, 0.03 of the volume; gro 1.00000 1.00000 1.00000
SEEN
