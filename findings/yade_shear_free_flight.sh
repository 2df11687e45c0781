#!/usr/bin/env bash
# Yade 2023.02a (Debian 12: yade 2023.02a-1), a lone grain in a periodic cell that is sheared at rate 1 (O.cell.velGrad), without
# damping and gravity: it starts at rest in the flow at height 0.5, with velocity 1 along y, and touches nothing.
#
# Guess: it keeps its velocity (0.5, 1, 0), as there is no force, and has moved by 2 along x after 4 s.
# Seen: it is accelerated by rate times velocity along y, so that it always has the velocity of the flow where it is, (4.5, 1, 0) in
# the end, and has moved by 10. Against the flow it has the velocity 1 along y for ever, in place of one that grows along x. So
# motion carries no shear stress: a granular gas, or the share of motion in a rapid flow, has no viscosity. No warning; this is
# the default of O.cell.homoDeform, 2. With 1 or 0 it flies straight.
#   default, 1 s: moved by 1.0 along x, velocity 1.50, 1.00, shear of the cell 1.0
#   default, 4 s: moved by 10.0 along x, velocity 4.50, 1.00, shear of the cell 4.0
#   homoDeform 1, 1 s: moved by 0.5 along x, velocity 0.50, 1.00, shear of the cell 1.0
#   homoDeform 1, 4 s: moved by 2.0 along x, velocity 0.50, 1.00, shear of the cell 4.0
#   homoDeform 0, 1 s: moved by 0.5 along x, velocity 0.50, 1.00, shear of the cell 1.0
#   homoDeform 0, 4 s: moved by 2.0 along x, velocity 0.50, 1.00, shear of the cell 4.0
set -euo pipefail
want=2023.02a-1
version=$(dpkg-query -W -f='${Version}' yade 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs yade $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > fly.py <<'PYTHON'
from yade import utils


def fly(name, deform):
    O.reset()
    O.periodic = True
    O.cell.hSize = Matrix3(4, 0, 0, 0, 4, 0, 0, 0, 4)
    O.cell.homoDeform = deform
    grain = O.bodies[O.bodies.append(utils.sphere((1, 0.5, 1), 0.5))]
    O.engines = [ForceResetter(), NewtonIntegrator(damping=0)]
    O.dt = 1e-3
    O.cell.velGrad = Matrix3(0, 1, 0, 0, 0, 0, 0, 0, 0)
    O.run(1, True)
    grain.state.vel = (0.5, 1, 0)
    start = grain.state.pos[0]
    for second in (1, 4):
        O.run(1000 * second + 1 - O.iter, True)
        print(f"SEEN {name}, {second} s: moved by {grain.state.pos[0] - start:.1f} along x, velocity {grain.state.vel[0]:.2f}, "
              f"{grain.state.vel[1]:.2f}, shear of the cell {O.cell.hSize[0, 1] / 4:.1f}")


fly("default", 2)
fly("homoDeform 1", 1)
fly("homoDeform 0", 0)
PYTHON
timeout 60 yade -x -n -j1 fly.py > messages 2>&1 || { cat messages; exit 1; }
sed -n 's/^SEEN //p' messages > seen
cat seen
diff seen - <<'SEEN'
default, 1 s: moved by 1.0 along x, velocity 1.50, 1.00, shear of the cell 1.0
default, 4 s: moved by 10.0 along x, velocity 4.50, 1.00, shear of the cell 4.0
homoDeform 1, 1 s: moved by 0.5 along x, velocity 0.50, 1.00, shear of the cell 1.0
homoDeform 1, 4 s: moved by 2.0 along x, velocity 0.50, 1.00, shear of the cell 4.0
homoDeform 0, 1 s: moved by 0.5 along x, velocity 0.50, 1.00, shear of the cell 1.0
homoDeform 0, 4 s: moved by 2.0 along x, velocity 0.50, 1.00, shear of the cell 4.0
SEEN
