#!/usr/bin/env bash
# Yade 2023.02a (Debian 12: yade 2023.02a-1): the stress of a periodic cell in which two spheres of radius 0.5 push each other
# along x and one of them moves at 30 along x: utils.getStress, and utils.getTotalDynamicStress for the part of the motion.
#
# Guess: the two add up, as their descriptions have it: compression is negative in the one, and the other is
# - sum of m u' u' / V.
# Seen: getTotalDynamicStress is + sum of m u' u' / V. Added to getStress the motion, which presses outwards, takes away from the
# pressure of the contacts, and the pressure of a fast granular gas is tension. Subtract it.
#   described as - \frac{1}{V}\sum_p m^p u'^p \otimes u'^p
#   speed 0: getStress -1250, m u' u' / V 0, getTotalDynamicStress 0
#   speed 30: getStress -1250, m u' u' / V 7363, getTotalDynamicStress 7363
set -euo pipefail
want=2023.02a-1
version=$(dpkg-query -W -f='${Version}' yade 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs yade $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > stress.py <<'PYTHON'
from yade import utils

print("SEEN described as", utils.getTotalDynamicStress.__doc__.split("$")[1].split("=")[1].strip())
for speed in (0, 30):
    O.reset()
    O.periodic = True
    O.cell.hSize = Matrix3(4, 0, 0, 0, 4, 0, 0, 0, 4)
    material = O.materials.append(FrictMat(young=1e6, poisson=0.3, density=1000, frictionAngle=0))
    for x in (1.5, 2.3):
        O.bodies.append(utils.sphere((x, 2, 2), 0.5, material=material))
    O.bodies[1].state.vel = (speed, 0, 0)
    O.engines = [
        ForceResetter(),
        InsertionSortCollider([Bo1_Sphere_Aabb()]),
        InteractionLoop([Ig2_Sphere_Sphere_ScGeom()], [Ip2_FrictMat_FrictMat_FrictPhys()],
                        [Law2_ScGeom_FrictPhys_CundallStrack()]),
        NewtonIntegrator(damping=0),
    ]
    O.dt = 1e-9
    O.run(2, True)
    motion = sum(body.state.mass * body.state.vel[0]**2 for body in O.bodies) / O.cell.volume
    print(f"SEEN speed {speed}: getStress {utils.getStress()[0, 0]:.0f}, m u' u' / V {motion:.0f}, "
          f"getTotalDynamicStress {utils.getTotalDynamicStress()[0, 0]:.0f}")
PYTHON
timeout 60 yade -x -n -j1 stress.py > messages 2>&1 || { cat messages; exit 1; }
sed -n 's/^SEEN //p' messages > seen
cat seen
diff seen - <<'SEEN'
described as - \frac{1}{V}\sum_p m^p u'^p \otimes u'^p
speed 0: getStress -1250, m u' u' / V 0, getTotalDynamicStress 0
speed 30: getStress -1250, m u' u' / V 7363, getTotalDynamicStress 7363
SEEN
