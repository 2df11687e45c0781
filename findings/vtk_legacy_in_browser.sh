#!/usr/bin/env bash
# vtk.js 37.4.0 (npm: @kitware/vtk.js) and the VTKLoader of three.js 0.170.0 (npm: three) reading a .vtk file of polygons as VTK
# 9.1 writes it by default (version 5.1 of the format; Debian 12: python3-vtk9 9.1.0+really9.1.0+dfsg2-5+deb12u1), in ASCII.
#
# Guess: the polygons, or a message that the version is not known.
# Seen: the points are right and the polygons are made up: offsets and counts are taken for corners. vtk.js has six polygons of
# no corners in front of the numbers for a pentagon and two others, three.js has triangles between unrelated points. Neither
# says anything. Version 4.2 is read by both; the values on cells and points are read by neither. SetFileVersion(42).
#   version 51: vtk.js 12 points, cells 0 0 0 5 9 12 0 0 0 1 2 3
#   version 51: three.js 12 points, triangles 10 11 0 10 0 0 10 0 0 10 0 0
#   version 42: vtk.js 12 points, cells 5 0 1 2 3 4 4 5 6 7 8 3
#   version 42: three.js 12 points, triangles 0 1 2 0 2 3 0 3 4 5 6 7
set -euo pipefail
command -v npm >/dev/null || { echo "needs npm"; exit 77; }
want=9.1.0+really9.1.0+dfsg2-5+deb12u1
version=$(dpkg-query -W -f='${Version}' python3-vtk9 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs python3-vtk9 $want, found '${version:-none}'"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
/usr/bin/python3 - <<'PYTHON'
import vtk

points, polys, mesh, values = vtk.vtkPoints(), vtk.vtkCellArray(), vtk.vtkPolyData(), vtk.vtkDoubleArray()
for corners in ([(0, 0), (1, 0), (1.5, 0.5), (1, 1), (0, 1)], [(3, 0), (4, 0), (4, 1), (3, 1)], [(5, 0), (6, 0), (5, 1)]):
    polys.InsertNextCell(len(corners))
    for x, y in corners:
        polys.InsertCellPoint(points.InsertNextPoint(x, y, 0))
    values.InsertNextValue(len(corners))
values.SetName("value")
mesh.SetPoints(points)
mesh.SetPolys(polys)
mesh.GetCellData().AddArray(values)
default = vtk.vtkPolyDataWriter()
default.SetInputData(mesh)
default.SetFileName("51.vtk")
default.Write()
older = vtk.vtkPolyDataWriter()
older.SetInputData(mesh)
older.SetFileVersion(42)
older.SetFileName("42.vtk")
older.Write()
PYTHON
head -1 51.vtk | grep -q 'Version 5.1'
npm install --silent --no-save --ignore-scripts --prefix . @kitware/vtk.js@37.4.0 three@0.170.0 >/dev/null
cat > read.mjs <<'NODE'
import fs from 'fs';
import vtkPolyDataReader from '@kitware/vtk.js/IO/Legacy/PolyDataReader.js';
import { VTKLoader } from 'three/addons/loaders/VTKLoader.js';
const first = (values) => Array.from(values).slice(0, 12).join(' ');
for (const version of [51, 42]) {
  const text = fs.readFileSync(version + '.vtk', 'latin1');
  const reader = vtkPolyDataReader.newInstance();
  reader.parseAsText(text);
  const mesh = reader.getOutputData(0);
  console.log(`version ${version}: vtk.js ${mesh.getPoints().getNumberOfPoints()} points, cells ${first(mesh.getPolys().getData())}`);
  const geometry = new VTKLoader().parse(new TextEncoder().encode(text).buffer);
  console.log(`version ${version}: three.js ${geometry.attributes.position.count} points, triangles ${first(geometry.index.array)}`);
}
NODE
node read.mjs > seen
cat seen
diff seen - <<'SEEN'
version 51: vtk.js 12 points, cells 0 0 0 5 9 12 0 0 0 1 2 3
version 51: three.js 12 points, triangles 10 11 0 10 0 0 10 0 0 10 0 0
version 42: vtk.js 12 points, cells 5 0 1 2 3 4 4 5 6 7 8 3
version 42: three.js 12 points, triangles 0 1 2 0 2 3 0 3 4 5 6 7
SEEN
