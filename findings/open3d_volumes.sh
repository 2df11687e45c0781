#!/usr/bin/env bash
# Open3D 0.16.1 (Debian 12: python3-open3d 0.16.1+ds-2+b4): the size of its polyhedra, and the volume of a closed surface.
#
# Guess: create_icosahedron(radius) has its corners at that radius, as its description says and as the tetrahedron and octahedron
# have. get_volume(), which refuses a surface that is not closed or cannot be oriented, is right for all that it takes.
# Seen: the icosahedron is 1.902 times as large, and its volume 6.88 times. Where a sphere has triangles that are listed the other
# way round, it counts as watertight and orientable, which says that it could be oriented, and the volume is anything: 61% of it
# for a fifth of the triangles, 1% for half of them. Call orient_triangles() before, which makes it right.
#   tetrahedron of radius 1, 2: corners at 1.000, 2.000
#   octahedron of radius 1, 2: corners at 1.000, 2.000
#   icosahedron of radius 1, 2: corners at 1.902, 3.804
#   sphere of radius 1, 2: corners at 1.000, 2.000
#   share of triangles turned 0: watertight True, orientable True, volume 4.178, oriented 4.178
#   share of triangles turned 0.1: watertight True, orientable True, volume 3.367, oriented 4.178
#   share of triangles turned 0.2: watertight True, orientable True, volume 2.547, oriented 4.178
#   share of triangles turned 0.5: watertight True, orientable True, volume 0.037, oriented 4.178
set -euo pipefail
want=0.16.1+ds-2+b4
version=$(dpkg-query -W -f='${Version}' python3-open3d 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs python3-open3d $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > volumes.py <<'PYTHON'
import numpy
import open3d

make = open3d.geometry.TriangleMesh
for name in ("tetrahedron", "octahedron", "icosahedron", "sphere"):
    radii = [numpy.linalg.norm(numpy.asarray(getattr(make, f"create_{name}")(r).vertices), axis=1).max() for r in (1, 2)]
    print(f"{name} of radius 1, 2: corners at {radii[0]:.3f}, {radii[1]:.3f}")
for part in (0, 0.1, 0.2, 0.5):
    sphere = make.create_sphere(1, 40)
    corners = numpy.asarray(sphere.triangles)
    turned = numpy.random.RandomState(1).rand(len(corners)) < part
    sphere.triangles = open3d.utility.Vector3iVector(numpy.where(turned[:, None], corners[:, ::-1], corners))
    said = f"watertight {sphere.is_watertight()}, orientable {sphere.is_orientable()}, volume {sphere.get_volume():.3f}"
    sphere.orient_triangles()
    print(f"share of triangles turned {part}: {said}, oriented {sphere.get_volume():.3f}")
PYTHON
/usr/bin/python3 volumes.py > seen 2> messages || { cat messages; exit 1; }
cat seen
diff seen - <<'SEEN'
tetrahedron of radius 1, 2: corners at 1.000, 2.000
octahedron of radius 1, 2: corners at 1.000, 2.000
icosahedron of radius 1, 2: corners at 1.902, 3.804
sphere of radius 1, 2: corners at 1.000, 2.000
share of triangles turned 0: watertight True, orientable True, volume 4.178, oriented 4.178
share of triangles turned 0.1: watertight True, orientable True, volume 3.367, oriented 4.178
share of triangles turned 0.2: watertight True, orientable True, volume 2.547, oriented 4.178
share of triangles turned 0.5: watertight True, orientable True, volume 0.037, oriented 4.178
SEEN
