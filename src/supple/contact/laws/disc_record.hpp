/// The law of microgel discs on contact records, in 2D.
#pragma once
#include "supple/contact/evaluate_records.hpp"
#include "supple/contact/laws/disc.hpp"

namespace supple {

/// The response of `law` with this repulsion at a record. The velocity of a record comes from its arms, as
/// with LeverArm::distance; LeverArm::radius, whose forces have another power, exists only in DiscContacts.
template <class Repulsion>
ContactResponse<2> respond(const Repulsion& repulsion, const DiscLaw& law, const ContactMotion<2>& motion,
                           std::span<double> new_history) {
  const ContactRecord<2>& record = motion.record;
  const Vec2 n = record.normal, t = turned_left(n);
  const double u = motion.history[0];
  const double d = record.distance(), v_t = dot(motion.branch_velocity, t);
  const double rolling = (v_t - dot(motion.velocity, t)) * record.reach / d;  // with arms in proportion to d
  const PairMotion m{
      d, record.reach, dot(motion.velocity, n), dot(motion.velocity, t),
      way_slid(d, record.reach, dot(motion.velocity, n), v_t, rolling, LeverArm::distance, motion.dt)};
  const bool linked = motion.state == ContactState::permanent;
  const DiscResponse r = linked ? respond_link(repulsion, law, m, u) : respond_contact(repulsion, law, m, u);
  new_history[0] = r.tangential.elongation;
  // The tangential force of the law is on the first disc, which has negative weight.
  return {
      (r.elastic + r.viscous) * n - r.tangential.force * t, elastic_energy(repulsion, law, m.d, m.d0, linked),
      0.5 * (linked ? law.link.k_t : law.contact.k_t) * new_history[0] * new_history[0], r.tangential.state};
}

}  // namespace supple
