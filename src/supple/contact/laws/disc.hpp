/// The contact law of microgel discs: elastic, viscous and tangential parts, for contacts and permanent
/// links.
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

#include "supple/contact/laws/elastic.hpp"
#include "supple/contact/laws/friction.hpp"

namespace supple {

/// Lever arms of spins in the tangential speed. distance: d r_i/(r_i + r_j), as in the torques (S1-3), so
/// that the work of a contact closes and a rigid rotation winds nothing up. radius: r_i, as in the published
/// package.
enum class LeverArm { distance, radius };

/// Stiffness [force/length] and viscosity [force/speed] of one kind of pair, central and tangential.
struct PairStiffness {
  double k = 0, eta = 0, k_t = 0, eta_t = 0;
};

/// Parameters that all pairs share. Stiffnesses of `contact` and `link` differ by the interface
/// re-enforcement.
struct DiscLaw {
  PairStiffness contact, link;
  Tensile tension;
  double friction = 0;
  Slip slip = Slip::clamp;
  LeverArm lever_arm = LeverArm::distance;
};

/// The relative motion of two discs: distance d, d0 = r_i + r_j [length]; of this instant speed of separation
/// v_n = v_rel.n, and tangential speed v_t with the lever arms of the law [length/time]; and the tangential
/// way `slid` over the step that ends here [length].
struct PairMotion {
  double d, d0, v_n, v_t, slid;
};

/// The tangential way over a straight step of the centres that ends at the distance d, dt long. Relative
/// velocity of the centres (along n, along t) and the speed at which the rims roll, sum r w times the arm
/// over the radius at the distance d0, are of the middle of the step. There the direction of the contact is
/// that of d n - (dt/2) v, along which v is v_t d over the distance there.
inline double way_slid(double d, double d0, double v_n, double v_t, double rolling, LeverArm arm, double dt) {
  const double x = d - 0.5 * dt * v_n, y = 0.5 * dt * v_t;
  const double d_then = std::max(std::sqrt(x * x + y * y), std::numeric_limits<double>::min());
  return dt * (v_t * d / d_then - (arm == LeverArm::distance ? d_then / d0 : 1) * rolling);
}

/// Forces of a contact [force]: elastic and viscous, positive where they repel; tangential, on the first disc
/// along t = (-n_y, n_x).
struct DiscResponse {
  double elastic, viscous;
  TangentialResponse tangential;
};

/// Forces of a touching pair (d < range d0): elastic force, viscosity, and friction with the Coulomb limit mu
/// F_el, of which a pair that pulls has none. u is the elongation at the step before [length], `slip` the
/// rule of law.slip.
template <class Repulsion>
DiscResponse respond_contact(const Repulsion& repulsion, const DiscLaw& law, const SlipRule& slip,
                             const PairMotion& m, double u) {
  const PairStiffness& s = law.contact;
  const double elastic = repulsion.force(m.d, m.d0, s.k);
  return {elastic, -s.eta * m.v_n,
          coulomb(u, m.slid, m.v_t, s.k_t, s.eta_t, std::max(law.friction * elastic, 0.0), slip)};
}

template <class Repulsion>
DiscResponse respond_contact(const Repulsion& repulsion, const DiscLaw& law, const PairMotion& m, double u) {
  return respond_contact(repulsion, law, SlipRule(law.slip, law.contact.k_t), m, u);
}

/// Forces of a permanent link at any distance: repulsion when compressed, tension when stretched, no Coulomb
/// limit.
template <class Repulsion>
DiscResponse respond_link(const Repulsion& repulsion, const DiscLaw& law, const PairMotion& m, double u) {
  const PairStiffness& s = law.link;
  const double elastic = m.d < m.d0 ? repulsion.force(m.d, m.d0, s.k) : law.tension.force(m.d, m.d0, s.k);
  return {elastic, -s.eta * m.v_n, bonded(u, m.slid, m.v_t, s.k_t, s.eta_t)};
}

/// Elastic energy of a contact or link [energy]: the integral of DiscResponse::elastic over the distance.
template <class Repulsion>
double elastic_energy(const Repulsion& repulsion, const DiscLaw& law, double d, double d0, bool linked) {
  const double k = linked ? law.link.k : law.contact.k;
  if (linked && !(d < d0)) return law.tension.energy(d, d0, k);
  const double rest =
      linked && range_of(repulsion) > 1 ? repulsion.energy(d0, d0, k) : 0;  // a link has no well
  return repulsion.energy(d, d0, k) - rest;
}

}  // namespace supple
