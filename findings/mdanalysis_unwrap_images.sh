#!/usr/bin/env bash
# MDAnalysis 2.4.2 (Debian 12: python3-mdanalysis 2.4.2+dfsg1-1+b1) reading LAMMPS text dumps with unwrap_images=True, which
# adds the images ix, iy, iz, as one does for displacements.
#
# Guess: an image iy adds the second vector of the cell, whichever columns hold the coordinates.
# Seen: it adds the length of that vector along y. In a cell sheared by 0.5 the particle of image (1, 1) comes out by 4 too
# small in x and 0.94 too large in y, and mean square displacements grow with every crossing. With scaled columns (xs ys zs)
# also a rectangular cell goes wrong: the lengths are added to the fractions, then all is multiplied by them. Dump xu yu zu.
#   rectangular x: [15.0, 10.0, 0.0], in truth [15.0, 10.0, 0.0]
#   rectangular xs: [105.0, 66.0, 0.0], in truth [15.0, 10.0, 0.0]
#   sheared x: [15.0, 10.944, 0.0], in truth [19.0, 10.0, 0.0]
#   sheared xs: [140.777, 73.554, 0.0], in truth [19.0, 10.0, 0.0]
set -euo pipefail
want=2.4.2+dfsg1-1+b1
version=$(dpkg-query -W -f='${Version}' python3-mdanalysis 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs python3-mdanalysis $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
/usr/bin/python3 -W ignore - > seen 2>messages <<'PYTHON' || { cat messages; exit 1; }
import MDAnalysis

cells = {"rectangular": "ITEM: BOX BOUNDS pp pp pp\n0 10\n0 8\n0 1\n",
         "sheared": "ITEM: BOX BOUNDS xy xz yz pp pp pp\n0 14 4\n0 8 0\n0 1 0\n"}
# One particle at (5, 2), whose image is (1, 1); its fractions of the sheared cell are (0.4, 0.25).
rows = {("rectangular", "x"): "5 2 0", ("rectangular", "xs"): "0.5 0.25 0",
        ("sheared", "x"): "5 2 0", ("sheared", "xs"): "0.4 0.25 0"}
for (cell, column), row in rows.items():
    columns = "x y z" if column == "x" else "xs ys zs"
    with open("one.lammpstrj", "w") as file:
        file.write("ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\n" + cells[cell])
        file.write(f"ITEM: ATOMS id type {columns} ix iy iz\n1 1 {row} 1 1 0\n")
    universe = MDAnalysis.Universe("one.lammpstrj", format="LAMMPSDUMP", topology_format="LAMMPSDUMP", unwrap_images=True)
    position = [round(float(x), 3) for x in universe.atoms.positions[0]]
    print(f"{cell} {column}: {position}, in truth {[19.0 if cell == 'sheared' else 15.0, 10.0, 0.0]}")
PYTHON
cat seen
diff seen - <<'SEEN'
rectangular x: [15.0, 10.0, 0.0], in truth [15.0, 10.0, 0.0]
rectangular xs: [105.0, 66.0, 0.0], in truth [15.0, 10.0, 0.0]
sheared x: [15.0, 10.944, 0.0], in truth [19.0, 10.0, 0.0]
sheared xs: [140.777, 73.554, 0.0], in truth [19.0, 10.0, 0.0]
SEEN
