#!/usr/bin/env bash
# VTK 9.1 (Debian 12: python3-vtk9 9.1.0+really9.1.0+dfsg2-5+deb12u1): grains of ever smaller size, icospheres of 642 points,
# cut in two by vtkClipClosedSurface with a plane through the centre, so that both halves are closed. Volumes as shares of the
# whole.
#
# Guess: 0.500 and 0.500 at every size.
# Seen: 0.485 and 0.485 at a radius of 1e-5, 0.464 and 0.464 at 1e-6 and below: what is within 1e-6 of the plane, in whatever
# units, counts as on it, so that triangles across it are not cut but left out, and the caps lie in front of the plane. Of a
# grain of a micrometre, in metres, 7% are lost, and both halves are closed. No warning is given. Set the tolerance to a millionth
# of the size.
#   radius 1: 0.500 and 0.500; with a tolerance of 1e-6 radii 0.500
#   radius 0.0001: 0.500 and 0.500; with a tolerance of 1e-6 radii 0.500
#   radius 1e-05: 0.485 and 0.485; with a tolerance of 1e-6 radii 0.500
#   radius 1e-06: 0.464 and 0.464; with a tolerance of 1e-6 radii 0.500
set -euo pipefail
want=9.1.0+really9.1.0+dfsg2-5+deb12u1
version=$(dpkg-query -W -f='${Version}' python3-vtk9 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs python3-vtk9 $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > halves.py <<'PYTHON'
import numpy
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy


def icosphere(radius):
    solid = vtk.vtkPlatonicSolidSource()
    solid.SetSolidTypeToIcosahedron()
    finer = vtk.vtkLinearSubdivisionFilter()
    finer.SetInputConnection(solid.GetOutputPort())
    finer.SetNumberOfSubdivisions(3)
    finer.Update()
    places = vtk_to_numpy(finer.GetOutput().GetPoints().GetData()).astype(float)
    points = vtk.vtkPoints()
    points.SetData(numpy_to_vtk(radius * places / numpy.linalg.norm(places, axis=1)[:, None], deep=True))
    surface = vtk.vtkPolyData()
    surface.SetPoints(points)
    surface.SetPolys(finer.GetOutput().GetPolys())
    return surface


def volume(surface):
    triangles = vtk.vtkTriangleFilter()
    triangles.SetInputData(surface)
    triangles.Update()
    surface = triangles.GetOutput()
    corners = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    a, b, c = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)[corners.T]
    return (a * numpy.cross(b, c)).sum() / 6


def half(surface, side, tolerance=None):
    plane = vtk.vtkPlane()
    plane.SetNormal(0.1 * side, 0.2 * side, side)
    planes = vtk.vtkPlaneCollection()
    planes.AddItem(plane)
    clip = vtk.vtkClipClosedSurface()
    clip.SetClippingPlanes(planes)
    clip.SetInputData(surface)
    if tolerance:
        clip.SetTolerance(tolerance)
    clip.Update()
    return volume(clip.GetOutput())


for radius in (1, 1e-4, 1e-5, 1e-6):
    surface = icosphere(radius)
    whole = volume(surface)
    parts = [half(surface, side) / whole for side in (1, -1)]
    given = half(surface, 1, 1e-6 * radius) / whole
    print(f"radius {radius}: {parts[0]:.3f} and {parts[1]:.3f}; with a tolerance of 1e-6 radii {given:.3f}")
PYTHON
/usr/bin/python3 halves.py > seen 2> messages || { cat messages; exit 1; }
cat seen
diff seen - <<'SEEN'
radius 1: 0.500 and 0.500; with a tolerance of 1e-6 radii 0.500
radius 0.0001: 0.500 and 0.500; with a tolerance of 1e-6 radii 0.500
radius 1e-05: 0.485 and 0.485; with a tolerance of 1e-6 radii 0.500
radius 1e-06: 0.464 and 0.464; with a tolerance of 1e-6 radii 0.500
SEEN
