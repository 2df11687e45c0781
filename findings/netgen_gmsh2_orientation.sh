#!/usr/bin/env bash
# Netgen 6.2 (Debian 12: python3-netgen 6.2.2006+really6.2.1905+dfsg-5.1+b1): tetrahedra of a ball of radius 1 in two of its formats, read
# by meshio 7.0.0 (python3-meshio 7.0.0-3), with their volumes by VTK 9.1 (python3-vtk9 9.1.0+really9.1.0+dfsg2-5+deb12u1).
#
# Guess: positive volumes that add up to that of the mesh, 3.83, from each.
# Seen: Netgen counts the corners of a tetrahedron the other way round than most; its export for Abaqus turns them, that for gmsh
# (version 2 of the format) does not. All volumes are negative there, also the determinants of gmsh itself, so that an integral over
# the mesh, a mass or a stiffness has the wrong sign. No error or warning from any of them. Exchange two corners.
#   Abaqus Format: 191 volumes above zero, 0 below, sum 3.83
#   Gmsh2 Format: 0 volumes above zero, 191 below, sum -3.83
set -euo pipefail
for pair in python3-netgen=6.2.2006+really6.2.1905+dfsg-5.1+b1 python3-meshio=7.0.0-3 \
  python3-vtk9=9.1.0+really9.1.0+dfsg2-5+deb12u1; do
  version=$(dpkg-query -W -f='${Version}' "${pair%%=*}" 2>/dev/null || true)
  [ "$version" = "${pair#*=}" ] || { echo "needs ${pair%%=*} ${pair#*=}, found '${version:-none}'"; exit 77; }
done
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > ball.py <<'PYTHON'
import meshio
import netgen.csg
import vtk
from vtk.util.numpy_support import vtk_to_numpy

geometry = netgen.csg.CSGeometry()
geometry.Add(netgen.csg.Sphere(netgen.csg.Pnt(0, 0, 0), 1))
mesh = geometry.GenerateMesh(maxh=0.5)
for name, file in (("Abaqus Format", "ball.inp"), ("Gmsh2 Format", "ball.msh")):
    mesh.Export(file, name)
    read = meshio.read(file)
    meshio.write("ball.vtu", meshio.Mesh(read.points, [("tetra", read.cells_dict["tetra"])]))
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName("ball.vtu")
    sizes = vtk.vtkCellSizeFilter()
    sizes.SetInputConnection(reader.GetOutputPort())
    sizes.Update()
    volumes = vtk_to_numpy(sizes.GetOutput().GetCellData().GetArray("Volume"))
    print(f"SEEN {name}: {(volumes > 0).sum()} volumes above zero, {(volumes < 0).sum()} below, sum {volumes.sum():.2f}")
PYTHON
/usr/bin/python3 ball.py > messages 2>&1 || { cat messages; exit 1; }
sed -n 's/^SEEN //p' messages > seen
cat seen
diff seen - <<'SEEN'
Abaqus Format: 191 volumes above zero, 0 below, sum 3.83
Gmsh2 Format: 0 volumes above zero, 191 below, sum -3.83
SEEN
