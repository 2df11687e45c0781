#pragma once
#include <string_view>
#include <tuple>

#include "supple/core/field.hpp"
#include "supple/geometry/facet.hpp"

namespace supple {

/// Stretching of a facet, of an edge of length a in 2D or a triangle of area a in 3D [MacKeith 2025, eq.
/// 9.1-9.2]:
///     E = (k/2) (a - a0)^2,   k [energy / length^(2(Dim-1))],  a0 [length^(Dim-1)].
template <int Dim>
struct FacetStretch {
  static constexpr std::string_view name = "facet_stretch";
  static constexpr int arity = Dim;
  struct Param {
    double stiffness, rest;
  };
  static constexpr auto fields =
      std::tuple{Field<Param>{"stiffness", &Param::stiffness, "energy/length^(2(Dim-1))", "k", not_negative},
                 Field<Param>{"rest", &Param::rest, "length^(Dim-1)", "rest measure a0", not_negative}};

  template <class S>
  static S energy(const VecOf<S, Dim> (&x)[arity], const Param& p) {
    const S stretch = facet_measure(x) - p.rest;
    return 0.5 * p.stiffness * stretch * stretch;
  }
};

}  // namespace supple
