/// Mesh files in VTK, and its files in Supple. Where VTK is missing the tests are skipped and say so.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <nlohmann/json.hpp>

#include "supple/io/mesh/mesh_file.hpp"
#include "tests/io/same_mesh.hpp"
#include "tests/io/temporary_folder.hpp"
#include "tests/paths.hpp"
#include "tests/support/meshes.hpp"

namespace supple {
namespace {

using namespace testing;

class VtkMesh : public TemporaryFolder {
 protected:
  void SetUp() override {
    if (run("/usr/bin/python3 -c 'import vtkmodules.vtkIOPLY, vtkmodules.vtkIOGeometry'") != 0)
      GTEST_SKIP() << "VTK (python3-vtk9) is not installed";
  }
  int run(const std::string& line) {
    const int status = std::system(("cd '" + folder() + "' && " + line + " >out.txt 2>err.txt").c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  /// What VTK reads from a file; it writes that to `others`, as ASCII_NAME and Binary_NAME.
  TriangleMesh read_with_vtk(const std::string& name, const std::string& others = "") {
    EXPECT_EQ(run("/usr/bin/python3 " SUPPLE_SOURCE_DIR "/tests/io/read_mesh.py " + name + " " + others), 0)
        << content_of(in_folder("err.txt"));
    const auto json = nlohmann::json::parse(content_of(in_folder("out.txt")));
    EXPECT_EQ(json.at("others"), 0);
    TriangleMesh mesh;
    for (const auto& x : json.at("points")) mesh.vertex.push_back({x.at(0), x.at(1), x.at(2)});
    for (const auto& f : json.at("polygons")) {
      EXPECT_EQ(f.size(), 3u);
      mesh.face.push_back({f.at(0), f.at(1), f.at(2)});
    }
    return mesh;
  }
};

/// Two surfaces without symmetry, so that no turned triangle or exchanged coordinate looks as it should.
std::vector<TriangleMesh> surfaces() {
  TriangleMesh ragged = star();
  const auto moves = random_moves(ragged.vertex.size(), 5);
  for (std::size_t v = 0; v < moves.size(); ++v) ragged.vertex[v] += 0.01 * moves[v];
  TriangleMesh ring = torus(9, 6);
  for (Vec3& x : ring.vertex) x = {1e-6 * x[0], 2e-6 * x[1] + 3e-6, 5e-6 * x[2] - 1e-5};
  return {ragged, ring};
}

/// VTK holds points as floats.
TEST_F(VtkMesh, ReadsOursWithTheSameVerticesFacesAndOrientation) {
  for (const TriangleMesh& mesh : surfaces())
    for (const char* name : {"a.obj", "a.ply", "a.stl"}) {
      SCOPED_TRACE(name);
      write_mesh(in_folder(name), mesh, Existing::replace);
      const TriangleMesh expected = as_floats(std::string(name) == "a.stl" ? in_order_of_use(mesh) : mesh);
      const TriangleMesh found = read_with_vtk(name);
      expect_same(found, expected);
      EXPECT_GT(enclosed_volume(found), 0);
    }
}

TEST_F(VtkMesh, WritesWhatWeRead) {
  for (const TriangleMesh& mesh : surfaces()) {
    write_mesh(in_folder("a.ply"), mesh, Existing::replace);
    const TriangleMesh floats = read_with_vtk("a.ply", "b.obj b.ply b.stl");
    expect_same(floats, as_floats(mesh));
    for (const char* name : {"ASCII_b.obj", "ASCII_b.ply", "Binary_b.ply", "ASCII_b.stl", "Binary_b.stl"}) {
      SCOPED_TRACE(name);
      const TriangleMesh found = read_mesh(in_folder(name));
      // Of text VTK writes 6 digits.
      const TriangleMesh expected = std::string(name).ends_with("stl") ? in_order_of_use(floats) : floats;
      if (std::string(name).starts_with("Binary")) expect_same(found, expected);
      EXPECT_EQ(found.face, expected.face);
      ASSERT_EQ(found.vertex.size(), expected.vertex.size());
      for (std::size_t v = 0; v < found.vertex.size(); ++v)
        EXPECT_LE(norm(found.vertex[v] - expected.vertex[v]), 2e-6 * norm(expected.vertex[v]));
    }
  }
}

}  // namespace
}  // namespace supple
