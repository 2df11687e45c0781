#!/usr/bin/env bash
# VTK 9.1 (Debian 12: python3-vtk9 9.1.0+really9.1.0+dfsg2-5+deb12u1) reading ASCII files that VTK itself wrote, with a nan or
# an infinity in one array, as a ratio of a particle without contacts has it.
#
# Guess: VTK reads what VTK wrote.
# Seen: with an infinity the .vtp reader gives a mesh of no points and no cells at all; with a nan all is read. The .vtk
# reader, whose files are ASCII by default, gives the mesh and none of the arrays, for a nan as well. GetErrorCode() is 0
# throughout; a line on stderr is all. Binary files of both kinds are read. Write binary, or no such values.
#   vtp nan: 4 points, 1 cells, value [1.0, nan, 2.0, 3.0], other [1.0, 2.0, 3.0, 4.0], error code 0
#   vtp inf: 0 points, 0 cells, value None, other None, error code 0
#   vtk nan: 4 points, 1 cells, value None, other None, error code 0
#   vtk inf: 4 points, 1 cells, value None, other None, error code 0
#   vtp inf, binary: 4 points, 1 cells, value [1.0, inf, 2.0, 3.0], other [1.0, 2.0, 3.0, 4.0], error code 0
#   vtk inf, binary: 4 points, 1 cells, value [1.0, inf, 2.0, 3.0], other [1.0, 2.0, 3.0, 4.0], error code 0
set -euo pipefail
want=9.1.0+really9.1.0+dfsg2-5+deb12u1
version=$(dpkg-query -W -f='${Version}' python3-vtk9 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs python3-vtk9 $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
/usr/bin/python3 - > seen 2>/dev/null <<'PYTHON'
import vtk


def square(odd):
    points, polys, mesh = vtk.vtkPoints(), vtk.vtkCellArray(), vtk.vtkPolyData()
    polys.InsertNextCell(4)
    for x, y in [(0, 0), (1, 0), (1, 1), (0, 1)]:
        polys.InsertCellPoint(points.InsertNextPoint(x, y, 0))
    mesh.SetPoints(points)
    mesh.SetPolys(polys)
    for name, values in (("value", [1, odd, 2, 3]), ("other", [1, 2, 3, 4])):
        array = vtk.vtkDoubleArray()
        array.SetName(name)
        for value in values:
            array.InsertNextValue(value)
        mesh.GetPointData().AddArray(array)
    return mesh


def there_and_back(kind, odd, binary):
    writer = vtk.vtkXMLPolyDataWriter() if kind == "vtp" else vtk.vtkPolyDataWriter()
    reader = vtk.vtkXMLPolyDataReader() if kind == "vtp" else vtk.vtkPolyDataReader()
    if kind == "vtp":
        writer.SetDataModeToBinary() if binary else writer.SetDataModeToAscii()
    elif binary:
        writer.SetFileTypeToBinary()
    writer.SetInputData(square(float(odd)))
    writer.SetFileName("square." + kind)
    assert writer.Write() == 1
    reader.SetFileName("square." + kind)
    reader.Update()
    mesh = reader.GetOutput()
    arrays = [mesh.GetPointData().GetArray(name) for name in ("value", "other")]
    value, other = [a and [a.GetValue(i) for i in range(4)] for a in arrays]
    print(f"{kind} {odd}{', binary' * binary}: {mesh.GetNumberOfPoints()} points, {mesh.GetNumberOfCells()} cells, "
          f"value {value}, other {other}, error code {reader.GetErrorCode()}")


for kind in ("vtp", "vtk"):
    for odd in ("nan", "inf"):
        there_and_back(kind, odd, False)
for kind in ("vtp", "vtk"):
    there_and_back(kind, "inf", True)
PYTHON
cat seen
diff seen - <<'SEEN'
vtp nan: 4 points, 1 cells, value [1.0, nan, 2.0, 3.0], other [1.0, 2.0, 3.0, 4.0], error code 0
vtp inf: 0 points, 0 cells, value None, other None, error code 0
vtk nan: 4 points, 1 cells, value None, other None, error code 0
vtk inf: 4 points, 1 cells, value None, other None, error code 0
vtp inf, binary: 4 points, 1 cells, value [1.0, inf, 2.0, 3.0], other [1.0, 2.0, 3.0, 4.0], error code 0
vtk inf, binary: 4 points, 1 cells, value [1.0, inf, 2.0, 3.0], other [1.0, 2.0, 3.0, 4.0], error code 0
SEEN
