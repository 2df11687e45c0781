#!/usr/bin/env bash
# VTK 9.1 (Debian 12: python3-vtk9 9.1.0+really9.1.0+dfsg2-5+deb12u1): normals of vtkParametricFunctionSource, for drops as
# ellipsoids and for a torus, and the surface moved outwards by 0.1 along them (vtkWarpVector), as a drop grows or a membrane is
# pressed. vtkSphereSource and vtkPolyDataNormals beside it.
#
# Guess: they have length 1, as all normals in VTK do; a sphere of radius 1 becomes one of radius 1.1.
# Seen: the direction is right, but the length is the area that belongs to the parameters: 0 at the poles, 1 at the equator of a
# sphere, up to 2 for an ellipsoid and 0.75 for a torus. The grown sphere is no sphere, and a pressure along them is not uniform.
# Put vtkPolyDataNormals behind the source: it makes its own.
#   ellipsoid (1, 1, 1): lengths 0.00 to 1.00, moved by 0.000 to 0.100
#   ellipsoid (2, 1, 1): lengths 0.00 to 2.00, moved by 0.000 to 0.200
#   the same, vtkPolyDataNormals: lengths 1.00 to 1.00, moved by 0.100 to 0.100
#   torus: lengths 0.25 to 0.75, moved by 0.025 to 0.075
#   vtkSphereSource: lengths 1.00 to 1.00, moved by 0.100 to 0.100
set -euo pipefail
want=9.1.0+really9.1.0+dfsg2-5+deb12u1
version=$(dpkg-query -W -f='${Version}' python3-vtk9 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs python3-vtk9 $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > normals.py <<'PYTHON'
import numpy
import vtk
from vtk.util.numpy_support import vtk_to_numpy


def show(name, surface):
    surface.Update()
    lengths = numpy.linalg.norm(vtk_to_numpy(surface.GetOutput().GetPointData().GetNormals()).astype(float), axis=1)
    warp = vtk.vtkWarpVector()
    warp.SetInputConnection(surface.GetOutputPort())
    warp.SetInputArrayToProcess(0, 0, 0, vtk.vtkDataObject.FIELD_ASSOCIATION_POINTS, "Normals")
    warp.SetScaleFactor(0.1)
    warp.Update()
    before, after = (vtk_to_numpy(mesh.GetPoints().GetData()).astype(float) for mesh in (surface.GetOutput(), warp.GetOutput()))
    moved = numpy.linalg.norm(after - before, axis=1)
    print(f"{name}: lengths {lengths.min():.2f} to {lengths.max():.2f}, moved by {moved.min():.3f} to {moved.max():.3f}")


def source(function):
    surface = vtk.vtkParametricFunctionSource()
    surface.SetParametricFunction(function)
    surface.SetUResolution(64)
    surface.SetVResolution(64)
    return surface


for radii in ((1, 1, 1), (2, 1, 1)):
    drop = vtk.vtkParametricEllipsoid()
    for axis, radius in zip("XYZ", radii):
        getattr(drop, f"Set{axis}Radius")(radius)
    show(f"ellipsoid {radii}", source(drop))
surface = source(drop)
own = vtk.vtkPolyDataNormals()
own.SetInputConnection(surface.GetOutputPort())
own.SplittingOff()
show("the same, vtkPolyDataNormals", own)
show("torus", source(vtk.vtkParametricTorus()))
sphere = vtk.vtkSphereSource()
sphere.SetRadius(1)
show("vtkSphereSource", sphere)
PYTHON
/usr/bin/python3 normals.py > seen 2> messages || { cat messages; exit 1; }
cat seen
diff seen - <<'SEEN'
ellipsoid (1, 1, 1): lengths 0.00 to 1.00, moved by 0.000 to 0.100
ellipsoid (2, 1, 1): lengths 0.00 to 2.00, moved by 0.000 to 0.200
the same, vtkPolyDataNormals: lengths 1.00 to 1.00, moved by 0.100 to 0.100
torus: lengths 0.25 to 0.75, moved by 0.025 to 0.075
vtkSphereSource: lengths 1.00 to 1.00, moved by 0.100 to 0.100
SEEN
