#!/usr/bin/env bash
# Yade 2023.02a (Debian 12: yade 2023.02a-1): a packing written by yade.export and read by yade.ymport.
#
# Guess: what is read exerts the forces of what was written, to rounding.
# Seen: export.text, textExt, SpherePack.save and VTKExporter write six digits, the last under the heading "double". Two grains
# that overlap by a millionth of their diameter, far from the origin by twelve diameters, no longer touch once read: the force of
# 0.5 is gone, and with it the contacts of a packing near jamming. Use O.save, or write the numbers yourself.
#   text: 12.3457 13.3457
#   VTK: POINTS 2 double 12.3457 13.3457
#   force: 0.500 written, 0.000 read
set -euo pipefail
want=2023.02a-1
version=$(dpkg-query -W -f='${Version}' yade 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs yade $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > digits.py <<'PYTHON'
from yade import export, ymport


def force(bodies):
    O.reset()
    O.materials.append(FrictMat(young=1e6, poisson=0.3, frictionAngle=0.5, density=1000))
    O.bodies.append(bodies())
    O.engines = [ForceResetter(), InsertionSortCollider([Bo1_Sphere_Aabb()]),
                 InteractionLoop([Ig2_Sphere_Sphere_ScGeom()], [Ip2_FrictMat_FrictMat_FrictPhys()],
                                 [Law2_ScGeom_FrictPhys_CundallStrack()]), NewtonIntegrator(damping=0)]
    O.dt = 1e-9
    O.step()
    return sum(contact.phys.normalForce.norm() for contact in O.interactions if contact.isReal)


written = force(lambda: [sphere((x, 0, 0), 0.5) for x in (12.3456789, 13.3456779)])
export.text("packing.txt")
export.VTKExporter("packing").exportSpheres()
read = force(lambda: ymport.text("packing.txt"))
print("SEEN text:", *[line.split()[0] for line in open("packing.txt") if line[0] != "#"])
lines = open("packing-spheres-00000000.vtk").read().split("\n")
start = next(i for i, line in enumerate(lines) if line.startswith("POINTS"))
print("SEEN VTK:", lines[start], *[line.split()[0] for line in lines[start + 1:start + 3]])
print(f"SEEN force: {written:.3f} written, {read:.3f} read")
PYTHON
HOME=$folder OMP_NUM_THREADS=1 yade -n -x digits.py > screen 2>&1 || { cat screen; exit 1; }
sed -n 's/^SEEN //p' screen > seen
cat seen
diff seen - <<'SEEN'
text: 12.3457 13.3457
VTK: POINTS 2 double 12.3457 13.3457
force: 0.500 written, 0.000 read
SEEN
