#!/usr/bin/env bash
# VTK 9.1 (Debian 12: python3-vtk9 9.1.0+really9.1.0+dfsg2-5+deb12u1): vtkPlatonicSolidSource, where geodesic spheres begin.
#
# Guess: the faces of all five solids look outwards, as those of vtkSphereSource and vtkCubeSource do.
# Seen: tetrahedron and icosahedron are inside out, cube, octahedron and dodecahedron are not. A sphere made from the icosahedron
# has a negative volume by its corners, the signed distance to its surface is positive inside and negative outside, so that a gap
# is an overlap, and vtkPolyDataNormals has normals that look inwards. vtkMassProperties shows nothing: its volume is positive for
# either. Turn the surface by vtkReverseSense, or switch AutoOrientNormals on.
#   Tetrahedron: volume -0.513, vtkMassProperties 0.513, normals look inwards, distance at centre 0.33, at x = 3 -2.42
#   Cube: volume 1.540, vtkMassProperties 1.540, normals look outwards, distance at centre -0.58, at x = 3 2.42
#   Octahedron: volume 1.333, vtkMassProperties 1.333, normals look outwards, distance at centre -0.58, at x = 3 2.29
#   Dodecahedron: volume 2.785, vtkMassProperties 2.785, normals look outwards, distance at centre -0.79, at x = 3 2.07
#   Icosahedron: volume -2.536, vtkMassProperties 2.536, normals look inwards, distance at centre 0.79, at x = 3 -2.15
#   refined 3 times: volume -3.847, vtkMassProperties 3.847, normals look inwards, distance at centre 0.96, at x = 3 -2.03
#   vtkSphereSource: volume 3.585, vtkMassProperties 3.585, normals look outwards, distance at centre -0.90, at x = 3 2.03
set -euo pipefail
want=9.1.0+really9.1.0+dfsg2-5+deb12u1
version=$(dpkg-query -W -f='${Version}' python3-vtk9 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs python3-vtk9 $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > solids.py <<'PYTHON'
import numpy
import vtk
from vtk.util.numpy_support import vtk_to_numpy


def show(name, source):
    triangles = vtk.vtkTriangleFilter()
    triangles.SetInputConnection(source.GetOutputPort())
    normals = vtk.vtkPolyDataNormals()
    normals.SetInputConnection(triangles.GetOutputPort())
    normals.SplittingOff()
    normals.Update()
    surface = normals.GetOutput()
    places = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    a, b, c = (places[corner] for corner in vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3).T)
    volume = numpy.einsum("ij,ij->", a, numpy.cross(b, c)) / 6
    outwards = (vtk_to_numpy(surface.GetPointData().GetNormals()) * places).sum(axis=1)
    masses = vtk.vtkMassProperties()
    masses.SetInputConnection(triangles.GetOutputPort())
    distance = vtk.vtkImplicitPolyDataDistance()
    distance.SetInput(surface)
    gaps = [distance.EvaluateFunction(x, 0.0, 0.0) for x in (0.0, 3.0)]
    print(f"{name}: volume {volume:.3f}, vtkMassProperties {masses.GetVolume():.3f}, normals look "
          f"{'outwards' if outwards.min() > 0 else 'inwards' if outwards.max() < 0 else 'both ways'}, "
          f"distance at centre {gaps[0]:.2f}, at x = 3 {gaps[1]:.2f}")


for kind in ("Tetrahedron", "Cube", "Octahedron", "Dodecahedron", "Icosahedron"):
    solid = vtk.vtkPlatonicSolidSource()
    getattr(solid, f"SetSolidTypeTo{kind}")()
    show(kind, solid)
finer = vtk.vtkButterflySubdivisionFilter()
finer.SetInputConnection(solid.GetOutputPort())
finer.SetNumberOfSubdivisions(3)
show("refined 3 times", finer)
sphere = vtk.vtkSphereSource()
sphere.SetRadius(1)
show("vtkSphereSource", sphere)
PYTHON
/usr/bin/python3 solids.py > seen 2> messages || { cat messages; exit 1; }
cat seen
diff seen - <<'SEEN'
Tetrahedron: volume -0.513, vtkMassProperties 0.513, normals look inwards, distance at centre 0.33, at x = 3 -2.42
Cube: volume 1.540, vtkMassProperties 1.540, normals look outwards, distance at centre -0.58, at x = 3 2.42
Octahedron: volume 1.333, vtkMassProperties 1.333, normals look outwards, distance at centre -0.58, at x = 3 2.29
Dodecahedron: volume 2.785, vtkMassProperties 2.785, normals look outwards, distance at centre -0.79, at x = 3 2.07
Icosahedron: volume -2.536, vtkMassProperties 2.536, normals look inwards, distance at centre 0.79, at x = 3 -2.15
refined 3 times: volume -3.847, vtkMassProperties 3.847, normals look inwards, distance at centre 0.96, at x = 3 -2.03
vtkSphereSource: volume 3.585, vtkMassProperties 3.585, normals look outwards, distance at centre -0.90, at x = 3 2.03
SEEN
