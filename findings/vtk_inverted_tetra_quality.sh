#!/usr/bin/env bash
# VTK 9.1 (Debian 12: python3-vtk9 9.1.0+really9.1.0+dfsg2-5+deb12u1): all measures of vtkMeshQuality for a regular tetrahedron
# with a side of 1, for the same one turned inside out (two corners exchanged), as where a soft particle has been pushed through
# itself, and for a flat one whose four corners lie nearly in a square, as a Delaunay construction of a lattice makes them.
#
# Guess: an element that is inside out, which no finite element code can use, is worse than the flat one by each measure.
# Seen: by seven of fifteen measures, among them the one taken by default (the aspect ratio), the smallest angle and the
# distortion, it is as perfect as the regular one. Five have the sign, Shape is 0 and the two of the relative size are nan, by
# which "less than" picks nothing. The distortion of the flat one is perfect, too, and CollapseRatio, best when large, is 0.82
# for the best. Look at Volume, ScaledJacobian or Shape.
#   default: regular 1, inside out 1, flat 40.83
#   EdgeRatio: regular 1, inside out 1, flat 1.414
#   AspectRatio: regular 1, inside out 1, flat 40.83
#   RadiusRatio: regular 1, inside out 1, flat 33.34
#   AspectFrobenius: regular 1, inside out 1, flat 11.4
#   MinAngle: regular 70.53, inside out 70.53, flat 1.62
#   CollapseRatio: regular 0.8165, inside out -0.8165, flat 0.02
#   AspectGamma: regular 1, inside out 1, flat 38.5
#   Volume: regular 0.1179, inside out -0.1179, flat 0.01333
#   Condition: regular 1, inside out -1, flat 33.34
#   Jacobian: regular 0.7071, inside out -0.7071, flat 0.08
#   ScaledJacobian: regular 1, inside out -1, flat 0.02828
#   Shape: regular 1, inside out 0, flat 0.08771
#   RelativeSizeSquared: regular 1, inside out nan, flat 1
#   ShapeAndSize: regular 1, inside out nan, flat 0.08771
#   Distortion: regular 1, inside out 1, flat 1
set -euo pipefail
want=9.1.0+really9.1.0+dfsg2-5+deb12u1
version=$(dpkg-query -W -f='${Version}' python3-vtk9 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs python3-vtk9 $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > quality.py <<'PYTHON'
import math

import vtk


def quality(name, corners):
    points = vtk.vtkPoints()
    points.SetDataTypeToDouble()
    for corner in corners:
        points.InsertNextPoint(corner)
    grid = vtk.vtkUnstructuredGrid()
    grid.SetPoints(points)
    grid.InsertNextCell(vtk.VTK_TETRA, 4, [0, 1, 2, 3])
    measure = vtk.vtkMeshQuality()
    measure.SetInputData(grid)
    if name != "default":
        getattr(measure, "SetTetQualityMeasureTo" + name)()
    measure.Update()
    return measure.GetOutput().GetCellData().GetArray("Quality").GetValue(0)


root = math.sqrt(3)
regular = [(0, 0, 0), (1, 0, 0), (0.5, root / 2, 0), (0.5, root / 6, math.sqrt(2 / 3))]
inside_out = [regular[1], regular[0], regular[2], regular[3]]
flat = [(0, 1, -0.01), (1, 0, 0.01), (-1, 0, 0.01), (0, -1, -0.01)]
measures = """EdgeRatio AspectRatio RadiusRatio AspectFrobenius MinAngle CollapseRatio AspectGamma Volume Condition Jacobian
ScaledJacobian Shape RelativeSizeSquared ShapeAndSize Distortion""".split()
for name in ["default"] + measures:
    seen = [quality(name, corners) for corners in (regular, inside_out, flat)]
    print(f"{name}: regular {seen[0]:.4g}, inside out {seen[1]:.4g}, flat {seen[2]:.4g}".replace("-nan", "nan"))
PYTHON
/usr/bin/python3 quality.py > seen 2> messages || { cat messages; exit 1; }
cat seen
diff seen - <<'SEEN'
default: regular 1, inside out 1, flat 40.83
EdgeRatio: regular 1, inside out 1, flat 1.414
AspectRatio: regular 1, inside out 1, flat 40.83
RadiusRatio: regular 1, inside out 1, flat 33.34
AspectFrobenius: regular 1, inside out 1, flat 11.4
MinAngle: regular 70.53, inside out 70.53, flat 1.62
CollapseRatio: regular 0.8165, inside out -0.8165, flat 0.02
AspectGamma: regular 1, inside out 1, flat 38.5
Volume: regular 0.1179, inside out -0.1179, flat 0.01333
Condition: regular 1, inside out -1, flat 33.34
Jacobian: regular 0.7071, inside out -0.7071, flat 0.08
ScaledJacobian: regular 1, inside out -1, flat 0.02828
Shape: regular 1, inside out 0, flat 0.08771
RelativeSizeSquared: regular 1, inside out nan, flat 1
ShapeAndSize: regular 1, inside out nan, flat 0.08771
Distortion: regular 1, inside out 1, flat 1
SEEN
