#!/usr/bin/env bash
# Yade 2023.02a (Debian 12: yade 2023.02a-1): two spheres in a periodic cell sheared at rate 1 (O.cell.velGrad), in the same
# contact three times: inside the cell, across its side, and across its top, where the image moves faster by 4.
#
# Guess: the same forces in the three places, with the viscous law (ViscElMat) as with the frictional one (FrictMat).
# Seen: across the top ViscElMat has other forces: 6 per cent more along the contact, and 37 times as much across it, the other
# way, as if the grains moved past each other at many times the speed of the flow. Across the side, whose image moves along, it
# is right. FrictMat, and FrictMat with MindlinPhys and damping, have the same forces in all places. Each grain that meets
# another across the top is so kicked. Take MindlinPhys with en and es.
#   ViscElMat: inside normal 2580.5 shear 0.252, side normal 2580.5 shear 0.252, top normal 2737.4 shear 9.43
#   FrictMat: inside normal 49.3 shear 0.00548, side normal 49.3 shear 0.00548, top normal 49.3 shear 0.00548
set -euo pipefail
want=2023.02a-1
version=$(dpkg-query -W -f='${Version}' yade 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs yade $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > contact.py <<'PYTHON'
from yade import utils


def forces(name, first, second):
    O.reset()
    O.periodic = True
    O.cell.hSize = Matrix3(4, 1.2, 0, 0, 4, 0, 0, 0, 4)
    O.cell.velGrad = Matrix3(0, 1, 0, 0, 0, 0, 0, 0, 0)
    if name == "ViscElMat":
        material = ViscElMat(density=1000, tc=0.01, en=0.5, et=0.5, frictionAngle=1)
        physics, law = Ip2_ViscElMat_ViscElMat_ViscElPhys(), Law2_ScGeom_ViscElPhys_Basic()
    else:
        material = FrictMat(young=1e6, poisson=0.3, density=1000, frictionAngle=1)
        physics, law = Ip2_FrictMat_FrictMat_FrictPhys(), Law2_ScGeom_FrictPhys_CundallStrack()
    number = O.materials.append(material)
    for centre in (first, second):
        O.bodies.append(utils.sphere(centre, 0.5, material=number))
    for body in O.bodies:
        body.state.vel = O.cell.velGrad * body.state.pos
    O.engines = [ForceResetter(), InsertionSortCollider([Bo1_Sphere_Aabb()]),
                 InteractionLoop([Ig2_Sphere_Sphere_ScGeom()], [physics], [law]), NewtonIntegrator(damping=0)]
    O.dt = 1e-5
    O.run(20, True)
    contact, = (each for each in O.interactions if each.isReal)
    return f"normal {contact.phys.normalForce.norm() / 1000:.1f} shear {contact.phys.shearForce.norm() / 1000:.3g}"


places = {"inside": ((2, 2, 2), (2.5, 2.75, 2)), "side": ((3.8, 2, 2), (0.3, 2.75, 2)), "top": ((2, 3.6, 2), (1.3, 0.35, 2))}
for name in ("ViscElMat", "FrictMat"):
    print(f"SEEN {name}: " + ", ".join(f"{place} {forces(name, *pair)}" for place, pair in places.items()))
PYTHON
yade -x -n -j1 contact.py 2>/dev/null | sed -n 's/^SEEN //p' > seen
cat seen
diff seen - <<'SEEN'
ViscElMat: inside normal 2580.5 shear 0.252, side normal 2580.5 shear 0.252, top normal 2737.4 shear 9.43
FrictMat: inside normal 49.3 shear 0.00548, side normal 49.3 shear 0.00548, top normal 49.3 shear 0.00548
SEEN
