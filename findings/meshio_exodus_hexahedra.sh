#!/usr/bin/env bash
# meshio 7.0.0 (Debian 12: python3-meshio 7.0.0-3) writing a finite element of second order, a cube of 20 nodes, with a
# pressure, to an Exodus file, which VTK 9.1 (python3-vtk9 9.1.0+really9.1.0+dfsg2-5+deb12u1) reads; .vtu and .vtk beside it.
#
# Guess: a cube of volume 1, each node in the middle of an edge in its place, and the pressure.
# Seen: VTK has a volume of 0.083 from the Exodus file, and eight nodes on the wrong edges. Exodus counts the upright edges
# before those of the top, meshio writes the order of VTK, in which they come last, so that who reads the format as it is
# meant to be read turns four upright edges into those of the top. meshio itself reads the file as it wrote it, which hides
# the fault. The pressure is not in the file, as data of cells are not written. No warning of either. With tetrahedra all is
# right but the pressure.
#   .e: volume 0.0833, 8 nodes on wrong edges, arrays: none
#   .vtu: volume 1.0000, 0 nodes on wrong edges, arrays: pressure
#   .vtk: volume 1.0000, 0 nodes on wrong edges, arrays: pressure
set -euo pipefail
for pair in python3-meshio=7.0.0-3 python3-vtk9=9.1.0+really9.1.0+dfsg2-5+deb12u1; do
  version=$(dpkg-query -W -f='${Version}' "${pair%%=*}" 2>/dev/null || true)
  [ "$version" = "${pair#*=}" ] || { echo "needs ${pair%%=*} ${pair#*=}, found '${version:-none}'"; exit 77; }
done
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > cube.py <<'PYTHON'
import meshio
import numpy
import vtk

edges = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)]
corners = numpy.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]], float)
points = numpy.vstack([corners, [(corners[a] + corners[b]) / 2 for a, b in edges]])
mesh = meshio.Mesh(points, [("hexahedron20", numpy.arange(20)[None])], cell_data={"pressure": [numpy.array([7.0])]})
readers = {".e": vtk.vtkExodusIIReader, ".vtu": vtk.vtkXMLUnstructuredGridReader, ".vtk": vtk.vtkUnstructuredGridReader}
for ending in (".e", ".vtu", ".vtk"):
    meshio.write("cube" + ending, mesh)
    reader = readers[ending]()
    reader.SetFileName("cube" + ending)
    if ending == ".e":
        reader.UpdateInformation()
        for n in range(reader.GetNumberOfElementResultArrays()):
            reader.SetElementResultArrayStatus(reader.GetElementResultArrayName(n), 1)
    reader.Update()
    grid = reader.GetOutput()
    if ending == ".e":
        grid = grid.GetBlock(0).GetBlock(0)
    cell = grid.GetCell(0)
    nodes = numpy.array([grid.GetPoint(cell.GetPointId(n)) for n in range(20)])
    wrong = sum(abs(nodes[8 + n] - (nodes[a] + nodes[b]) / 2).max() > 1e-9 for n, (a, b) in enumerate(edges))
    sizes = vtk.vtkCellSizeFilter()
    sizes.SetInputData(grid)
    sizes.Update()
    data = grid.GetCellData()
    names = [data.GetArrayName(n) for n in range(data.GetNumberOfArrays()) if data.GetArrayName(n) == "pressure"]
    volume = sizes.GetOutput().GetCellData().GetArray("Volume").GetValue(0)
    print(f"SEEN {ending}: volume {volume:.4f}, {wrong} nodes on wrong edges, arrays: {' '.join(names) or 'none'}")
PYTHON
/usr/bin/python3 cube.py > messages 2>&1 || { cat messages; exit 1; }
sed -n 's/^SEEN //p' messages > seen
cat seen
diff seen - <<'SEEN'
.e: volume 0.0833, 8 nodes on wrong edges, arrays: none
.vtu: volume 1.0000, 0 nodes on wrong edges, arrays: pressure
.vtk: volume 1.0000, 0 nodes on wrong edges, arrays: pressure
SEEN
