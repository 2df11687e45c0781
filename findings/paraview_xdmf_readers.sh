#!/usr/bin/env bash
# ParaView 5.11.0 (Debian 12: python3-paraview 5.11.0+dfsg-1+b1), which offers two readers for an XDMF file, vtkXdmfReader
# ("XDMF Reader") and vtkXdmf3Reader ("Xdmf3 Reader S"): two grains, a topology Polyvertex without connectivity, a symmetric
# stress as AttributeType Tensor6, xx = 3, yy = 2, zz = 1 and no shear, at the points, and a number of contacts at the cells;
# glyphs of the stress by vtkTensorGlyph of a sphere.
#
# Guess: two points, two cells and an ellipsoid of 3 x 2 x 1 from both.
# Seen: XDMF lists xx xy xz yy yz zz, VTK takes six components for xx yy zz xy yz xz. vtkXdmfReader makes nine of them, which is
# right; vtkXdmf3Reader hands on the six as they are, so that yy is taken for xy, zz for xz, and xy, which is 0, for yy: the
# trace is 3 for 6, the glyph another one. The newer reader also makes no cells from the Polyvertex, with or without
# NodesPerElement, so that the grains are not drawn and the numbers at the cells are gone; a connectivity 0 1 brings them back.
# A full tensor (AttributeType Tensor) is right in both. Nothing is said.
#   Tensor6, vtkXdmfReader: 2 points, 2 cells, contacts [4, 6], 9 components, glyph 3.0 x 2.0 x 1.0
#   Tensor6, vtkXdmf3Reader: 2 points, 0 cells, contacts None, 6 components, glyph 3.7 x 2.0 x 1.0
#   Tensor6, connectivity, vtkXdmfReader: 2 points, 2 cells, contacts [4, 6], 9 components, glyph 3.0 x 2.0 x 1.0
#   Tensor6, connectivity, vtkXdmf3Reader: 2 points, 2 cells, contacts [4, 6], 6 components, glyph 3.7 x 2.0 x 1.0
#   Tensor, connectivity, vtkXdmfReader: 2 points, 2 cells, contacts [4, 6], 9 components, glyph 3.0 x 2.0 x 1.0
#   Tensor, connectivity, vtkXdmf3Reader: 2 points, 2 cells, contacts [4, 6], 9 components, glyph 3.0 x 2.0 x 1.0
set -euo pipefail
want=5.11.0+dfsg-1+b1
version=$(dpkg-query -W -f='${Version}' python3-paraview 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs python3-paraview $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > grains.py <<'PYTHON'
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkTensorGlyph
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOXdmf2 import vtkXdmfReader
from vtkmodules.vtkIOXdmf3 import vtkXdmf3Reader


def item(size, kind, values):
    return f'<DataItem Dimensions="{size}" NumberType="{kind}" Precision="8" Format="XML">{values}</DataItem>'


def write(topology, kind, stress):
    text = f"""<?xml version="1.0"?>
<Xdmf Version="3.0"><Domain><Grid Name="grains" GridType="Uniform">
<Topology TopologyType="Polyvertex" NumberOfElements="2" NodesPerElement="1">{topology}</Topology>
<Geometry GeometryType="XYZ">{item('2 3', 'Float', '0 0 0 9 0 0')}</Geometry>
<Attribute Name="stress" AttributeType="{kind}" Center="Node">{item(stress[0], 'Float', stress[1])}</Attribute>
<Attribute Name="contacts" AttributeType="Scalar" Center="Cell">{item('2', 'Float', '4 6')}</Attribute>
</Grid></Domain></Xdmf>
"""
    with open("grains.xmf", "w") as file:
        file.write(text)


def show(name):
    for reader in (vtkXdmfReader(), vtkXdmf3Reader()):
        reader.SetFileName("grains.xmf")
        reader.Update()
        grains = reader.GetOutputDataObject(0)
        while grains.IsA("vtkMultiBlockDataSet"):
            grains = grains.GetBlock(0)
        stress = grains.GetPointData().GetArray("stress")
        contacts = grains.GetCellData().GetArray("contacts")
        sphere = vtkSphereSource()
        sphere.SetThetaResolution(100)
        sphere.SetPhiResolution(101)
        glyph = vtkTensorGlyph()
        glyph.SetSourceConnection(sphere.GetOutputPort())
        glyph.SetInputData(grains)
        glyph.SetInputArrayToProcess(0, 0, 0, 0, "stress")
        glyph.Update()
        box = glyph.GetOutput().GetBounds()
        numbers = contacts and vtk_to_numpy(contacts).astype(int).tolist()
        print(f"{name}, {reader.GetClassName()}: {grains.GetNumberOfPoints()} points, {grains.GetNumberOfCells()} cells, "
              f"contacts {numbers}, {stress.GetNumberOfComponents()} components, "
              f"glyph {box[1] - box[0] - 9:.1f} x {box[3] - box[2]:.1f} x {box[5] - box[4]:.1f}")


six = "2 6", "3 0 0 2 0 1 3 0 0 2 0 1"
write("", "Tensor6", six)
show("Tensor6")
write(item("2 1", "Int", "0 1"), "Tensor6", six)
show("Tensor6, connectivity")
write(item("2 1", "Int", "0 1"), "Tensor", ("2 9", "3 0 0 0 2 0 0 0 1 3 0 0 0 2 0 0 0 1"))
show("Tensor, connectivity")
PYTHON
/usr/bin/python3 grains.py > seen 2> messages || { cat messages; exit 1; }
cat seen
diff seen - <<'SEEN'
Tensor6, vtkXdmfReader: 2 points, 2 cells, contacts [4, 6], 9 components, glyph 3.0 x 2.0 x 1.0
Tensor6, vtkXdmf3Reader: 2 points, 0 cells, contacts None, 6 components, glyph 3.7 x 2.0 x 1.0
Tensor6, connectivity, vtkXdmfReader: 2 points, 2 cells, contacts [4, 6], 9 components, glyph 3.0 x 2.0 x 1.0
Tensor6, connectivity, vtkXdmf3Reader: 2 points, 2 cells, contacts [4, 6], 6 components, glyph 3.7 x 2.0 x 1.0
Tensor, connectivity, vtkXdmfReader: 2 points, 2 cells, contacts [4, 6], 9 components, glyph 3.0 x 2.0 x 1.0
Tensor, connectivity, vtkXdmf3Reader: 2 points, 2 cells, contacts [4, 6], 9 components, glyph 3.0 x 2.0 x 1.0
SEEN
