#include "supple/contact/touch_friction.hpp"

#include <algorithm>
#include <span>

#include "supple/contact/linked_touches.hpp"

namespace supple {

namespace {

/// Where the sides of a record are at an instant.
struct RecordPlace {
  Vec2 branch, normal;
};

RecordPlace place_of(const ContactRecord<2>& record, const System<2>& system, const Instant& at) {
  if (at.back == 0) return {record.branch, record.normal};
  const Vec2 branch = record.branch - at.back * relative_velocity(record, system.state, system.box);
  const bool edge = record.sites == 3;
  // The normal of an edge is on its right; a site inside is behind the corner that it feels.
  const Vec2 along = edge ? -turned_left(at.edge(record.site[1], record.site[2]))
                          : (record.distance() < 0 ? -1.0 : 1.0) * branch;
  const double length = norm(along);
  return {branch, length > 0 ? (1 / length) * along : record.normal};
}

double share_of(const ContactRecord<2>& record, const ContactLaws& laws) {
  return record.multiplicity * laws.of(record.species).force(record.distance(), record.reach);
}

/// Fills the frame of a touch from its records. The share of each one is its part of the elastic force at
/// present, also at an earlier instant: the two sides are then the same points of the boundaries.
void fill(TouchFrame& frame, const System<2>& system, std::span<const ContactRecord<2>> records,
          const ContactLaws& laws, const BodyTouch<2>& touch, const std::vector<std::int32_t>& body,
          const Instant& at) {
  const auto ring = [&](std::int32_t site) { return ring_of(system.topology, body[site]); };
  frame.clear();
  const double per_force = 1 / touch.normal_force();
  const Vec2 n = per_force * touch.force;
  const ContactRecord<2>& any = records.front();
  const int own = any.weight[0] > 0 ? 0 : 1;
  const double share_i = system.state.radius[any.site[own]] / any.reach;
  frame.up = any.up;
  frame.jump = system.box.velocity_jump(any.up);
  for (const ContactRecord<2>& record : records) {
    const double part = share_of(record, laws), share = per_force * part * dot(record.normal, n);
    const RecordPlace place = place_of(record, system, at);
    for (int k = 0; k < record.sites; ++k) frame.sites.push_back({record.site[k], share * record.weight[k]});
    frame.branch += share * place.branch;
    frame.normal += part * place.normal;
    const double share_j = (1 - share_i) * share;
    if (record.sites == 3) frame.rotation.add_edge(share_j, record.site[1], record.site[2], at);
    else frame.rotation.add_vertex(share_j, ring(record.site[1 - own]), record.site[1 - own], at);
  }
  frame.rotation.add_vertex(share_i, ring(any.site[own]), any.site[own], at);
  const double length = norm(frame.normal);
  const double to_unit = per_force < 0 ? -1 / length : 1 / length;
  frame.normal = length > 0 ? to_unit * frame.normal : n;
}

}  // namespace

TouchKey TouchFriction::key_of(const ContactRecord<2>& record, Meeting meeting) const {
  const int own = record.weight[0] > 0 ? 0 : 1;
  const std::int32_t other = record.site[1 - own];
  const Vec2 cells{static_cast<double>(record.cells[0]), static_cast<double>(record.cells[1])};
  if (meeting == Meeting::facets) return touch_key(record.site[own], TouchOn::body, body_[other], cells);
  return touch_key(record.site[own], TouchOn::site, other, cells);
}

void TouchFriction::evaluate(const System<2>& system, BodyContacts<2>& contacts, double dt, Detail detail,
                             Evaluation<2>& out) {
  body_ = bodies_of_sites(system.topology, system.state.size());
  records_ = contacts.records(system);
  out.trial_touch.clear();
  out.touch_force.clear();
  lossy_.clear();
  for (const BodyTouch<2>& touch : sum_touches(system, records_, contacts.laws()))
    if (norm(touch.force) > 0) act(system, contacts, touch, dt, detail, out);
  std::sort(out.trial_touch.begin(), out.trial_touch.end(),
            [](const Touch& a, const Touch& b) { return a.key < b.key; });
  if (detail == Detail::energies && dt > 0) book_opened(system, contacts, dt, out);
}

void TouchFriction::act(const System<2>& system, const BodyContacts<2>& contacts, const BodyTouch<2>& touch,
                        double dt, Detail detail, Evaluation<2>& out) {
  const std::span records(records_.data() + touch.first_record, static_cast<std::size_t>(touch.records));
  const Instant now{system.state}, then{system.state, 0.5 * dt};
  fill(frame_, system, records, contacts.laws(), touch, body_, now);
  if (dt > 0) fill(earlier_, system, records, contacts.laws(), touch, body_, then);
  const TouchFrame& moved = dt > 0 ? earlier_ : frame_;
  const Vec2 v = moved.velocity(then), n = frame_.normal;
  const double slid = dt * dot(v, turned_left(moved.normal));
  const TouchMotion motion = present_motion_of(frame_, moved, v, system, out.now);

  const TouchKey key = key_of(records.front(), contacts.meeting());
  const std::array<std::int32_t, 2> pair = records.front().species;
  const TouchLaw& law = laws_.of(pair);
  const Touch* known = system.touches.find(key);
  // A spring acts on its sites with the square of their weights: never stiffer than it is.
  const double u = known ? known->elongation : 0,
               leverage = frame_.leverage(contacts.laws().of(pair).range() * records.front().reach),
               scale = scale_of(system, contacts, key.site) / (leverage * leverage);
  const TouchResponse r = respond_touch(law, scale, touch.normal_force(), motion, slid, u);
  out.trial_touch.push_back({key, r.tangential.state, r.tangential.elongation});
  const Mat2 before = out.virial;
  frame_.scatter(r.viscous * n - r.tangential.force * turned_left(n), system.state, out);
  out.touch_force.push_back({key, r.viscous, r.tangential.force, out.virial + -1.0 * before});

  if (detail != Detail::energies) return;
  const double k_t = scale * law.k_t, dashpot = r.tangential.force - k_t * r.tangential.elongation;
  const bool freely = r.tangential.state == ContactState::slip && law.slip != Slip::clamp;
  lossy_.push_back({frame_, r.viscous, freely ? 0 : dashpot, freely ? dashpot : 0});
  const TouchMotion booked = booked_motion(frame_, now, motion, out.now);
  const TangentialBooks books = book(r.tangential, u, slid, booked.v_t, dt, k_t, law.slip);
  out.energy.tangential += books.energy;
  out.energy.tangential_viscous_power += books.viscous_power;
  out.energy.sliding_power += books.sliding_power;
  out.energy.viscous_power -= r.viscous * booked.v_n;
}

/// A spring that is still wound up when its contact opens is lost to friction.
void TouchFriction::book_opened(const System<2>& system, const BodyContacts<2>& contacts, double dt,
                                Evaluation<2>& out) const {
  auto held = out.trial_touch.begin();
  for (const Touch& old : system.touches.rows) {
    while (held != out.trial_touch.end() && held->key < old.key) ++held;
    if (held != out.trial_touch.end() && held->key == old.key) continue;
    const TouchLaw& law =
        laws_.of(system.species_of(body_[old.key.site]), system.species_of(body_of_other(old.key, body_)));
    const double k_t = scale_of(system, contacts, old.key.site) * law.k_t;
    out.energy.sliding_power += 0.5 * k_t * old.elongation * old.elongation / dt;
  }
}

}  // namespace supple
