#!/usr/bin/env bash
# meshio 7.0.0, Open3D 0.16.1 (Debian 12: python3-meshio 7.0.0-3, python3-open3d 0.16.1+ds-2+b4) and webgl-obj-loader 2.0.8 (npm):
# unit cubes from .obj files in five ways that the format allows: triangles; faces of four; two cubes, each with faces that count
# back from their last vertex (-1); the same for one; vertices with a fourth number, the weight 1.
#
# Guess: a volume of 1 for each cube, or an error.
# Seen: meshio counts back one too far and from the end of the whole file: of two grains the second is there twice, each with one
# corner of the first, and the volume is 0; for one grain the indices are out of range, and for weights so are the points. Open3D
# leaves a mesh of faces of four without any point, and one that has a single such face, too; it says that it skips, at the level
# INFO. webgl-obj-loader takes the weight for the next x, so that the volume is 0, and cannot count back: it is NaN. VTK and three
# read all five. Write triangles, with positive numbers and three coordinates.
#   triangles: meshio 1.000; Open3D 1.000, 8 points
#   four: meshio 1.000; Open3D 0.000, 0 points
#   one back: meshio index out of range; Open3D 0.000, 0 points
#   two back: meshio 0.000; Open3D 0.000, 0 points
#   weights: meshio points with 4 coordinates; Open3D 0.000, 0 points
#   triangles: webgl-obj-loader 1.000
#   four: webgl-obj-loader 1.000
#   one back: webgl-obj-loader NaN
#   two back: webgl-obj-loader NaN
#   weights: webgl-obj-loader 0.000
set -euo pipefail
for want in python3-meshio=7.0.0-3 python3-open3d=0.16.1+ds-2+b4; do
  version=$(dpkg-query -W -f='${Version}' "${want%%=*}" 2>/dev/null || true)
  [ "$version" = "${want#*=}" ] || { echo "needs ${want%%=*} ${want#*=}, found '${version:-none}'"; exit 77; }
done
command -v npm >/dev/null || { echo "needs npm"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-save --ignore-scripts --prefix . webgl-obj-loader@2.0.8 >/dev/null
cat > cubes.py <<'PYTHON'
import meshio
import numpy
import open3d

corners = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
faces = [(1, 2, 4, 3), (5, 7, 8, 6), (1, 5, 6, 2), (3, 4, 8, 7), (1, 3, 7, 5), (2, 6, 8, 4)]


def vertices(more="", shift=0):
    return "".join(f"v {x + shift} {y} {z}{more}\n" for x, y, z in corners)


four = "".join(f"f {a} {b} {c} {d}\n" for a, b, c, d in faces)
three = "".join(f"f {a} {b} {c}\nf {a} {c} {d}\n" for a, b, c, d in faces)
back = "".join("f " + " ".join(str(n - 9) for n in face) + "\n" for face in faces)
files = {"triangles": vertices() + three, "four": vertices() + four, "one back": vertices() + back,
         "two back": "o a\n" + vertices() + back + "o b\n" + vertices(shift=3) + back, "weights": vertices(" 1.0") + four}
for name, text in files.items():
    open(name + ".obj", "w").write(text)


def volume(points, polygons):
    return sum(numpy.dot(points[face[0]], numpy.cross(points[face[k]], points[face[k + 1]]))
               for face in polygons for k in range(1, len(face) - 1)) / 6


for name in files:
    mesh = meshio.read(name + ".obj")
    try:
        seen = f"{sum(volume(mesh.points, cells.data) for cells in mesh.cells):.3f}"
    except IndexError:
        seen = "index out of range"
    except ValueError:
        seen = f"points with {mesh.points.shape[1]} coordinates"
    solid = open3d.io.read_triangle_mesh(name + ".obj")
    print(f"{name}: meshio {seen}; Open3D {volume(numpy.asarray(solid.vertices), numpy.asarray(solid.triangles)):.3f}, "
          f"{len(solid.vertices)} points")
PYTHON
cat > cubes.mjs <<'NODE'
import { readFileSync } from 'fs';
import loader from 'webgl-obj-loader';

for (const name of ['triangles', 'four', 'one back', 'two back', 'weights']) {
  const { vertices, indices } = new loader.Mesh(readFileSync(`${name}.obj`, 'utf8'));
  let sum = 0;
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => [0, 1, 2].map((axis) => vertices[3 * indices[i + k] + axis]));
    for (let k = 0; k < 3; k++) sum += a[k] * (b[(k + 1) % 3] * c[(k + 2) % 3] - b[(k + 2) % 3] * c[(k + 1) % 3]) / 6;
  }
  console.log(`${name}: webgl-obj-loader ${sum.toFixed(3)}`);
}
NODE
/usr/bin/python3 -W ignore cubes.py > all 2> messages || { cat messages; exit 1; }
grep -v INFO all > seen
node cubes.mjs >> seen
cat seen
diff seen - <<'SEEN'
triangles: meshio 1.000; Open3D 1.000, 8 points
four: meshio 1.000; Open3D 0.000, 0 points
one back: meshio index out of range; Open3D 0.000, 0 points
two back: meshio 0.000; Open3D 0.000, 0 points
weights: meshio points with 4 coordinates; Open3D 0.000, 0 points
triangles: webgl-obj-loader 1.000
four: webgl-obj-loader 1.000
one back: webgl-obj-loader NaN
two back: webgl-obj-loader NaN
weights: webgl-obj-loader 0.000
SEEN
