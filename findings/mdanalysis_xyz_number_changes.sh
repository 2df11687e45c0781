#!/usr/bin/env bash
# MDAnalysis 2.4.2 (Debian 12: python3-mdanalysis 2.4.2+dfsg1-1+b1) reading XYZ films in which the number of particles changes, as
# where rattlers are left out.
#
# Guess: an error that the number changed, as there is for LAMMPS dumps.
# Seen: a frame with more particles than the first is cut to as many, and the film ends behind it. At one with fewer it ends as if
# the file did. There is no word in either case, and len() counts all frames. Averages over the film are those of its beginning.
#   2 3 2: 3 frames, read 2 2
#   3 2 3: 3 frames, read 3
#   3 3 2 3: 4 frames, read 3 3
#   dump 3 2 3: ValueError
set -euo pipefail
want=2.4.2+dfsg1-1+b1
version=$(dpkg-query -W -f='${Version}' python3-mdanalysis 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs python3-mdanalysis $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
/usr/bin/python3 -W ignore - > seen 2>messages <<'PYTHON' || { cat messages; exit 1; }
import MDAnalysis

bounds = "ITEM: BOX BOUNDS pp pp pp\n0 10\n0 10\n0 10\n"
for numbers in ((2, 3, 2), (3, 2, 3), (3, 3, 2, 3)):
    with open("film.xyz", "w") as film:
        for number in numbers:
            film.write(f"{number}\na frame\n" + "".join(f"A {i} {i} 0\n" for i in range(number)))
    trajectory = MDAnalysis.Universe("film.xyz").trajectory
    print(*numbers, end=f": {len(trajectory)} frames, read ")
    print(*[len(frame.positions) for frame in trajectory])
with open("film.lammpstrj", "w") as film:
    for step, number in enumerate((3, 2, 3)):
        film.write(f"ITEM: TIMESTEP\n{step}\nITEM: NUMBER OF ATOMS\n{number}\n{bounds}ITEM: ATOMS id type x y z\n")
        film.write("".join(f"{i + 1} 1 {i} {i} 0\n" for i in range(number)))
try:
    universe = MDAnalysis.Universe("film.lammpstrj", format="LAMMPSDUMP", topology_format="LAMMPSDUMP")
    print("dump 3 2 3: read", *[len(frame.positions) for frame in universe.trajectory])
except Exception as error:
    print("dump 3 2 3:", type(error).__name__)
PYTHON
cat seen
diff seen - <<'SEEN'
2 3 2: 3 frames, read 2 2
3 2 3: 3 frames, read 3
3 3 2 3: 4 frames, read 3 3
dump 3 2 3: ValueError
SEEN
