#!/usr/bin/env bash
# Open3D 0.16.1 (Debian 12: python3-open3d 0.16.1+ds-2+b4): unit cubes of twelve triangles, as a check of surfaces before a
# simulation: is_watertight(), is_orientable() and get_volume(), which is an error where one of the two is false.
#
# Guess: a cube with one triangle turned inwards is not orientable, or has volume 1; a cube whose triangles all look inwards has
# volume -1, which tells that they do; after orient_triangles() triangles look outwards, as most did.
# Seen: orientable means that the triangles could be turned to agree, and the volume is that of the triangles as they are, by its
# absolute value: 0.67 or 1.00 for the cube, by which triangle is turned, 0.00 for two cubes of which one is inside-out, and 1.00
# for one that is inside-out as a whole. orient_triangles() makes all agree with one of each part, so that the cube whose last
# triangle was turned is inside-out. Sum up the signed volumes of the tetrahedra to the origin (in brackets), and see to it that
# the two triangles of each edge go along it in opposite ways.
#   outwards: watertight True, orientable True, volume 1.00 (1.00), turned to agree 1.00 (1.00)
#   the first turned: watertight True, orientable True, volume 1.00 (1.00), turned to agree 1.00 (1.00)
#   the last turned: watertight True, orientable True, volume 0.67 (0.67), turned to agree 1.00 (-1.00)
#   inwards: watertight True, orientable True, volume 1.00 (-1.00), turned to agree 1.00 (-1.00)
#   two, one inwards: watertight True, orientable True, volume 0.00 (0.00), turned to agree 0.00 (0.00)
set -euo pipefail
want=0.16.1+ds-2+b4
version=$(dpkg-query -W -f='${Version}' python3-open3d 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs python3-open3d $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > cubes.py <<'PYTHON'
import numpy
import open3d

corners = numpy.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
sides = ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3))
cube = numpy.array([triangle for a, b, c, d in sides for triangle in ((a, b, c), (a, c, d))])


def signed(mesh):
    a, b, c = numpy.asarray(mesh.vertices)[numpy.asarray(mesh.triangles).T]
    return round((a * numpy.cross(b, c)).sum() / 6, 9) + 0.0


def turned(*which):
    triangles = cube.copy()
    triangles[list(which)] = triangles[list(which)][:, ::-1]
    return triangles


def show(name, points, triangles):
    mesh = open3d.geometry.TriangleMesh(open3d.utility.Vector3dVector(points), open3d.utility.Vector3iVector(triangles))
    text = f"watertight {mesh.is_watertight()}, orientable {mesh.is_orientable()}, volume {mesh.get_volume():.2f}"
    before = signed(mesh)
    mesh.orient_triangles()
    print(f"SEEN {name}: {text} ({before:.2f}), turned to agree {mesh.get_volume():.2f} ({signed(mesh):.2f})")


two = numpy.vstack([corners, corners + [3, 0, 0]])
show("outwards", corners, cube)
show("the first turned", corners, turned(0))
show("the last turned", corners, turned(11))
show("inwards", corners, cube[:, ::-1])
show("two, one inwards", two, numpy.vstack([cube, cube[:, ::-1] + 8]))
PYTHON
/usr/bin/python3 cubes.py > messages 2>&1 || { cat messages; exit 1; }
sed -n 's/^SEEN //p' messages > seen
cat seen
diff seen - <<'SEEN'
outwards: watertight True, orientable True, volume 1.00 (1.00), turned to agree 1.00 (1.00)
the first turned: watertight True, orientable True, volume 1.00 (1.00), turned to agree 1.00 (1.00)
the last turned: watertight True, orientable True, volume 0.67 (0.67), turned to agree 1.00 (-1.00)
inwards: watertight True, orientable True, volume 1.00 (-1.00), turned to agree 1.00 (-1.00)
two, one inwards: watertight True, orientable True, volume 0.00 (0.00), turned to agree 0.00 (0.00)
SEEN
