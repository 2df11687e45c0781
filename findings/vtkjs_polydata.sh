#!/usr/bin/env bash
# vtk.js 37.4.0 (npm: @kitware/vtk.js) reading .vtp files that VTK 9.1 wrote (Debian 12: python3-vtk9
# 9.1.0+really9.1.0+dfsg2-5+deb12u1), inline base64 and ASCII.
#
# Guess: what VTK writes inline is read, whichever of its options, and a number too large for a type is an error.
# Seen: with VTK's default UInt32 header and no compressor a Float64 array is a RangeError, as its four bytes of header leave
# the numbers unaligned: coordinates in double precision are never read. The same with the zlib compressor, or with a UInt64
# header, is fine. All 64-bit integers keep their low 32 bits, silently, also in ASCII: id 4294967303 becomes 7.
#   base64, UInt32 header: RangeError start offset of Float64Array should be a multiple of 8
#   base64, UInt32 header, zlib: x 0,1,1.5,1,0 ids 1,-1,-2147483648,7,5
#   base64, UInt64 header: x 0,1,1.5,1,0 ids 1,-1,-2147483648,7,5
#   ascii: x 0,1,1.5,1,0 ids 1,-1,-2147483648,7,5
set -euo pipefail
command -v npm >/dev/null || { echo "needs npm"; exit 77; }
want=9.1.0+really9.1.0+dfsg2-5+deb12u1
version=$(dpkg-query -W -f='${Version}' python3-vtk9 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs python3-vtk9 $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
/usr/bin/python3 - <<'PYTHON'
import vtk

points, polys, mesh, ids = vtk.vtkPoints(), vtk.vtkCellArray(), vtk.vtkPolyData(), vtk.vtkLongLongArray()
points.SetDataTypeToDouble()
polys.InsertNextCell(5)
for x, y in [(0, 0), (1, 0), (1.5, 0.5), (1, 1), (0, 1)]:
    polys.InsertCellPoint(points.InsertNextPoint(x, y, 0))
ids.SetName("id")
for value in (1, -1, 2**31, 2**32 + 7, 5):
    ids.InsertNextValue(value)
mesh.SetPoints(points)
mesh.SetPolys(polys)
mesh.GetPointData().AddArray(ids)
for path, bits, compressor, mode in (("32", 32, "None", "Binary"), ("32z", 32, "ZLib", "Binary"),
                                     ("64", 64, "None", "Binary"), ("ascii", 32, "None", "Ascii")):
    writer = vtk.vtkXMLPolyDataWriter()
    writer.SetInputData(mesh)
    writer.SetFileName(path + ".vtp")
    getattr(writer, f"SetHeaderTypeToUInt{bits}")()
    getattr(writer, f"SetCompressorTypeTo{compressor}")()
    getattr(writer, f"SetDataModeTo{mode}")()
    writer.Write()
PYTHON
npm install --silent --no-save --ignore-scripts --prefix . @kitware/vtk.js@37.4.0 >/dev/null
cat > read.mjs <<'NODE'
import fs from 'fs';
import vtkXMLPolyDataReader from '@kitware/vtk.js/IO/XML/XMLPolyDataReader.js';
for (const [label, path] of [['base64, UInt32 header', '32'], ['base64, UInt32 header, zlib', '32z'],
                             ['base64, UInt64 header', '64'], ['ascii', 'ascii']]) {
  const bytes = fs.readFileSync(path + '.vtp');
  try {
    const reader = vtkXMLPolyDataReader.newInstance();
    reader.parseAsArrayBuffer(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
    const mesh = reader.getOutputData(0);
    const x = Array.from(mesh.getPoints().getData()).filter((_, i) => i % 3 === 0);
    console.log(`${label}: x ${x} ids ${Array.from(mesh.getPointData().getArrayByName('id').getData())}`);
  } catch (error) {
    console.log(`${label}: ${error.name} ${error.message}`);
  }
}
NODE
node read.mjs > seen
cat seen
diff seen - <<'SEEN'
base64, UInt32 header: RangeError start offset of Float64Array should be a multiple of 8
base64, UInt32 header, zlib: x 0,1,1.5,1,0 ids 1,-1,-2147483648,7,5
base64, UInt64 header: x 0,1,1.5,1,0 ids 1,-1,-2147483648,7,5
ascii: x 0,1,1.5,1,0 ids 1,-1,-2147483648,7,5
SEEN
