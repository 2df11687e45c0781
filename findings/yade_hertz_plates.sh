#!/usr/bin/env bash
# Yade 2023.02a (Debian 12: yade 2023.02a-1), the law of Hertz and Mindlin (Ip2_FrictMat_FrictMat_MindlinPhys): a grain of radius
# 0.5 that overlaps by 0.01 with a plate of the same material as a wall, a box, a facet of a large triangle, or a sphere of radius
# 5000, and with a grain like itself; the force over that of Hertz, 4/3 E' sqrt(R') overlap^1.5, with R' = 0.5 for a plate, and
# 0.25 for two grains, and the tangential stiffness over that of Mindlin.
#
# Guess: 1 for each, as for the pair.
# Seen: a wall or a box is taken for a second grain of the same radius, a facet for one of twice the radius: both forces are too
# small by 29% and 18%, those of the contacts between grains right. So a grain between two plates is softer at its plates than one
# between two large spheres, a packing is softer at its walls, and a plate made of facets is another one than a wall. It
# does not depend on the material. Take a large sphere for the plate.
#   wall: force 0.707, stiffness 0.707
#   box: force 0.707, stiffness 0.707
#   facet: force 0.816, stiffness 0.816
#   sphere of radius 5000: force 1.000, stiffness 1.000
#   grain: force 1.000, stiffness 1.000
set -euo pipefail
want=2023.02a-1
version=$(dpkg-query -W -f='${Version}' yade 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs yade $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > plates.py <<'PYTHON'
import math

from yade import utils

YOUNG, POISSON, RADIUS, OVERLAP = 1e6, 0.3, 0.5, 0.01


def show(name, make, radius_of_curvature):
    O.reset()
    material = O.materials.append(FrictMat(young=YOUNG, poisson=POISSON, frictionAngle=0.5, density=1000))
    O.bodies.append(utils.sphere((0, 0, RADIUS - OVERLAP), RADIUS, material=material, fixed=True))
    O.bodies.append(make(material))
    O.engines = [
        ForceResetter(),
        InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Wall_Aabb(), Bo1_Facet_Aabb(), Bo1_Box_Aabb()]),
        InteractionLoop(
            [Ig2_Sphere_Sphere_ScGeom(), Ig2_Wall_Sphere_ScGeom(), Ig2_Facet_Sphere_ScGeom(), Ig2_Box_Sphere_ScGeom()],
            [Ip2_FrictMat_FrictMat_MindlinPhys()],
            [Law2_ScGeom_MindlinPhys_Mindlin()],
        ),
        NewtonIntegrator(),
    ]
    O.dt = 1e-9
    O.step()
    contact = O.interactions[0, 1].phys
    force = 4 / 3 * YOUNG / (2 * (1 - POISSON**2)) * math.sqrt(radius_of_curvature) * OVERLAP**1.5
    shear = YOUNG / (2 * (1 + POISSON))
    tangential = 4 * shear / (2 - POISSON) * math.sqrt(radius_of_curvature * OVERLAP)
    print(f"SEEN {name}: force {contact.normalForce.norm() / force:.3f}, stiffness {contact.ks / tangential:.3f}")


show("wall", lambda m: utils.wall(0, axis=2, material=m), RADIUS)
show("box", lambda m: utils.box((0, 0, -0.1), (3, 3, 0.1), material=m, fixed=True), RADIUS)
show("facet", lambda m: utils.facet([(-3, -3, 0), (3, -3, 0), (0, 4, 0)], material=m), RADIUS)
show("sphere of radius 5000", lambda m: utils.sphere((0, 0, -5000), 5000, material=m, fixed=True), RADIUS)
show("grain", lambda m: utils.sphere((0, 0, -RADIUS), RADIUS, material=m, fixed=True), RADIUS / 2)
PYTHON
timeout 60 yade -x -n -j1 plates.py > messages 2>&1 || { cat messages; exit 1; }
sed -n 's/^SEEN //p' messages > seen
cat seen
diff seen - <<'SEEN'
wall: force 0.707, stiffness 0.707
box: force 0.707, stiffness 0.707
facet: force 0.816, stiffness 0.816
sphere of radius 5000: force 1.000, stiffness 1.000
grain: force 1.000, stiffness 1.000
SEEN
