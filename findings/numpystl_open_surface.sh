#!/usr/bin/env bash
# numpy-stl 2.9.0 (Debian 12: python3-stl 2.9.0-2+b3): is the surface of a particle closed, and its volume.
#
# Guess: is_closed() is False for a unit cube without one of its six faces, whichever it is.
# Seen: it is True where the missing face looked along +x, +y or +z, and False where along -x, -y or -z: it asks whether the
# sum of the normals has a component above 1e-4, not of either sign, and a tube (two faces missing) is closed as well. The
# volume and centre then are those of no body (-2 for the cube from 2 to 3), and get_mass_properties() gives no warning.
# Count the edges that only one triangle has.
#   missing nothing: closed True, volume 1.0
#   missing -x: closed False, volume 3.0
#   missing +x: closed True, volume -2.0
#   missing -z: closed False, volume 1.0
#   missing +z: closed True, volume 1.0
#   missing -z +z: closed True, volume 1.0
set -euo pipefail
want=2.9.0-2+b3
version=$(dpkg-query -W -f='${Version}' python3-stl 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs python3-stl $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
/usr/bin/python3 -W ignore - > seen 2>messages <<'PYTHON' || { cat messages; exit 1; }
import numpy
from stl import mesh

corners = numpy.array([[x, y, z] for x in (2, 3) for y in (2, 3) for z in (2, 3)], float)
faces = {"-x": (0, 1, 3, 2), "+x": (4, 6, 7, 5), "-y": (0, 4, 5, 1), "+y": (2, 3, 7, 6), "-z": (0, 2, 6, 4), "+z": (1, 5, 7, 3)}
for missing in ("nothing", "-x", "+x", "-z", "+z", "-z +z"):
    kept = [face for name, face in faces.items() if name not in missing.split()]
    triangles = [[a, b, c] for a, b, c, _ in kept] + [[a, c, d] for a, _, c, d in kept]
    cube = mesh.Mesh(numpy.zeros(len(triangles), dtype=mesh.Mesh.dtype))
    cube.vectors[:] = corners[triangles]
    cube.save("cube.stl")
    cube = mesh.Mesh.from_file("cube.stl")
    print(f"missing {missing}: closed {cube.is_closed()}, volume {cube.get_mass_properties()[0]:.1f}")
PYTHON
cat seen
diff seen - <<'SEEN'
missing nothing: closed True, volume 1.0
missing -x: closed False, volume 3.0
missing +x: closed True, volume -2.0
missing -z: closed False, volume 1.0
missing +z: closed True, volume 1.0
missing -z +z: closed True, volume 1.0
SEEN
