#!/usr/bin/env bash
# voro++ 0.4.6 and LAMMPS 20220106 (Debian 12: voro++ 0.5+revert-to-0.4.6+dfsg1-1, lammps 20220106.git7586adbb6a+ds1-2+b2):
# Voronoi cells of the same thousand random points in a periodic cube with a side of 1, 1e-2, 1e-3 and 1e-4, as grains of
# 10 µm in metres; `compute voronoi/atom` in `units si`, with lists and range in proportion.
#
# Guess: volumes over that of the cube, and numbers of neighbours, are the same whatever the length.
# Seen: at 1e-3 one cell in a hundred has other neighbours than at 1, at 1e-4 seven in ten have, 14.3 in the mean in place of
# 15.6, and single volumes are off by 45%, though the volumes still add up to 0.1%, so that the usual check is passed. The
# tolerance for a plane that cuts a corner is 1e-11 in the square of the length, fixed when the library is built. LAMMPS calls
# it in the units of the run: there some volumes are 0 at 1e-4. Local packing fractions and contact numbers of grains in SI
# units are wrong; give it diameters of 1.
#   voro++, side 1: sum 1.000, largest change of a volume 0.000, other neighbours 0.000, neighbours 15.57
#   voro++, side 0.01: sum 1.000, largest change of a volume 0.000, other neighbours 0.000, neighbours 15.57
#   voro++, side 0.001: sum 1.000, largest change of a volume 0.001, other neighbours 0.011, neighbours 15.56
#   voro++, side 0.0001: sum 1.001, largest change of a volume 0.453, other neighbours 0.698, neighbours 14.34
#   LAMMPS, side 1: sum 1.000, least volume 9.39e-05, neighbours 15.54
#   LAMMPS, side 0.01: sum 1.000, least volume 9.39e-05, neighbours 15.54
#   LAMMPS, side 0.001: sum 1.000, least volume 9.39e-05, neighbours 15.53
#   LAMMPS, side 0.0001: sum 0.998, least volume 0.00e+00, neighbours 14.20
set -euo pipefail
for pair in voro++=0.5+revert-to-0.4.6+dfsg1-1 lammps=20220106.git7586adbb6a+ds1-2+b2 python3-numpy=; do
  name=${pair%%=*} want=${pair#*=}
  version=$(dpkg-query -W -f='${Version}' "$name" 2>/dev/null || true)
  [ -n "$version" ] && [ "${want:-$version}" = "$version" ] || { echo "needs $name $want, found '${version:-none}'"; exit 77; }
done
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > cells.py <<'PYTHON'
import subprocess

import numpy

points = numpy.random.RandomState(1).rand(1000, 3)
first = None
for side in (1, 1e-2, 1e-3, 1e-4):
    numpy.savetxt("points", numpy.c_[numpy.arange(1000), points * side], fmt="%d %.17g %.17g %.17g")
    subprocess.run(["voro++", "-p", "-c", "%i %v %s", *["0", repr(side)] * 3, "points"], check=True, stdout=subprocess.DEVNULL)
    cells = numpy.loadtxt("points.vol")
    cells = cells[cells[:, 0].argsort()] / [1, side**3, 1]
    first = cells if first is None else first
    change = abs(cells[:, 1] / first[:, 1] - 1).max()
    others = (cells[:, 2] != first[:, 2]).mean()
    print(f"voro++, side {side:g}: sum {cells[:, 1].sum():.3f}, largest change of a volume {change:.3f}, "
          f"other neighbours {others:.3f}, neighbours {cells[:, 2].mean():.2f}")
PYTHON
cat > cells.in <<'IN'
units si
atom_style sphere
region cell block 0 ${side} 0 ${side} 0 ${side}
create_box 1 cell
create_atoms 1 random 1000 5 cell
set group all diameter $(0.1*v_side)
neighbor $(0.05*v_side) bin
pair_style zero $(0.3*v_side)
pair_coeff * *
compute cells all voronoi/atom
compute sum all reduce sum c_cells[1]
compute least all reduce min c_cells[1]
compute faces all reduce ave c_cells[2]
thermo_style custom step c_sum c_least c_faces
run 0
print "SEEN LAMMPS, side ${side}: sum $(c_sum/v_side^3:%.3f), least volume $(c_least/v_side^3:%.2e), neighbours $(c_faces:%.2f)"
IN
{
  /usr/bin/python3 cells.py
  for side in 1 0.01 0.001 0.0001; do
    lmp -in cells.in -log none -var side "$side" | sed -n 's/^SEEN //p'
  done
} > seen
cat seen
diff seen - <<'SEEN'
voro++, side 1: sum 1.000, largest change of a volume 0.000, other neighbours 0.000, neighbours 15.57
voro++, side 0.01: sum 1.000, largest change of a volume 0.000, other neighbours 0.000, neighbours 15.57
voro++, side 0.001: sum 1.000, largest change of a volume 0.001, other neighbours 0.011, neighbours 15.56
voro++, side 0.0001: sum 1.001, largest change of a volume 0.453, other neighbours 0.698, neighbours 14.34
LAMMPS, side 1: sum 1.000, least volume 9.39e-05, neighbours 15.54
LAMMPS, side 0.01: sum 1.000, least volume 9.39e-05, neighbours 15.54
LAMMPS, side 0.001: sum 1.000, least volume 9.39e-05, neighbours 15.53
LAMMPS, side 0.0001: sum 0.998, least volume 0.00e+00, neighbours 14.20
SEEN
