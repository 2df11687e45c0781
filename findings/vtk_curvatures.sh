#!/usr/bin/env bash
# VTK 9.1 (Debian 12: python3-vtk9 9.1.0+really9.1.0+dfsg2-5+deb12u1): mean and Gaussian curvature by vtkCurvatures, as for the Laplace
# pressure of a drop or the bending of a membrane: triangulated spheres and an open tube, all of radius 1, ever finer.
#
# Guess: 1 and 1 at every point of the sphere, 0.5 and 0 at every point of the tube, the closer the finer the mesh.
# Seen: both stay 15% too large at the twelve points of an icosphere that have five triangles, and 25% too small at the poles of
# vtkSphereSource, at any resolution, as a point has a third of the area of its triangles, which is right for regular meshes
# alone. At the rim of the tube the mean curvature is 1.5 times too large, and the Gaussian one is the angle that is missing
# to a full turn over that area, which grows with the fineness. "Maximum" and "Minimum" are computed from these.
#   icosphere, refined 3 times: Mean 1.002 to 1.146, Gaussian 1.002 to 1.147
#   icosphere, refined 5 times: Mean 1.000 to 1.146, Gaussian 1.000 to 1.146
#   vtkSphereSource, resolution 32: Mean 0.758 to 1.061, Gaussian 0.759 to 1.011
#   vtkSphereSource, resolution 256: Mean 0.750 to 1.050, Gaussian 0.750 to 1.001
#   tube of 16 rings: Mean 0.501 to 0.751, Gaussian 0.000 to 163.237
#   tube of 64 rings: Mean 0.500 to 0.750, Gaussian 0.000 to 2607.857
set -euo pipefail
want=9.1.0+really9.1.0+dfsg2-5+deb12u1
version=$(dpkg-query -W -f='${Version}' python3-vtk9 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs python3-vtk9 $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > curvatures.py <<'PYTHON'
import numpy
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy


def show(name, surface):
    answers = []
    for kind in ("Mean", "Gaussian"):
        curvatures = vtk.vtkCurvatures()
        curvatures.SetInputData(surface)
        getattr(curvatures, f"SetCurvatureTypeTo{kind}")()
        curvatures.Update()
        values = vtk_to_numpy(curvatures.GetOutput().GetPointData().GetScalars())
        if kind == "Mean":
            values = abs(values)  # the sign is that of the order of corners
        answers.append(f"{kind} {values.min():.3f} to {values.max():.3f}")
    print(f"{name}: {', '.join(answers)}")


def icosphere(refinements):
    solid = vtk.vtkPlatonicSolidSource()
    solid.SetSolidTypeToIcosahedron()
    finer = vtk.vtkLinearSubdivisionFilter()
    finer.SetInputConnection(solid.GetOutputPort())
    finer.SetNumberOfSubdivisions(refinements)
    finer.Update()
    surface = vtk.vtkPolyData()
    places = vtk_to_numpy(finer.GetOutput().GetPoints().GetData()).astype(float)
    points = vtk.vtkPoints()
    points.SetData(numpy_to_vtk(places / numpy.linalg.norm(places, axis=1)[:, None], deep=True))
    surface.SetPoints(points)
    surface.SetPolys(finer.GetOutput().GetPolys())
    return surface


def sphere(resolution):
    source = vtk.vtkSphereSource()
    source.SetRadius(1)
    source.SetThetaResolution(resolution)
    source.SetPhiResolution(resolution)
    source.Update()
    return source.GetOutput()


def tube(rings):
    around = 2 * rings
    points, triangles = vtk.vtkPoints(), vtk.vtkCellArray()
    for ring in range(rings + 1):
        for n in range(around):
            angle = 2 * numpy.pi * n / around
            points.InsertNextPoint(numpy.cos(angle), numpy.sin(angle), ring * numpy.pi / rings)
    for ring in range(rings):
        for n in range(around):
            a, b = ring * around + n, ring * around + (n + 1) % around
            for corners in ((a, b, b + around), (a, b + around, a + around)):
                triangles.InsertNextCell(3, corners)
    surface = vtk.vtkPolyData()
    surface.SetPoints(points)
    surface.SetPolys(triangles)
    return surface


for refinements in (3, 5):
    show(f"icosphere, refined {refinements} times", icosphere(refinements))
for resolution in (32, 256):
    show(f"vtkSphereSource, resolution {resolution}", sphere(resolution))
for rings in (16, 64):
    show(f"tube of {rings} rings", tube(rings))
PYTHON
/usr/bin/python3 curvatures.py > seen 2> messages || { cat messages; exit 1; }
cat seen
diff seen - <<'SEEN'
icosphere, refined 3 times: Mean 1.002 to 1.146, Gaussian 1.002 to 1.147
icosphere, refined 5 times: Mean 1.000 to 1.146, Gaussian 1.000 to 1.146
vtkSphereSource, resolution 32: Mean 0.758 to 1.061, Gaussian 0.759 to 1.011
vtkSphereSource, resolution 256: Mean 0.750 to 1.050, Gaussian 0.750 to 1.001
tube of 16 rings: Mean 0.501 to 0.751, Gaussian 0.000 to 163.237
tube of 64 rings: Mean 0.500 to 0.750, Gaussian 0.000 to 2607.857
SEEN
