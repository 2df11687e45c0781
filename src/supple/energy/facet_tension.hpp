#pragma once
#include <string_view>
#include <tuple>

#include "supple/core/field.hpp"
#include "supple/geometry/facet.hpp"

namespace supple {

/// Line tension of an edge of length a in 2D, surface tension of a triangle of area a in 3D [MacKeith 2025,
/// eq. 9.1-9.2]:
///     E = gamma a,   gamma [energy / length^(Dim-1)].
template <int Dim>
struct FacetTension {
  static constexpr std::string_view name = "facet_tension";
  static constexpr int arity = Dim;
  struct Param {
    double tension;
  };
  static constexpr auto fields =
      std::tuple{Field<Param>{"tension", &Param::tension, "energy/length^(Dim-1)", "gamma", not_negative}};

  template <class S>
  static S energy(const VecOf<S, Dim> (&x)[arity], const Param& p) {
    return p.tension * facet_measure(x);
  }
};

}  // namespace supple
