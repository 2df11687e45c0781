#!/usr/bin/env bash
# Assimp 5.2.5 (Debian 12: libassimp-dev 5.2.5~ds0-1+b1) and Open3D 0.16.1 (python3-open3d 0.16.1+ds-2+b4), which reads STL and
# OBJ by it: an icosphere of 642 vertices and 1280 triangles, of ever smaller radius, as of grains in metres. By default Assimp
# gives each triangle of an OBJ or STL file three vertices of its own; aiProcess_JoinIdenticalVertices makes one surface of them.
#
# Guess: identical vertices are those with the same coordinates: 642 vertices, a closed surface and 0.991 of the volume of the
# sphere at every radius.
# Seen: from a radius of 1e-5 on (10 micrometres) different vertices are joined as well, some of those less than 1e-5 apart,
# whatever the size of the mesh: 2% to 15% of the volume are missing, and the surface is not closed. All triangles are kept,
# some without area. Status and messages are those of success. Open3D has the same from .stl and .obj, not from .off or .ply.
# Scale the coordinates before reading.
#   radius 1: Assimp 642 vertices, volume 0.991; Open3D .stl 642, 0.991, watertight True; .off 642, 0.991, watertight True
#   radius 0.0001: Assimp 642 vertices, volume 0.991; Open3D .stl 642, 0.991, watertight True; .off 642, 0.991, watertight True
#   radius 1e-05: Assimp 628 vertices, volume 0.973; Open3D .stl 628, 0.973, watertight False; .off 642, 0.991, watertight True
#   radius 1e-06: Assimp 595 vertices, volume 0.846; Open3D .stl 595, 0.846, watertight False; .off 642, 0.991, watertight True
#   radius 1e-07: Assimp 592 vertices, volume 0.878; Open3D .stl 592, 0.878, watertight False; .off 642, 0.991, watertight True
set -euo pipefail
for pair in libassimp-dev=5.2.5~ds0-1+b1 python3-open3d=0.16.1+ds-2+b4; do
  version=$(dpkg-query -W -f='${Version}' "${pair%%=*}" 2>/dev/null || true)
  [ "$version" = "${pair#*=}" ] || { echo "needs ${pair%%=*} ${pair#*=}, found '${version:-none}'"; exit 77; }
done
command -v g++ >/dev/null || { echo "needs g++"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > join.cpp <<'CPP'
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/Importer.hpp>
#include <cmath>
#include <cstdio>
#include <cstdlib>

int main(int, char** arguments) {
  const double radius = std::atof(arguments[2]);
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(arguments[1], aiProcess_JoinIdenticalVertices);
  if (scene == nullptr || scene->mNumMeshes != 1 || scene->mMeshes[0]->mNumFaces != 1280) return 1;
  const aiMesh& mesh = *scene->mMeshes[0];
  double volume = 0;
  for (unsigned n = 0; n < mesh.mNumFaces; ++n) {
    double p[3][3];
    for (int k = 0; k < 3; ++k) {
      const aiVector3D& corner = mesh.mVertices[mesh.mFaces[n].mIndices[k]];
      p[k][0] = corner.x / radius, p[k][1] = corner.y / radius, p[k][2] = corner.z / radius;
    }
    for (int k = 0; k < 3; ++k) {
      const int l = (k + 1) % 3, m = (k + 2) % 3;
      volume += p[0][k] * (p[1][l] * p[2][m] - p[1][m] * p[2][l]) / 6;
    }
  }
  std::printf("Assimp %u vertices, volume %.3f", mesh.mNumVertices, volume / (4 * std::acos(-1.) / 3));
}
CPP
g++ -O1 join.cpp -o join -lassimp
cat > spheres.py <<'PYTHON'
import subprocess
import numpy
import open3d

solid = open3d.geometry.TriangleMesh.create_icosahedron().subdivide_midpoint(3)
points, triangles = numpy.asarray(solid.vertices), numpy.asarray(solid.triangles)
points = points / numpy.linalg.norm(points, axis=1)[:, None]
for radius in (1, 1e-4, 1e-5, 1e-6, 1e-7):
    places = radius * points
    with open("grain.stl", "w") as file:
        print("solid grain", file=file)
        for triangle in triangles:
            print("facet normal 0 0 0\nouter loop", file=file)
            for x, y, z in places[triangle]:
                print(f"vertex {x:.9g} {y:.9g} {z:.9g}", file=file)
            print("endloop\nendfacet", file=file)
        print("endsolid grain", file=file)
    with open("grain.off", "w") as file:
        print(f"OFF\n{len(places)} {len(triangles)} 0", file=file)
        for x, y, z in places:
            print(f"{x:.9g} {y:.9g} {z:.9g}", file=file)
        for triangle in triangles:
            print(3, *triangle, file=file)
    texts = [subprocess.run(["./join", "grain.stl", str(radius)], check=True, capture_output=True, text=True).stdout]
    for ending in ("stl", "off"):
        mesh = open3d.io.read_triangle_mesh(f"grain.{ending}")
        a, b, c = numpy.asarray(mesh.vertices)[numpy.asarray(mesh.triangles).T] / radius
        share = (a * numpy.cross(b, c)).sum() / 6 / (4 * numpy.pi / 3)
        texts.append(f"{'Open3D ' if ending == 'stl' else ''}.{ending} {len(mesh.vertices)}, {share:.3f}, "
                     f"watertight {mesh.is_watertight()}")
    print(f"SEEN radius {radius}: {'; '.join(texts)}")
PYTHON
/usr/bin/python3 spheres.py > messages 2>&1 || { cat messages; exit 1; }
sed -n 's/^SEEN //p' messages > seen
cat seen
diff seen - <<'SEEN'
radius 1: Assimp 642 vertices, volume 0.991; Open3D .stl 642, 0.991, watertight True; .off 642, 0.991, watertight True
radius 0.0001: Assimp 642 vertices, volume 0.991; Open3D .stl 642, 0.991, watertight True; .off 642, 0.991, watertight True
radius 1e-05: Assimp 628 vertices, volume 0.973; Open3D .stl 628, 0.973, watertight False; .off 642, 0.991, watertight True
radius 1e-06: Assimp 595 vertices, volume 0.846; Open3D .stl 595, 0.846, watertight False; .off 642, 0.991, watertight True
radius 1e-07: Assimp 592 vertices, volume 0.878; Open3D .stl 592, 0.878, watertight False; .off 642, 0.991, watertight True
SEEN
