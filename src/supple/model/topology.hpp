/// How sites are grouped into bodies, and the facets and hinges of a body's boundary.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

namespace supple {

/// Sites [begin[b], begin[b+1]) form body b; empty `begin`: every site is a body of its own (discs).
/// A facet has Dim sites (edge, triangle); a hinge joins two facets (Dim + 1 sites); a bond joins two sites.
template <int Dim>
struct Topology {
  std::vector<std::int32_t> begin;
  std::vector<std::array<std::int32_t, Dim>> facet;
  std::vector<std::array<std::int32_t, Dim + 1>> hinge;
  std::vector<std::array<std::int32_t, 2>> bond;

  int body_count(int sites) const { return begin.empty() ? sites : static_cast<int>(begin.size()) - 1; }
};

}  // namespace supple
