/// Whether two meshes are the same.
#pragma once
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <map>

#include "supple/core/rounded_to_float.hpp"
#include "supple/model/triangle_mesh.hpp"

namespace supple::testing {

/// The same vertices and triangles in the same order, coordinates to the last bit.
inline void expect_same(const TriangleMesh& found, const TriangleMesh& expected) {
  EXPECT_EQ(found.face, expected.face);
  ASSERT_EQ(found.vertex.size(), expected.vertex.size());
  for (std::size_t v = 0; v < found.vertex.size(); ++v)
    for (int d = 0; d < 3; ++d)
      EXPECT_EQ(std::bit_cast<std::uint64_t>(found.vertex[v][d]),
                std::bit_cast<std::uint64_t>(expected.vertex[v][d]))
          << v << ": " << found.vertex[v][d] << " and " << expected.vertex[v][d];
}

/// The same, but for the sign of 0.
inline void expect_equal(TriangleMesh found, TriangleMesh expected) {
  for (TriangleMesh* mesh : {&found, &expected})
    for (Vec3& x : mesh->vertex) x += Vec3{};
  expect_same(found, expected);
}

/// With coordinates that a float holds.
inline TriangleMesh as_floats(TriangleMesh mesh) {
  for (Vec3& x : mesh.vertex)
    for (int d = 0; d < 3; ++d) x[d] = rounded_to_float(x[d]);
  return mesh;
}

/// With vertices in the order in which triangles name them first.
inline TriangleMesh in_order_of_use(const TriangleMesh& mesh) {
  TriangleMesh out;
  std::map<std::int32_t, std::int32_t> number;
  for (auto face : mesh.face) {
    for (std::int32_t& v : face) {
      const auto [at, is_new] = number.emplace(v, static_cast<std::int32_t>(number.size()));
      if (is_new) out.vertex.push_back(mesh.vertex[v]);
      v = at->second;
    }
    out.face.push_back(face);
  }
  return out;
}

}  // namespace supple::testing
