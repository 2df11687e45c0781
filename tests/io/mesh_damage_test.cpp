/// Mesh files that are cut off or damaged: an error, or a sound mesh, never anything else.
#include <gtest/gtest.h>

#include <optional>

#include "supple/core/random.hpp"
#include "supple/geometry/mesh_fault.hpp"
#include "supple/io/mesh/mesh_file.hpp"
#include "tests/io/mesh_texts.hpp"
#include "tests/io/same_mesh.hpp"
#include "tests/io/temporary_folder.hpp"
#include "tests/support/meshes.hpp"

namespace supple {
namespace {

using namespace testing;

class DamagedMesh : public TemporaryFolder {
 protected:
  /// The mesh of a file of this content; none where it is refused.
  std::optional<TriangleMesh> read(const std::string& content) {
    const std::string path = in_folder("mesh");
    std::filesystem::remove(path);  // some file systems make it durable where it is overwritten
    write_content(path, content);
    try {
      return read_mesh(path);
    } catch (const Error& e) {
      EXPECT_NE(std::string(e.what()).find(path), std::string::npos) << e.what();
      return std::nullopt;
    }
  }
};

/// A file of each kind.
std::vector<std::string> files_of(const TriangleMesh& mesh, const std::string& folder) {
  std::vector<std::string> all = {as_stl_text(mesh), as_binary_stl(mesh), as_binary_stl(mesh, "solid"),
                                  as_binary_ply<double>(mesh, "double", std::endian::big),
                                  as_binary_ply<float>(mesh, "float", std::endian::little)};
  for (const char* name : {"/a.obj", "/a.off", "/a.ply"}) {
    write_mesh(folder + name, mesh);
    all.push_back(content_of(folder + name));
  }
  return all;
}

bool is_same(const TriangleMesh& a, const TriangleMesh& b) {
  return a.face == b.face && std::equal(a.vertex.begin(), a.vertex.end(), b.vertex.begin(), b.vertex.end(),
                                        [](const Vec3& x, const Vec3& y) { return norm(x - y) == 0; });
}

/// What is left of a file is refused, but for its last line end, or the name of a solid.
TEST_F(DamagedMesh, FilesThatAreCutOff) {
  std::vector<std::string> all = files_of(octahedron(), folder());
  all.insert(all.end(), {tetrahedron_obj, tetrahedron_off, tetrahedron_ply});
  for (const std::string& whole : all) {
    const auto mesh = read(whole);
    ASSERT_TRUE(mesh);
    std::size_t least = whole.size() - (whole.ends_with('\n') ? 1 : 0);
    if (const std::size_t name = whole.find("endsolid a"); name != std::string::npos) least = name + 8;
    for (std::size_t length = 0; length < whole.size(); ++length) {
      const auto found = read(whole.substr(0, length));
      EXPECT_EQ(found.has_value(), length >= least) << whole << length;
      if (found) expect_same(*found, *mesh);
    }
  }
}

/// Every byte, set to some that mean something, and to random ones.
TEST_F(DamagedMesh, FilesWithOneByteDamaged) {
  RandomStream draw(12, Purpose::test);
  std::vector<std::string> all = files_of(tetrahedron(), folder());
  all.insert(all.end(), {tetrahedron_obj, tetrahedron_off, tetrahedron_ply});
  int same = 0, other = 0, refused = 0;
  for (const std::string& whole : all) {
    const TriangleMesh mesh = read(whole).value();
    for (std::size_t at = 0; at < whole.size(); ++at) {
      std::string bytes(1, " \n-\0\xff"[draw.below(5)]);
      bytes += static_cast<char>(draw.below(256));
      bytes += static_cast<char>(whole[at] ^ (1 << draw.below(8)));
      for (const char byte : bytes) {
        std::string damaged = whole;
        damaged[at] = byte;
        const auto found = read(damaged);
        if (!found) ++refused;
        else if (is_same(*found, mesh)) ++same;
        else ++other;
        if (found) {
          EXPECT_FALSE(find_fault(*found));
          EXPECT_EQ(found->face.size(), mesh.face.size()) << damaged;
        }
      }
    }
  }
  EXPECT_GT(refused, other);
  EXPECT_GT(same, 0);
  EXPECT_GT(other, 0);  // a digit of a coordinate
}

/// Bytes and pieces that go, come and move, several in a file.
TEST_F(DamagedMesh, FilesWithMuchDamage) {
  RandomStream draw(13, Purpose::test);
  const std::vector<std::string> all = files_of(tetrahedron(), folder());
  int refused = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    std::string text = all[static_cast<std::size_t>(trial) % all.size()];
    for (auto changes = 1 + draw.below(3); changes > 0; --changes) {
      const auto at = draw.below(text.size()), length = draw.below(20);
      switch (draw.below(4)) {
        case 0: text.erase(at, length); break;
        case 1: text.insert(at, text.substr(draw.below(text.size()), length)); break;
        case 2: text[at] = static_cast<char>(draw.below(256)); break;
        default: text.replace(at, 1, "99999999999"); break;
      }
      if (text.empty()) break;
    }
    if (const auto found = read(text)) EXPECT_FALSE(find_fault(*found));
    else ++refused;
  }
  EXPECT_GT(refused, 3000);
}

}  // namespace
}  // namespace supple
