#pragma once
#include <string_view>
#include <tuple>

#include "supple/core/field.hpp"
#include "supple/geometry/facet.hpp"

namespace supple {

/// Enclosed area in 2D, volume in 3D [MacKeith 2025, eq. 9.1-9.2]:
///     E = (k/2) (v - v0)^2,   k [energy / length^(2 Dim)],  v0 [length^Dim].
/// A term of a whole body: a function of the area or volume v that the facets of its closed boundary enclose.
struct EnclosedVolume {
  static constexpr std::string_view name = "enclosed_volume";
  struct Param {
    double stiffness, rest;
  };
  static constexpr auto fields =
      std::tuple{Field<Param>{"stiffness", &Param::stiffness, "energy/length^(2 Dim)", "k", not_negative},
                 Field<Param>{"rest", &Param::rest, "length^Dim", "rest volume v0", not_negative}};

  /// Of a facet; the sum over those of a closed boundary is the volume.
  template <class Facet>
  static auto measure(const Facet& x) {
    return facet_volume(x);
  }
  template <class S>
  static S energy(const S& volume, const Param& p) {
    const S excess = volume - p.rest;
    return 0.5 * p.stiffness * excess * excess;
  }
};

}  // namespace supple
