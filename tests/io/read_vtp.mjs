// Reads .vtp files with vtk.js, found from the folder of the first argument; prints points, polygons and their times.
import { createRequire } from "module";
import { readFileSync } from "fs";
import { pathToFileURL } from "url";

const [, , from, ...files] = process.argv;
const path = createRequire(from + "/").resolve("@kitware/vtk.js/IO/XML/XMLPolyDataReader.js");
const { default: Reader } = await import(pathToFileURL(path));
for (const file of files) {
  const reader = Reader.newInstance();
  const bytes = readFileSync(file);
  reader.parseAsArrayBuffer(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
  const mesh = reader.getOutputData(0);
  const points = mesh.getPoints().getData();
  const area = mesh.getCellData().getArrayByName("area");
  console.log(JSON.stringify({
    points: points.length / 3,
    polygons: mesh.getPolys().getNumberOfCells(),
    first: Array.from(points.slice(0, 2)),
    area: area ? Array.from(area.getData()) : [],
  }));
}
