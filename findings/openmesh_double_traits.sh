#!/usr/bin/env bash
# OpenMesh 9.0 (Debian 12: libopenmesh-dev 9.0-4+b1): a TriMesh with DefaultTraitsDouble, whose points have doubles, read by
# OpenMesh::IO::read_mesh and written by write_mesh: a tetrahedron with a vertex at x = 0.1234567890123456.
#
# Guess: sixteen digits are kept in text, and in binary PLY of doubles; what cannot be read, or is no manifold, is false.
# Seen: all readers hand coordinates on in single precision, 0.12345679104328, those of binary PLY with doubles as well, and text
# is written with six digits unless told otherwise: of two grains at 1000 from the origin, overlaps below 0.01 are lost.
# read_mesh is true for an OFF file with a comment below its first line, of which it has no vertex, and for a surface with one
# triangle turned, which gets three vertices of its own, so that there are seven, and a hole (stderr: "complex edge"). A check of
# what was read then does not see what was wrong.
#   OFF: true, 4 vertices, 4 faces, 0 open edges, x 0.1234567910432816
#   OBJ: true, 4 vertices, 4 faces, 0 open edges, x 0.1234567910432816
#   binary PLY of doubles: true, 4 vertices, 4 faces, 0 open edges, x 0.1234567910432816
#   OFF with a comment: true, 0 vertices, 0 faces, 0 open edges
#   one triangle turned: true, 7 vertices, 4 faces, 6 open edges, x 0.1234567910432816
#   written, x 1000.123456789: 1000.12 0 0
set -euo pipefail
want=9.0-4+b1
version=$(dpkg-query -W -f='${Version}' libopenmesh-dev 2>/dev/null || true)
[ "$version" = "$want" ] || { echo "needs libopenmesh-dev $want, found '${version:-none}'"; exit 77; }
command -v g++ >/dev/null || { echo "needs g++"; exit 77; }
folder=$(mktemp -d); trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > read.cpp <<'CPP'
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <string>

using Mesh = OpenMesh::TriMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>;
const std::string points = "0.1234567890123456 0 0\n1 0 0\n0 1 0\n0 0 1\n";
const std::string faces = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

void show(const char* name, const std::string& file) {
  Mesh mesh;
  const bool good = OpenMesh::IO::read_mesh(mesh, file);
  int open = 0;
  for (const auto edge : mesh.edges()) open += mesh.is_boundary(edge);
  std::printf("%s: %s, %zu vertices, %zu faces, %d open edges", name, good ? "true" : "false", mesh.n_vertices(), mesh.n_faces(),
              open);
  if (mesh.n_vertices() > 0) std::printf(", x %.16g", mesh.point(Mesh::VertexHandle(0))[0]);
  std::printf("\n");
}

void text(const char* file, const std::string& what) { std::ofstream(file) << what; }

int main() {
  text("plain.off", "OFF\n4 4 0\n" + points + faces);
  show("OFF", "plain.off");
  std::string obj;
  for (std::size_t at = 0; at < points.size(); at = points.find('\n', at) + 1)
    obj += "v " + points.substr(at, points.find('\n', at) - at) + "\n";
  text("plain.obj", obj + "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
  show("OBJ", "plain.obj");
  std::string ply = "ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty double x\nproperty double y\n"
                    "property double z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n";
  for (const double x : {0.1234567890123456, 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.})
    ply.append(reinterpret_cast<const char*>(&x), sizeof x);
  for (const char* face : {"\0\2\1", "\0\1\3", "\1\2\3", "\2\0\3"}) {
    ply += '\3';
    for (int k = 0; k < 3; ++k) {
      const int corner = face[k];
      ply.append(reinterpret_cast<const char*>(&corner), sizeof corner);
    }
  }
  text("plain.ply", ply);
  show("binary PLY of doubles", "plain.ply");
  text("comment.off", "OFF\n# a grain\n4 4 0\n" + points + faces);
  show("OFF with a comment", "comment.off");
  text("turned.off", "OFF\n4 4 0\n" + points + "3 0 2 1\n3 0 1 3\n3 1 3 2\n3 2 0 3\n");
  show("one triangle turned", "turned.off");

  Mesh mesh;
  OpenMesh::IO::read_mesh(mesh, "plain.off");
  mesh.set_point(Mesh::VertexHandle(0), Mesh::Point(1000.123456789, 0, 0));
  OpenMesh::IO::write_mesh(mesh, "written.off");
  std::ifstream file("written.off");
  std::string line;
  for (int k = 0; k < 3; ++k) std::getline(file, line);
  std::printf("written, x 1000.123456789: %s\n", line.c_str());
}
CPP
g++ -std=c++17 -O0 -w read.cpp -o read -lOpenMeshCore
./read > seen 2> messages
cat seen
diff seen - <<'SEEN'
OFF: true, 4 vertices, 4 faces, 0 open edges, x 0.1234567910432816
OBJ: true, 4 vertices, 4 faces, 0 open edges, x 0.1234567910432816
binary PLY of doubles: true, 4 vertices, 4 faces, 0 open edges, x 0.1234567910432816
OFF with a comment: true, 0 vertices, 0 faces, 0 open edges
one triangle turned: true, 7 vertices, 4 faces, 6 open edges, x 0.1234567910432816
written, x 1000.123456789: 1000.12 0 0
SEEN
