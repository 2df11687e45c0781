#!/usr/bin/env bash
# Yade 2023.02a (Debian 12: yade 2023.02a-1): the stress of two spheres of radius 0.5 that push each other along x in a periodic
# cell of 4 by 4 by 4, by utils.getStress and by utils.normalShearStressTensors, which splits it into the parts of normal and
# shear forces.
#
# Guess: the parts add up to the stress; with compressionPositive=True compression is positive.
# Seen: compressionPositive=True makes it negative, and the default makes it positive. And it is too large: the branch is the
# sum of the radii, not the distance of the centres that its description names: by 5 in 100 at an overlap of 0.05, by a quarter
# at one of 0.2. -F d / V by hand is what getStress gives.
#   distance 0.95: -F d / V -371.1, getStress -371.1, parts 390.6, with compressionPositive=True -390.6
#   distance 0.8: -F d / V -1250.0, getStress -1250.0, parts 1562.5, with compressionPositive=True -1562.5
set -euo pipefail
want=2023.02a-1
version=$(dpkg-query -W -f='${Version}' yade 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs yade $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > stress.py <<'PYTHON'
from yade import utils

for distance in (0.95, 0.8):
    O.reset()
    O.periodic = True
    O.cell.hSize = Matrix3(4, 0, 0, 0, 4, 0, 0, 0, 4)
    material = O.materials.append(FrictMat(young=1e6, poisson=0.3, density=1000, frictionAngle=0))
    for x in (2, 2 + distance):
        O.bodies.append(utils.sphere((x, 2, 2), 0.5, material=material))
    O.engines = [
        ForceResetter(),
        InsertionSortCollider([Bo1_Sphere_Aabb()]),
        InteractionLoop([Ig2_Sphere_Sphere_ScGeom()], [Ip2_FrictMat_FrictMat_FrictPhys()],
                        [Law2_ScGeom_FrictPhys_CundallStrack()]),
        NewtonIntegrator(damping=0),
    ]
    O.dt = 1e-9
    O.run(2, True)
    by_hand = -O.interactions[0, 1].phys.normalForce[0] * distance / 64
    normal, shear = utils.normalShearStressTensors()
    turned, _ = utils.normalShearStressTensors(compressionPositive=True)
    print(f"SEEN distance {distance}: -F d / V {by_hand:.1f}, getStress {utils.getStress()[0, 0]:.1f}, "
          f"parts {normal[0, 0] + shear[0, 0]:.1f}, with compressionPositive=True {turned[0, 0]:.1f}")
PYTHON
yade -x -n -j1 stress.py 2>/dev/null | sed -n 's/^SEEN //p' > seen
cat seen
diff seen - <<'SEEN'
distance 0.95: -F d / V -371.1, getStress -371.1, parts 390.6, with compressionPositive=True -390.6
distance 0.8: -F d / V -1250.0, getStress -1250.0, parts 1562.5, with compressionPositive=True -1562.5
SEEN
