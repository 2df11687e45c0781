#!/usr/bin/env bash
# VTK 9.1 (Debian 12: python3-vtk9 9.1.0+really9.1.0+dfsg2-5+deb12u1): a ball of radius 1 in tetrahedra of second order by gmsh
# 4.8.4 (python3-gmsh 4.8.4+ds2-3), whose elements know their curved sides: the volume of the mesh from the determinants of gmsh,
# from vtkCellSizeFilter and vtkIntegrateAttributes, and of the surface by vtkDataSetSurfaceFilter at two levels of subdivision;
# and the integral of x^2, which such an element holds exactly, over one with straight sides, corners at 0 and 1 along each axis.
#
# Guess: the volume of the mesh (4.15 for 4.19 with 50 elements), as both filters take such cells; an integral of 1/60.
# Seen: both filters take each element for eight with flat sides and linear fields. Of the 50 elements 3.91 is left, an error of
# 6.7% for one of 0.9%, and the gain of the second order is gone at each fineness. The integral of x^2 is 41% too large even
# where all sides are straight. A surface at level 0 has the volume of the ball of first order. No warning. Integrate by Gauss
# points.
#   50 elements: gmsh 4.151, vtkCellSizeFilter 3.907, vtkIntegrateAttributes 3.907, surface 3.214, subdivided once 3.907
#   261 elements: gmsh 4.186, vtkCellSizeFilter 4.111, vtkIntegrateAttributes 4.111, surface 3.889, subdivided once 4.111
#   1435 elements: gmsh 4.189, vtkCellSizeFilter 4.167, vtkIntegrateAttributes 4.167, surface 4.101, subdivided once 4.167
#   integral of x^2: 0.02344 for 0.01667
set -euo pipefail
for pair in python3-vtk9=9.1.0+really9.1.0+dfsg2-5+deb12u1 python3-gmsh=4.8.4+ds2-3; do
  version=$(dpkg-query -W -f='${Version}' "${pair%%=*}" 2>/dev/null || true)
  [ "$version" = "${pair#*=}" ] || { echo "needs ${pair%%=*} ${pair#*=}, found '${version:-none}'"; exit 77; }
done
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > ball.py <<'PYTHON'
import gmsh
import vtk


def volume(mesh, filter_class):
    measure = filter_class()
    measure.SetInputData(mesh)
    measure.Update()
    values = measure.GetOutput().GetCellData().GetArray("Volume")
    return sum(values.GetValue(n) for n in range(values.GetNumberOfTuples()))


def volume_of_surface(mesh, level):
    surface = vtk.vtkDataSetSurfaceFilter()
    surface.SetInputData(mesh)
    surface.SetNonlinearSubdivisionLevel(level)
    triangles = vtk.vtkTriangleFilter()
    triangles.SetInputConnection(surface.GetOutputPort())
    inside = vtk.vtkMassProperties()
    inside.SetInputConnection(triangles.GetOutputPort())
    inside.Update()
    return inside.GetVolume()


gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 0)
for size in (1, 0.5, 0.25):
    gmsh.clear()
    gmsh.model.occ.addSphere(0, 0, 0, 1)
    gmsh.model.occ.synchronize()
    gmsh.option.setNumber("Mesh.MeshSizeMin", size)
    gmsh.option.setNumber("Mesh.MeshSizeMax", size)
    gmsh.model.mesh.generate(3)
    gmsh.model.mesh.setOrder(2)
    kinds, elements, _ = gmsh.model.mesh.getElements(3)
    places, weights = gmsh.model.mesh.getIntegrationPoints(kinds[0], "Gauss6")
    determinants = gmsh.model.mesh.getJacobians(kinds[0], places)[1].reshape(-1, len(weights))
    gmsh.write("ball.vtk")
    reader = vtk.vtkUnstructuredGridReader()
    reader.SetFileName("ball.vtk")
    reader.Update()
    read = reader.GetOutput()
    mesh = vtk.vtkUnstructuredGrid()
    mesh.SetPoints(read.GetPoints())
    for cell in (read.GetCell(n) for n in range(read.GetNumberOfCells())):
        if cell.GetCellType() == vtk.VTK_QUADRATIC_TETRA:
            mesh.InsertNextCell(cell.GetCellType(), cell.GetPointIds())
    print(f"{mesh.GetNumberOfCells()} elements: gmsh {(determinants @ weights).sum():.3f}, "
          f"vtkCellSizeFilter {volume(mesh, vtk.vtkCellSizeFilter):.3f}, "
          f"vtkIntegrateAttributes {volume(mesh, vtk.vtkIntegrateAttributes):.3f}, "
          f"surface {volume_of_surface(mesh, 0):.3f}, subdivided once {volume_of_surface(mesh, 1):.3f}")

corners = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
middles = [[(corners[a][k] + corners[b][k]) / 2 for k in range(3)] for a, b in ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3))]
points, field = vtk.vtkPoints(), vtk.vtkDoubleArray()
field.SetName("field")
for place in corners + middles:
    points.InsertNextPoint(place)
    field.InsertNextValue(place[0] ** 2)
one = vtk.vtkUnstructuredGrid()
one.SetPoints(points)
one.InsertNextCell(vtk.VTK_QUADRATIC_TETRA, 10, list(range(10)))
one.GetPointData().AddArray(field)
integral = vtk.vtkIntegrateAttributes()
integral.SetInputData(one)
integral.Update()
print(f"integral of x^2: {integral.GetOutput().GetPointData().GetArray('field').GetValue(0):.5f} for {1 / 60:.5f}")
PYTHON
/usr/bin/python3 ball.py > seen 2> messages || { cat messages; exit 1; }
cat seen
diff seen - <<'SEEN'
50 elements: gmsh 4.151, vtkCellSizeFilter 3.907, vtkIntegrateAttributes 3.907, surface 3.214, subdivided once 3.907
261 elements: gmsh 4.186, vtkCellSizeFilter 4.111, vtkIntegrateAttributes 4.111, surface 3.889, subdivided once 4.111
1435 elements: gmsh 4.189, vtkCellSizeFilter 4.167, vtkIntegrateAttributes 4.167, surface 4.101, subdivided once 4.167
integral of x^2: 0.02344 for 0.01667
SEEN
