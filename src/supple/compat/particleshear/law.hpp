/// Contact laws of the published package particleShear 1.0.2, quirk by quirk. Forces are per metre of depth.
/// The functions have no branches, so that a loop over contacts becomes vector instructions.
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

namespace supple {

/// How a compressed contact repels: by the divergent law at its distance, or at a distance mapped through a
/// plateau.
enum class ParticleShearElastic { divergent, plateau };
/// How a stretched link pulls.
enum class ParticleShearTensile { linear, saturating };

/// Constants of all contacts. Free contacts have k, nu, k_t, nu_t; permanent links have these times the
/// ratios (viscosities only where they are not kept constant).
struct ParticleShearConstants {
  double k = 1;                              ///< central spring [mass / time^2]
  double nu = 0;                             ///< central viscosity [mass / time]
  double k_t = 1;                            ///< tangential spring [mass / time^2]
  double nu_t = 0;                           ///< tangential viscosity [mass / time]
  double mu = 0;                             ///< friction coefficient
  double central_repulsion_coefficient = 1;  ///< 1: divergent (S1-5b), 0: linear (S1-5a)
  double permanent_ratio_central = 1, permanent_ratio_tangential = 1;
  bool keep_viscosity_coefficients_constant = false;
  ParticleShearElastic elastic = ParticleShearElastic::divergent;
  ParticleShearTensile tensile = ParticleShearTensile::linear;
  double plateau_begin = 0.3, plateau_end = 0.8,
         plateau_slope = 0.1;  ///< shares of d0; slope relative to no plateau
  double tensile_range = 0.2;  ///< strain over which saturating tension nears its limit by a factor e
};

namespace particleshear {

/// Repulsion [force] at the distance d, d0 = r_i + r_j: k (1 - c) (d0 - d) + k c d0 (d0/d - 1) (S1-5a,
/// S1-5b). Below d0/1000 the second part stays constant, so that it is at most 999 k c d0.
inline double divergent_repulsion(double d, double d0, const ParticleShearConstants& c) {
  const double share = c.central_repulsion_coefficient;
  const double linear = c.k * (1 - share) * (d0 - d);
  const double divergent = c.k * share * d0 * (d0 / std::max(d, 1e-3 * d0) - 1);
  return d > d0 ? 0.0 : linear + divergent;
}

/// The distance at which the plateau law takes the divergent law: its slope is reduced between begin and end.
inline double plateau_distance(double d, double d0, const ParticleShearConstants& c) {
  const double begin = c.plateau_begin * d0, end = c.plateau_end * d0;
  const double plateau = end + (d - end) * c.plateau_slope;
  const double core = d / begin * (end + (begin - end) * c.plateau_slope);
  return d >= end ? d : d >= begin ? plateau : core;
}

template <ParticleShearElastic law>
double repulsion(double d, double d0, const ParticleShearConstants& c) {
  if constexpr (law == ParticleShearElastic::divergent) return divergent_repulsion(d, d0, c);
  else return divergent_repulsion(plateau_distance(d, d0, c), d0, c);
}

/// Tension [force] of a link stretched to d: k (d - d0), or k d0 D (1 - exp(-(d - d0) / (d0 D))), D =
/// tensile_range.
template <ParticleShearTensile law>
double tension(double d, double d0, const ParticleShearConstants& c) {
  if constexpr (law == ParticleShearTensile::linear) return c.k * (d - d0);
  else return c.k * (1 - std::exp(-(d - d0) / d0 / c.tensile_range)) * d0 * c.tensile_range;
}

/// The force, its magnitude cut to the limit.
inline double limited(double force, double limit) {
  return std::copysign(std::min(std::abs(force), limit), force);
}

/// Coefficients of the forces of free contacts, or of links.
struct Coefficients {
  double ratio, nu, k_t, nu_t;
};
inline Coefficients free_coefficients(const ParticleShearConstants& c) { return {1, c.nu, c.k_t, c.nu_t}; }
inline Coefficients link_coefficients(const ParticleShearConstants& c) {
  const bool keep = c.keep_viscosity_coefficients_constant;
  return {c.permanent_ratio_central, c.nu * (keep ? 1 : c.permanent_ratio_central),
          c.k_t * c.permanent_ratio_tangential, c.nu_t * (keep ? 1 : c.permanent_ratio_tangential)};
}

/// A contact at one instant: speed of separation v_n, tangential speed v_t = (v_j - v_i).t - (r_i w_i + r_j
/// w_j) with the radii as lever arms, and the elongations that the first partner keeps toward the second and
/// the second toward the first.
struct Contact {
  double distance, d0, v_n, v_t;
  double elongation, elongation_back;
};

/// Forces of a contact, with signs as in PairForce, and the elongations that its partners remember. slips: 1
/// if it slips, else 0.
struct Force {
  double elastic, viscous, tangential;
  double elongation, elongation_back;
  double slips;
};

/// Central and tangential forces of a contact that touches or is linked. Each partner visits the contact
/// once, and applies half of the tangential force of its own elongation to both. A visit that slips sets both
/// elongations to zero, so that the second visit in the same step often sticks: sliding in the package is a
/// saw-tooth at about half the Coulomb limit. A stretched link has no tangential viscosity.
template <ParticleShearElastic elastic_law, ParticleShearTensile tensile_law>
inline Force contact_force(const Contact& x, bool permanent, const ParticleShearConstants& c,
                           const Coefficients& free, const Coefficients& link) {
  const double compressed = repulsion<elastic_law>(x.distance, x.d0, c);
  const double stretched = -tension<tensile_law>(x.distance, x.d0, c);
  const double limit = permanent ? std::numeric_limits<double>::infinity() : compressed * c.mu;

  const double k_t = permanent ? link.k_t : free.k_t;
  const double viscous = (permanent ? link.nu_t : free.nu_t) * x.v_t * (x.distance < x.d0 ? 1.0 : 0.0);
  const double first = k_t * x.elongation + viscous;
  const double first_sticks = std::abs(first) > limit ? 0.0 : 1.0;
  const double second = k_t * (first_sticks * x.elongation_back) + viscous;
  const double second_sticks = std::abs(second) > limit ? 0.0 : 1.0;

  Force f;
  f.elastic = (permanent ? link.ratio : free.ratio) * (x.distance < x.d0 ? compressed : stretched);
  f.viscous = -(permanent ? link.nu : free.nu) * x.v_n;
  f.tangential = 0.5 * limited(first, limit) + 0.5 * limited(second, limit);
  f.elongation = first_sticks * second_sticks * x.elongation;
  f.elongation_back = first_sticks * second_sticks * x.elongation_back;
  f.slips = 1 - second_sticks;
  return f;
}

}  // namespace particleshear
}  // namespace supple
