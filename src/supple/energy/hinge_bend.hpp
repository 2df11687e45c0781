#pragma once
#include <string_view>
#include <tuple>

#include "supple/core/field.hpp"
#include "supple/geometry/hinge.hpp"

namespace supple {

/// Bending of a hinge [MacKeith 2025, eq. 9.1-9.2]:
///     E = (k/2) (theta - theta0)^2,   k [energy], theta the exterior angle [radian], 0 where flat.
template <int Dim>
struct HingeBend {
  static constexpr std::string_view name = "hinge_bend";
  static constexpr int arity = Dim + 1;
  struct Param {
    double stiffness, rest;
  };
  static constexpr auto fields =
      std::tuple{Field<Param>{"stiffness", &Param::stiffness, "energy", "k", not_negative},
                 Field<Param>{"rest", &Param::rest, "radian", "rest angle theta0"}};

  template <class S>
  static S energy(const VecOf<S, Dim> (&x)[arity], const Param& p) {
    const S turn = hinge_angle(x) - p.rest;
    return 0.5 * p.stiffness * turn * turn;
  }
};

}  // namespace supple
