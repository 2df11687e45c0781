#!/usr/bin/env bash
# meshio 7.0.0 (Debian 12: python3-meshio 7.0.0-3) reading a .vtk file of polygons that VTK wrote (DATASET POLYDATA).
#
# Guess: the mesh, or a ReadError.
# Seen: meshio.read ends the program: it prints the error and calls sys.exit(1), so that `except Exception` does not catch it,
# and a script over many files stops there. meshio.vtk.read, the same reader under its own name, raises ReadError. Catch
# SystemExit, or call the reader of the format. (The same polygons as UNSTRUCTURED_GRID are read.)
#   meshio.read: SystemExit 1, an Exception: False
#   meshio.vtk.read: ReadError, an Exception: True
set -euo pipefail
want=7.0.0-3
version=$(dpkg-query -W -f='${Version}' python3-meshio 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs python3-meshio $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > polygons.vtk <<'VTK'
# vtk DataFile Version 3.0
one triangle
ASCII
DATASET POLYDATA
POINTS 3 double
0 0 0
1 0 0
0 1 0
POLYGONS 1 4
3 0 1 2
VTK
/usr/bin/python3 -W ignore - > seen 2>messages <<'PYTHON' || { cat messages; exit 1; }
import contextlib
import io

import meshio

for name, read in (("meshio.read", meshio.read), ("meshio.vtk.read", meshio.vtk.read)):
    said = io.StringIO()
    try:
        with contextlib.redirect_stdout(said):
            read("polygons.vtk")
        print(f"{name}: read")
    except BaseException as error:
        code = f" {error.code}" if isinstance(error, SystemExit) else ""
        print(f"{name}: {type(error).__name__}{code}, an Exception: {isinstance(error, Exception)}")
PYTHON
cat seen
diff seen - <<'SEEN'
meshio.read: SystemExit 1, an Exception: False
meshio.vtk.read: ReadError, an Exception: True
SEEN
