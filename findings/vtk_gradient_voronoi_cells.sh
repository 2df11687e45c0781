#!/usr/bin/env bash
# VTK 9.1 (Debian 12: python3-vtk9 9.1.0+really9.1.0+dfsg2-5+deb12u1): the gradient of a field that is 2 x + 3 y - z at the
# corners, as of a displacement in a uniform strain, on cells as those of a Voronoi construction, polygons and polyhedra, and on
# the same cells as triangles, quadrilaterals, hexagonal prisms and hexahedra; by vtkGradientFilter at the corners (from the
# least to the largest), and by vtkCellDerivatives in the middle of the cell.
#
# Guess: (2, 3, 0) in the plane and (2, 3, -1) in space, exactly, as every cell holds a linear field.
# Seen: at the corners of polygons of five or more the gradient is next to 0, as such a polygon is interpolated by inverse
# distances, which are flat at each corner; in the middle it is a third off where one side is short, as in most Voronoi cells.
# At the corners of polyhedra it is several times as large as it should be, of either sign, and right in the middle. No warning.
# So a strain from the vertices of Voronoi cells is noise, or 0. Divide polygons into triangles (vtkTriangleFilter), and
# polyhedra into tetrahedra, first.
#   hexagon, polygon: corners (-0.23 to 0.23, -0.05 to 0.06, 0.00), cell (2.00, 3.00, 0.00)
#   hexagon, triangles: corners (2.00, 3.00, 0.00), cell (2.00, 3.00, 0.00)
#   pentagon, polygon: corners (-0.66 to 1.09, -0.40 to 0.76, 0.00), cell (1.33, 3.42, 0.00)
#   pentagon, triangles: corners (2.00, 3.00, 0.00), cell (2.00, 3.00, 0.00)
#   square, polygon: corners (2.00, 3.00, 0.00), cell (2.00, 3.00, 0.00)
#   square, quad: corners (2.00, 3.00, 0.00), cell (2.00, 3.00, 0.00)
#   prism, polyhedron: corners (-4.61 to 4.63, -6.75 to 4.03, -3.50 to 7.92), cell (2.00, 3.00, -1.00)
#   prism, hexagonal prism: corners (2.00, 3.00, -1.00), cell (2.00, 3.00, -1.00)
#   cube, polyhedron: corners (-7.80 to 3.91, -6.82 to 3.00, -4.89 to 4.88), cell (2.00, 3.00, -1.00)
#   cube, hexahedron: corners (2.00, 3.00, -1.00), cell (2.00, 3.00, -1.00)
set -euo pipefail
want=9.1.0+really9.1.0+dfsg2-5+deb12u1
version=$(dpkg-query -W -f='${Version}' python3-vtk9 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs python3-vtk9 $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > gradients.py <<'PYTHON'
import numpy
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy


def grid(places, cells):
    points = vtk.vtkPoints()
    points.SetData(numpy_to_vtk(numpy.array(places, dtype=float), deep=True))
    made = vtk.vtkUnstructuredGrid()
    made.SetPoints(points)
    for kind, corners in cells:
        if kind == vtk.VTK_POLYHEDRON:
            faces = vtk.vtkIdList()
            for number in [len(corners)] + [n for face in corners for n in [len(face), *face]]:
                faces.InsertNextId(number)
            made.InsertNextCell(kind, faces)
        else:
            made.InsertNextCell(kind, len(corners), corners)
    places = vtk_to_numpy(points.GetData())
    field = numpy_to_vtk(places @ [2, 3, -1], deep=True)
    field.SetName("field")
    made.GetPointData().SetScalars(field)
    return made


def show(name, cells):
    at_points = vtk.vtkGradientFilter()
    at_points.SetInputData(cells)
    at_points.SetInputScalars(0, "field")
    at_points.Update()
    points = vtk_to_numpy(at_points.GetOutput().GetPointData().GetArray("Gradients"))
    of_cells = vtk.vtkCellDerivatives()
    of_cells.SetInputData(cells)
    of_cells.Update()
    inside = vtk_to_numpy(of_cells.GetOutput().GetCellData().GetVectors())
    low, high, mean = points.min(axis=0) + 0.0, points.max(axis=0) + 0.0, inside.mean(axis=0)
    words = ", ".join(f"{a:.2f} to {b:.2f}" if b - a > 0.005 else f"{a + 0:.2f}" for a, b in zip(low, high))
    print(f"{name}: corners ({words}), cell ({', '.join(f'{round(x, 6) + 0:.2f}' for x in mean)})")


angles = numpy.arange(6) * numpy.pi / 3 + 0.1
ring = [(numpy.cos(a), numpy.sin(a), 0) for a in angles]
hexagon, square = range(6), range(4)
unit = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
top = [(x, y, 1) for x, y, _ in ring]
unit_top = [(x, y, 1) for x, y, _ in unit]
sides = [[n, (n + 1) % 6, (n + 1) % 6 + 6, n + 6] for n in range(6)]
unit_sides = [[n, (n + 1) % 4, (n + 1) % 4 + 4, n + 4] for n in range(4)]
show("hexagon, polygon", grid(ring, [(vtk.VTK_POLYGON, list(hexagon))]))
show("hexagon, triangles", grid(ring, [(vtk.VTK_TRIANGLE, [0, n, n + 1]) for n in range(1, 5)]))
uneven = [(0, 0, 0), (1.2, -0.2, 0), (1.25, -0.15, 0), (0.7, 1.3, 0), (-0.2, 0.8, 0)]
show("pentagon, polygon", grid(uneven, [(vtk.VTK_POLYGON, list(range(5)))]))
show("pentagon, triangles", grid(uneven, [(vtk.VTK_TRIANGLE, [0, n, n + 1]) for n in range(1, 4)]))
show("square, polygon", grid(unit, [(vtk.VTK_POLYGON, list(square))]))
show("square, quad", grid(unit, [(vtk.VTK_QUAD, list(square))]))
prism = [list(hexagon)[::-1], [n + 6 for n in hexagon], *sides]
cube = [list(square)[::-1], [n + 4 for n in square], *unit_sides]
show("prism, polyhedron", grid(ring + top, [(vtk.VTK_POLYHEDRON, prism)]))
show("prism, hexagonal prism", grid(ring + top, [(vtk.VTK_HEXAGONAL_PRISM, list(range(12)))]))
show("cube, polyhedron", grid(unit + unit_top, [(vtk.VTK_POLYHEDRON, cube)]))
show("cube, hexahedron", grid(unit + unit_top, [(vtk.VTK_HEXAHEDRON, list(range(8)))]))
PYTHON
/usr/bin/python3 gradients.py > seen 2> messages || { cat messages; exit 1; }
cat seen
diff seen - <<'SEEN'
hexagon, polygon: corners (-0.23 to 0.23, -0.05 to 0.06, 0.00), cell (2.00, 3.00, 0.00)
hexagon, triangles: corners (2.00, 3.00, 0.00), cell (2.00, 3.00, 0.00)
pentagon, polygon: corners (-0.66 to 1.09, -0.40 to 0.76, 0.00), cell (1.33, 3.42, 0.00)
pentagon, triangles: corners (2.00, 3.00, 0.00), cell (2.00, 3.00, 0.00)
square, polygon: corners (2.00, 3.00, 0.00), cell (2.00, 3.00, 0.00)
square, quad: corners (2.00, 3.00, 0.00), cell (2.00, 3.00, 0.00)
prism, polyhedron: corners (-4.61 to 4.63, -6.75 to 4.03, -3.50 to 7.92), cell (2.00, 3.00, -1.00)
prism, hexagonal prism: corners (2.00, 3.00, -1.00), cell (2.00, 3.00, -1.00)
cube, polyhedron: corners (-7.80 to 3.91, -6.82 to 3.00, -4.89 to 4.88), cell (2.00, 3.00, -1.00)
cube, hexahedron: corners (2.00, 3.00, -1.00), cell (2.00, 3.00, -1.00)
SEEN
