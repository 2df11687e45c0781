/// The two constants of an isotropic elastic material, in two forms.
#pragma once
#include "supple/core/require.hpp"

namespace supple {

/// Young's modulus E [energy/length^Dim] and Poisson's ratio nu: a bar under tension s along its axis
/// lengthens by s/E and becomes thinner by nu s/E. In 2D they are those of the sheet, where no third
/// direction takes part.
struct ElasticConstants {
  double young_modulus, poisson_ratio;
};

/// Lame's constants [energy/length^Dim]: stress = lambda tr(eps) I + 2 mu eps for small strains eps.
struct LameConstants {
  double lambda, mu;
};

/// Largest Poisson's ratio, which the material only nears, as its area (volume) can then not change: 1 in 2D,
/// 1/2 in 3D.
template <int Dim>
inline constexpr double largest_poisson_ratio = 1.0 / (Dim - 1);

/// Lame's constants from E and nu [Landau and Lifshitz, Theory of Elasticity, eq. 5.8 for 3D]:
///     lambda = E nu/((1 + nu)(1 - (Dim - 1) nu)),   mu = E/(2 (1 + nu)).
/// Input error unless E > 0 and -1 < nu < 1/(Dim - 1): no other material resists every strain.
template <int Dim>
LameConstants lame_constants(const ElasticConstants& c) {
  const auto [E, nu] = c;
  require(E > 0 && E <= 1e300, "Young's modulus", E, "a positive number");
  require(nu > -1 && nu < largest_poisson_ratio<Dim>, "Poisson's ratio", nu,
          Dim == 2 ? "a number between -1 and 1 (of a sheet)" : "a number between -1 and 0.5");
  return {E * nu / ((1 + nu) * (1 - (Dim - 1) * nu)), E / (2 * (1 + nu))};
}

/// E and nu from Lame's constants: in 3D nu = lambda/(2 (lambda + mu)), in 2D nu = lambda/(lambda + 2 mu) and
/// E = 4 mu (lambda + mu)/(lambda + 2 mu); in both E = 2 mu (1 + nu). Input error unless the shear modulus mu
/// and the bulk modulus lambda + 2 mu/Dim are positive.
template <int Dim>
ElasticConstants elastic_constants(const LameConstants& c) {
  const auto [lambda, mu] = c;
  require(mu > 0 && mu <= 1e300, "the shear modulus mu", mu, "a positive number");
  require(lambda + 2 * mu / Dim > 0 && lambda <= 1e300, "the bulk modulus lambda + 2 mu/Dim",
          lambda + 2 * mu / Dim, "a positive number");
  const double nu = lambda / ((Dim - 1) * lambda + 2 * mu);
  return {2 * mu * (1 + nu), nu};
}

/// The constants of a network of springs that follow a uniform strain and point in all directions alike, by S
/// = sum k r0^2/V [energy/length^Dim]: lambda = mu = S/(Dim (Dim + 2)) [Born and Huang 1954], so that E = S/3
/// and nu = 1/3 in 2D, S/6 and 1/4 in 3D. Input error unless S is positive.
template <int Dim>
ElasticConstants affine_constants(double springs_per_volume) {
  const double mu = springs_per_volume / (Dim * (Dim + 2));
  return elastic_constants<Dim>(LameConstants{mu, mu});
}

}  // namespace supple
