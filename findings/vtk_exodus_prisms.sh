#!/usr/bin/env bash
# VTK 9.1 (Debian 12: python3-vtk9 9.1.0+really9.1.0+dfsg2-5+deb12u1) reading an Exodus file of finite elements, a prism of volume 1/2 and
# a tetrahedron of volume 1/6 on top of it, written by meshio 7.0.0 (python3-meshio 7.0.0-3); the same mesh as .vtu beside it.
#
# Guess: both have positive volumes, which vtkCellSizeFilter and vtkIntegrateAttributes add up to 2/3.
# Seen: the prism of the Exodus file has the volume -1/2. Its reader turns prisms round to the order that VTK documents, the first
# triangle facing outward, and the filters count by the other order, that of .vtu files of meshio and gmsh. Where prisms and
# tetrahedra meet the sum is their difference, here -1/3, and means weighted by volume have the wrong sign for prisms.
#   Exodus: prism and tetrahedron -0.500, 0.167, integral -0.333
#   .vtu: prism and tetrahedron 0.500, 0.167, integral 0.667
set -euo pipefail
for pair in python3-vtk9=9.1.0+really9.1.0+dfsg2-5+deb12u1 python3-meshio=7.0.0-3; do
  version=$(dpkg-query -W -f='${Version}' "${pair%%=*}" 2>/dev/null || true)
  [ "$version" = "${pair#*=}" ] || { echo "needs ${pair%%=*} ${pair#*=}, found '${version:-none}'"; exit 77; }
done
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > volumes.py <<'PYTHON'
import meshio
import vtk
from vtk.util.numpy_support import vtk_to_numpy

corners = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (0, 1, 1), (0, 0, 2)]
for name in ("mesh.e", "mesh.vtu"):
    meshio.write(name, meshio.Mesh([[float(x) for x in corner] for corner in corners],
                                   [("wedge", [[0, 1, 2, 3, 4, 5]]), ("tetra", [[3, 4, 5, 6]])]))


def volumes(mesh):
    sizes = vtk.vtkCellSizeFilter()
    sizes.SetInputData(mesh)
    sizes.Update()
    return [float(volume) for volume in vtk_to_numpy(sizes.GetOutput().GetCellData().GetArray("Volume"))]


def integral(mesh):
    whole = vtk.vtkIntegrateAttributes()
    whole.SetInputData(mesh)
    whole.Update()
    return float(vtk_to_numpy(whole.GetOutput().GetCellData().GetArray("Volume"))[0])


def show(name, meshes):
    print(f"{name}: prism and tetrahedron {', '.join(f'{volume:.3f}' for mesh in meshes for volume in volumes(mesh))}, "
          f"integral {sum(map(integral, meshes)):.3f}")


exodus = vtk.vtkExodusIIReader()
exodus.SetFileName("mesh.e")
exodus.UpdateInformation()
exodus.Update()
blocks = exodus.GetOutput().GetBlock(0)
show("Exodus", [blocks.GetBlock(n) for n in range(blocks.GetNumberOfBlocks())])
vtu = vtk.vtkXMLUnstructuredGridReader()
vtu.SetFileName("mesh.vtu")
vtu.Update()
show(".vtu", [vtu.GetOutput()])
PYTHON
/usr/bin/python3 volumes.py > seen 2> messages || { cat messages; exit 1; }
cat seen
diff seen - <<'SEEN'
Exodus: prism and tetrahedron -0.500, 0.167, integral -0.333
.vtu: prism and tetrahedron 0.500, 0.167, integral 0.667
SEEN
