#!/usr/bin/env bash
# VTK 9.1 (Debian 12: python3-vtk9 9.1.0+really9.1.0+dfsg2-5+deb12u1): area of a plane polygon that is not convex, such as the
# outline of a soft particle with a dent.
#
# Guess: vtkCellSizeFilter and vtkIntegrateAttributes ("Cell Size" and "Integrate Variables" of ParaView) give its area.
# Seen: both add up the areas of a fan of triangles from the first vertex, without signs. The L of area 3 has area 4 if its
# list of vertices begins at another corner; a star of five points, which winds once, has more than twice its area. The
# centroid of vtkIntegrateAttributes is off by the same. vtkCellCenters is the mean of the vertices. vtkTriangleFilter before
# either, or vtkPolygon's ComputeArea and ComputeCentroid, are right.
#   L from its inner corner's opposite: size 3.0000 integral 3.0000 triangles 3.0000 ComputeArea 3.0000 true 3.0000
#   L from the next corner:             size 4.0000 integral 4.0000 triangles 3.0000 ComputeArea 3.0000 true 3.0000
#   star:                               size 5.0574 integral 5.0574 triangles 2.2042 ComputeArea 2.2042 true 2.2042
set -euo pipefail
want=9.1.0+really9.1.0+dfsg2-5+deb12u1
version=$(dpkg-query -W -f='${Version}' python3-vtk9 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs python3-vtk9 $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
/usr/bin/python3 - > seen <<'PYTHON'
import math
import vtk

L = [(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)]
star = [((1.5, 0.5)[k % 2] * math.cos(k * math.pi / 5), (1.5, 0.5)[k % 2] * math.sin(k * math.pi / 5)) for k in range(10)]
for name, corners in (("L from its inner corner's opposite:", L), ("L from the next corner:", L[1:] + L[:1]), ("star:", star)):
    points, polys, mesh = vtk.vtkPoints(), vtk.vtkCellArray(), vtk.vtkPolyData()
    polys.InsertNextCell(len(corners))
    for x, y in corners:
        polys.InsertCellPoint(points.InsertNextPoint(x, y, 0))
    mesh.SetPoints(points)
    mesh.SetPolys(polys)

    def through(algorithm):
        algorithm.SetInputData(mesh)
        algorithm.Update()
        return algorithm.GetOutput()

    size = through(vtk.vtkCellSizeFilter()).GetCellData().GetArray("Area").GetValue(0)
    integral = through(vtk.vtkIntegrateAttributes()).GetCellData().GetArray("Area").GetValue(0)
    cells = through(vtk.vtkTriangleFilter())
    triangles = sum(cells.GetCell(i).ComputeArea() for i in range(cells.GetNumberOfCells()))
    true = sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(corners, corners[1:] + corners[:1])) / 2
    print(f"{name:35} size {size:.4f} integral {integral:.4f} triangles {triangles:.4f} "
          f"ComputeArea {mesh.GetCell(0).ComputeArea():.4f} true {true:.4f}")
PYTHON
cat seen
diff seen - <<'SEEN'
L from its inner corner's opposite: size 3.0000 integral 3.0000 triangles 3.0000 ComputeArea 3.0000 true 3.0000
L from the next corner:             size 4.0000 integral 4.0000 triangles 3.0000 ComputeArea 3.0000 true 3.0000
star:                               size 5.0574 integral 5.0574 triangles 2.2042 ComputeArea 2.2042 true 2.2042
SEEN
