#!/usr/bin/env bash
# vedo 2023.4.3 (Debian 12: python3-vedo 2023.4.3-1): volume and area of grains, from its own shapes and from a mesh of the user.
#
# Guess: as in closed form, up to the number of facets; a surface that cannot be measured is an error.
# Seen: only triangles count. A cube and a cylinder have volume 0 and area 0, as does any mesh of quadrangles; a cone has the
# volume that its base spans, 37% of the true one, while is_closed() says True. No warning. ConvexHull lacks 2% of the hull of 200
# points. And .obj files are written with five digits, so that a grain of size 1 at 1000 has corners off by 0.03.
# Call triangulate() first; take the hull from SciPy; write .ply or .vtk.
#   cube: closed False, volume 0.000 of the true one, area 0.000; triangulated 1.000, area 6.000
#   cylinder: closed False, volume 0.000 of the true one, area 0.000; triangulated 0.989, area 12.477
#   cone: closed True, volume 0.366 of the true one, area 4.435; triangulated 0.997, area 7.568
#   box of quadrangles: closed True, volume 0.000 of the true one, area 0.000; triangulated 1.000, area 22.000
#   hull: 0.984 of the true one
#   obj: corners off by 0.03
set -euo pipefail
want=2023.4.3-1
version=$(dpkg-query -W -f='${Version}' python3-vedo 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs python3-vedo $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
/usr/bin/python3 - > seen 2>messages <<'PYTHON' || { cat messages; exit 1; }
import numpy
import vedo
from scipy.spatial import ConvexHull

corners = [[x, y, z] for x in (0, 1) for y in (0, 2) for z in (0, 3)]
faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
for name, shape, volume in (("cube", vedo.Cube(side=1), 1), ("cylinder", vedo.Cylinder(r=1, height=1), numpy.pi),
                            ("cone", vedo.Cone(r=1, height=1), numpy.pi / 3), ("box of quadrangles", vedo.Mesh([corners, faces]), 6)):
    closed, seen, area = shape.is_closed(), shape.volume(), shape.area()
    triangles = shape.clone().triangulate()
    print(f"{name}: closed {closed}, volume {seen / volume:.3f} of the true one, area {area:.3f}; "
          f"triangulated {triangles.volume() / volume:.3f}, area {triangles.area():.3f}")
points = numpy.random.RandomState(1).rand(200, 3)
hull = vedo.ConvexHull(points).triangulate()
print(f"hull: {hull.volume() / ConvexHull(points).volume:.3f} of the true one")
grain = vedo.Mesh([numpy.array(corners) / 3 + 1000, faces]).triangulate()
vedo.write(grain, "grain.obj")
print(f"obj: corners off by {abs(vedo.load('grain.obj').points() - grain.points()).max():.2f}")
PYTHON
cat messages seen
diff seen - <<'SEEN'
cube: closed False, volume 0.000 of the true one, area 0.000; triangulated 1.000, area 6.000
cylinder: closed False, volume 0.000 of the true one, area 0.000; triangulated 0.989, area 12.477
cone: closed True, volume 0.366 of the true one, area 4.435; triangulated 0.997, area 7.568
box of quadrangles: closed True, volume 0.000 of the true one, area 0.000; triangulated 1.000, area 22.000
hull: 0.984 of the true one
obj: corners off by 0.03
SEEN
