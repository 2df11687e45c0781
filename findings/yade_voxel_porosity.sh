#!/usr/bin/env bash
# Yade 2023.02a (Debian 12: yade 2023.02a-1), a simple cubic packing of 64 touching spheres in a periodic cell (porosity 0.476),
# sheared: utils.porosity, and utils.voxelPorosity of the cell and of a cube inside it, for which the former has no answer.
#
# Guess: both give 0.476 for the cell, as often as it is asked, up to the size of a voxel.
# Seen: voxelPorosity takes each sphere where its unwrapped position is and knows no images. What reaches across the boundary of
# the cell is missing at the start (0.64), and whole grains are, once shear has carried them off: a cube in the middle of the
# cell, right at first, has 0.64 at strain 1. No error or warning; its description does not speak of periodic cells. Wrap the
# positions (O.cell.wrap) and add the images that reach in, in a scene without periodicity.
#   strain 0.0: porosity 0.48, voxelPorosity 0.64, of a cube inside 0.48
#   strain 0.5: porosity 0.48, voxelPorosity 0.64, of a cube inside 0.48
#   strain 1.0: porosity 0.48, voxelPorosity 0.73, of a cube inside 0.64
set -euo pipefail
want=2023.02a-1
version=$(dpkg-query -W -f='${Version}' yade 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs yade $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > shear.py <<'PYTHON'
from yade import utils

O.periodic = True
O.cell.hSize = Matrix3(4, 0, 0, 0, 4, 0, 0, 0, 4)
for site in range(64):
    O.bodies.append(utils.sphere((site % 4, site // 4 % 4, site // 16), 0.5))
O.engines = [ForceResetter(), NewtonIntegrator(damping=0)]
O.dt = 1e-3


def show():
    print(f"SEEN strain {O.cell.trsf[0, 1]:.1f}: porosity {utils.porosity():.2f}, "
          f"voxelPorosity {utils.voxelPorosity(100, (0, 0, 0), (4, 4, 4)):.2f}, "
          f"of a cube inside {utils.voxelPorosity(100, (1, 1, 1), (3, 3, 3)):.2f}")


show()
O.cell.velGrad = Matrix3(0, 1, 0, 0, 0, 0, 0, 0, 0)
O.run(501, True)
show()
O.run(500, True)
show()
PYTHON
timeout 60 yade -x -n -j1 shear.py > messages 2>&1 || { cat messages; exit 1; }
sed -n 's/^SEEN //p' messages > seen
cat seen
diff seen - <<'SEEN'
strain 0.0: porosity 0.48, voxelPorosity 0.64, of a cube inside 0.48
strain 0.5: porosity 0.48, voxelPorosity 0.64, of a cube inside 0.48
strain 1.0: porosity 0.48, voxelPorosity 0.73, of a cube inside 0.64
SEEN
