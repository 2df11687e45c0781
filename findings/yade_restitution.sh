#!/usr/bin/env bash
# Yade 2023.02a (Debian 12: yade 2023.02a-1): a sphere of radius 1 bounces with ViscElMat, whose `en` is the coefficient of
# restitution.
#
# Guess: it parts with `en` times its speed, from another sphere as from a wall.
# Seen: always faster, and by how much depends on what it meets. Two spheres of `en` 0.5 part with 0.55: damping is that of a
# spring which may pull, and the law lets go as soon as the force would pull. A wall, a facet and a fixed sphere of radius 1
# give 0.646: the damping is taken for half the mass of the sphere, as if the other one moved as well. A fixed sphere of radius
# 100 is right but for the pull; one of radius 0.1 does not turn the sphere back within two contact times. Measure a bounce.
#   en 0.9: sphere 0.902, wall 0.929, fixed sphere 0.929, large fixed sphere 0.902
#   en 0.5: sphere 0.550, wall 0.646, fixed sphere 0.646, large fixed sphere 0.550
#   en 0.2: sphere 0.324, wall 0.429, fixed sphere 0.429, large fixed sphere 0.324
set -euo pipefail
want=2023.02a-1
version=$(dpkg-query -W -f='${Version}' yade 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs yade $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > bounce.py <<'PYTHON'
from yade import utils


def bounce(en, other):
    O.reset()
    material = O.materials.append(ViscElMat(density=1000, tc=0.01, en=en, et=1, frictionAngle=0))
    O.bodies.append(utils.sphere((1, 0, 0), 1, material=material))
    if other == "wall":
        O.bodies.append(utils.wall(0, 0, material=material))
    else:
        radius = 100 if other.startswith("large") else 1
        O.bodies.append(utils.sphere((-radius, 0, 0), radius, material=material, fixed="fixed" in other))
    O.bodies[0].state.vel = (-1, 0, 0)
    O.engines = [
        ForceResetter(),
        InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Wall_Aabb()]),
        InteractionLoop([Ig2_Sphere_Sphere_ScGeom(), Ig2_Wall_Sphere_ScGeom()], [Ip2_ViscElMat_ViscElMat_ViscElPhys()],
                        [Law2_ScGeom_ViscElPhys_Basic()]),
        NewtonIntegrator(damping=0),
    ]
    O.dt = 5e-6
    O.run(4000, True)
    return O.bodies[0].state.vel[0] - O.bodies[1].state.vel[0]


for en in (0.9, 0.5, 0.2):
    print(f"SEEN en {en}: " + ", ".join(f"{other} {bounce(en, other):.3f}"
                                        for other in ("sphere", "wall", "fixed sphere", "large fixed sphere")))
PYTHON
yade -x -n -j1 bounce.py 2>/dev/null | sed -n 's/^SEEN //p' > seen
cat seen
diff seen - <<'SEEN'
en 0.9: sphere 0.902, wall 0.929, fixed sphere 0.929, large fixed sphere 0.902
en 0.5: sphere 0.550, wall 0.646, fixed sphere 0.646, large fixed sphere 0.550
en 0.2: sphere 0.324, wall 0.429, fixed sphere 0.429, large fixed sphere 0.324
SEEN
