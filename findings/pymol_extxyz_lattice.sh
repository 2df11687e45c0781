#!/usr/bin/env bash
# PyMOL 2.5.0 (Debian 12: python3-pymol 2.5.0+dfsg-1+b3) loading a film in extended XYZ: two frames of two particles, with the
# cell of a simple shear in the second line.
#
# Guess: the second line is a comment, and the cell is left out; or it is read.
# Seen: where it begins with Lattice="Lx 0 0 it is taken for a particle, which stands at (0, 0, tilt) and is named Lattice="Lx;
# the last particle of the frame is missing, so that their number is right, and of the film there is one frame. Any second line
# of a word and three numbers does it. No word of it. With Properties= before Lattice= all is read, without the cell.
#   Lattice= first: 1 of 2 frames, Lattice="10 0 0 3; A 0 0 7
#   Properties= first: 2 of 2 frames, A 0 0 7; B 1 1 7
#   "step 100": 2 of 2 frames, A 0 0 7; B 1 1 7
#   "strain 0.1 0.2 0.3": 1 of 2 frames, strain 0.1 0.2 0.3; A 0 0 7
set -euo pipefail
want=2.5.0+dfsg-1+b3
version=$(dpkg-query -W -f='${Version}' python3-pymol 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs python3-pymol $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > load.py <<'PYTHON'
from pymol import cmd


def load(label, second):
    with open("film.xyz", "w") as file:
        for _ in range(2):
            file.write(f"2\n{second}\nA 0 0 7\nB 1 1 7\n")
    cmd.delete("all")
    cmd.load("film.xyz", "film")
    rows = []
    cmd.iterate_state(1, "film", "rows.append((name, x, y, z))", space={"rows": rows})
    particles = "; ".join(f"{name} {x:g} {y:g} {z:g}" for name, x, y, z in rows)
    print(f"{label}: {cmd.count_states('film')} of 2 frames, {particles}")


cell, columns = 'Lattice="10 0 0 3 10 0 0 0 1"', "Properties=species:S:1:pos:R:3"
load("Lattice= first", f"{cell} {columns}")
load("Properties= first", f"{columns} {cell}")
load('"step 100"', "step 100")
load('"strain 0.1 0.2 0.3"', "strain 0.1 0.2 0.3")
PYTHON
/usr/bin/python3 -m pymol -cqk load.py > seen 2>messages || { cat messages; exit 1; }
cat messages seen
diff seen - <<'SEEN'
Lattice= first: 1 of 2 frames, Lattice="10 0 0 3; A 0 0 7
Properties= first: 2 of 2 frames, A 0 0 7; B 1 1 7
"step 100": 2 of 2 frames, A 0 0 7; B 1 1 7
"strain 0.1 0.2 0.3": 1 of 2 frames, strain 0.1 0.2 0.3; A 0 0 7
SEEN
