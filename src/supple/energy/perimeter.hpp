#pragma once
#include <string_view>
#include <tuple>

#include "supple/core/field.hpp"
#include "supple/geometry/facet.hpp"

namespace supple {

/// Perimeter of a polygon in 2D, area of a surface in 3D, as of cells in tissues [Farhadifar et al. 2007; Bi
/// et al. 2015, eq. 1]:
///     E = (k/2) (p - p0)^2,   k [energy / length^(2(Dim-1))],  p0 [length^(Dim-1)].
struct Perimeter {
  static constexpr std::string_view name = "perimeter";
  struct Param {
    double stiffness, rest;
  };
  static constexpr auto fields = std::tuple{
      Field<Param>{"stiffness", &Param::stiffness, "energy/length^(2(Dim-1))", "k", not_negative},
      Field<Param>{"rest", &Param::rest, "length^(Dim-1)", "preferred perimeter p0", not_negative}};

  /// Of a facet; the sum over all of them is the perimeter.
  template <class Facet>
  static auto measure(const Facet& x) {
    return facet_measure(x);
  }
  template <class S>
  static S energy(const S& perimeter, const Param& p) {
    const S excess = perimeter - p.rest;
    return 0.5 * p.stiffness * excess * excess;
  }
};

}  // namespace supple
