#pragma once
#include <string_view>
#include <tuple>

#include "supple/core/field.hpp"
#include "supple/core/jet.hpp"
#include "supple/core/vec.hpp"

namespace supple {

/// A spring between two sites at the distance r, as of the networks that fill elastic discs and balls
/// [MacKeith 2025, section 9.3.4]:
///     E = (k/2) (r - r0)^2,   k [energy/length^2],  r0 [length].
/// Where the sites coincide the spring has no direction: it has its energy there, and pulls nowhere.
template <int Dim>
struct BondStretch {
  static constexpr std::string_view name = "bond_stretch";
  static constexpr int arity = 2;
  struct Param {
    double stiffness, rest;
  };
  static constexpr auto fields =
      std::tuple{Field<Param>{"stiffness", &Param::stiffness, "energy/length^2", "k", not_negative},
                 Field<Param>{"rest", &Param::rest, "length", "rest length r0", not_negative}};

  template <class S>
  static S energy(const VecOf<S, Dim> (&x)[arity], const Param& p) {
    using std::sqrt;
    const VecOf<S, Dim> r = x[1] - x[0];
    const S square = dot(r, r);
    // The cusp -k r0 r has no derivative at r = 0: it is left out there.
    if (value_of(square) == 0) return 0.5 * p.stiffness * (square + p.rest * p.rest);
    const S stretch = sqrt(square) - p.rest;
    return 0.5 * p.stiffness * stretch * stretch;
  }

  static double gradient(const Vec<Dim> (&x)[arity], const Param& p, Vec<Dim> (&g)[arity]) {
    const Vec<Dim> r = x[1] - x[0];
    const double square = dot(r, r), length = std::sqrt(square), stretch = length - p.rest;
    const double slope = square > 0 ? p.stiffness * stretch / length : 0;
    g[1] = slope * r;
    g[0] = -g[1];
    return 0.5 * p.stiffness * stretch * stretch;
  }
};

}  // namespace supple
