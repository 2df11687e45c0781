#!/usr/bin/env bash
# PLY files of a cube of volume 1, by meshio 7.0.0, Open3D 0.16.1 and Assimp 5.2.5 (Debian 12: python3-meshio 7.0.0-3,
# python3-open3d 0.16.1+ds-2+b4, assimp-utils 5.2.5~ds0-1+b1): triangles after the vertices, as usual; triangles before them,
# as a header may name its elements in any order; and triangle strips, as in the scans that the format was made for.
#
# Guess: 1, or an error where a reader does not know a kind.
# Seen: with the triangles first meshio takes the first eight lines for the points all the same: points are (3, 0, 2) and the
# like, a number of corners and two of them, four triangles are left, and the volume from them is anything. Of strips Open3D
# has the points alone, and Assimp one triangle, with success. Only the usual order is safe everywhere.
#   after: meshio 12 triangles, 1.000; Open3D 12 triangles, 1.000; Assimp 12 triangles, 1.000
#   before: meshio 4 triangles, 6.000; Open3D 12 triangles, 1.000; Assimp an error
#   strips: meshio an error; Open3D 0 triangles, 0.000; Assimp 1 triangles, 0.000
set -euo pipefail
for want in python3-meshio=7.0.0-3 python3-open3d=0.16.1+ds-2+b4 assimp-utils=5.2.5~ds0-1+b1; do
  version=$(dpkg-query -W -f='${Version}' "${want%%=*}" 2>/dev/null || true)
  [ "$version" = "${want#*=}" ] || { echo "needs ${want%%=*} ${want#*=}, found '${version:-none}'"; exit 77; }
done
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > cubes.py <<'PYTHON'
import os
import subprocess

import meshio
import numpy
import open3d

points = numpy.array([(a, b, c) for c in (0, 1) for b in (0, 1) for a in (0, 1)])
strips = ((0, 2, 1, 3), (4, 5, 6, 7), (0, 1, 4, 5), (1, 3, 5, 7), (3, 2, 7, 6), (2, 0, 6, 4))
triangles = [three for a, b, c, d in strips for three in ((a, b, c), (c, b, d))]
vertex = ["element vertex 8", "property float x", "property float y", "property float z"]
face = ["element face 12", "property list uchar int vertex_indices"]
strip = ["element tristrips 1", "property list int int vertex_indices"]
rows = [" ".join(map(str, point)) for point in points], ["3 " + " ".join(map(str, three)) for three in triangles]
joined = " -1 ".join(" ".join(map(str, four)) for four in strips)


def write(name, head, body):
    lines = ["ply", "format ascii 1.0", *head, "end_header", *body]
    open(name + ".ply", "w").write("\n".join(lines) + "\n")


def volume(corners, faces):
    corners = numpy.asarray(corners, dtype=float)
    return f"{len(faces)} triangles, {sum(numpy.linalg.det(corners[list(three)]) / 6 for three in faces) + 0.0:.3f}"


def by_meshio(file):
    mesh = meshio.read(file)
    return volume(mesh.points, [three for block in mesh.cells if block.type == "triangle" for three in block.data])


def by_open3d(file):
    mesh = open3d.io.read_triangle_mesh(file)
    return volume(mesh.vertices, numpy.asarray(mesh.triangles))


def by_assimp(file):
    if os.path.exists("out.obj"):
        os.remove("out.obj")
    subprocess.run(["assimp", "export", file, "out.obj"], capture_output=True)
    lines = [line.split() for line in open("out.obj")]
    return volume([line[1:4] for line in lines if line[:1] == ["v"]],
                  [[int(word.split("/")[0]) - 1 for word in line[1:]] for line in lines if line[:1] == ["f"]])


open3d.utility.set_verbosity_level(open3d.utility.VerbosityLevel.Error)
assert volume(points, triangles) == "12 triangles, 1.000"
assert len(joined.split()) == 29
write("after", vertex + face, rows[0] + rows[1])
write("before", face + vertex, rows[1] + rows[0])
write("strips", vertex + strip, rows[0] + ["29 " + joined])
for name in ("after", "before", "strips"):
    found = []
    for program, read in (("meshio", by_meshio), ("Open3D", by_open3d), ("Assimp", by_assimp)):
        try:
            found.append(f"{program} {read(name + '.ply')}")
        except (Exception, SystemExit):
            found.append(f"{program} an error")
    print(f"{name}: " + "; ".join(found))
PYTHON
/usr/bin/python3 cubes.py > all 2> messages || { cat messages; exit 1; }
grep -E '^(after|before|strips):' all > seen
cat seen
diff seen - <<'SEEN'
after: meshio 12 triangles, 1.000; Open3D 12 triangles, 1.000; Assimp 12 triangles, 1.000
before: meshio 4 triangles, 6.000; Open3D 12 triangles, 1.000; Assimp an error
strips: meshio an error; Open3D 0 triangles, 0.000; Assimp 1 triangles, 0.000
SEEN
