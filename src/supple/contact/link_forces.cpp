#include "supple/contact/link_forces.hpp"

#include "supple/contact/coincident.hpp"
#include "supple/model/body_links.hpp"

namespace supple {

/// The positive side is the second site.
void LinkForces::fill(TouchFrame& frame, const System<2>& system, const Link& link, const Instant& at) const {
  const State<2>& state = system.state;
  const std::int32_t i = link.first, j = link.second;
  frame.clear();
  frame.sites = {{i, -1}, {j, +1}};
  frame.up = link.cells[gradient];
  frame.jump = system.box.velocity_jump(frame.up);
  frame.branch = link_vector(system, link) - at.back * frame.separation_velocity(at);
  const double d = norm(frame.branch);
  frame.normal = d > 0 ? (1 / d) * frame.branch : arbitrary_direction<2>(i, j);
  const double share = state.radius[i] / (state.radius[i] + state.radius[j]);
  frame.rotation.add_vertex(share, ring_of(system.topology, body_[i]), i, at);
  frame.rotation.add_vertex(1 - share, ring_of(system.topology, body_[j]), j, at);
}

void LinkForces::evaluate(const System<2>& system, BodyContacts<2>&, double dt, Detail detail,
                          Evaluation<2>& out) {
  out.trial_link.clear();
  out.link_force.clear();
  lossy_.clear();
  if (system.links.empty()) return;
  body_ = bodies_of_sites(system.topology, system.state.size());
  const Instant now{system.state}, then{system.state, 0.5 * dt};
  for (const Link& link : system.links) {
    fill(frame_, system, link, now);
    if (dt > 0) fill(earlier_, system, link, then);
    const TouchFrame& moved = dt > 0 ? earlier_ : frame_;
    const LinkLaw& law =
        laws_.of(system.species_of(body_[link.first]), system.species_of(body_[link.second]));
    const Vec2 v = moved.velocity(then), n = frame_.normal;
    const double slid = dt * dot(v, turned_left(moved.normal)), d = norm(frame_.branch);
    const TouchMotion motion = present_motion_of(frame_, moved, v, system, out.now);

    const TangentialResponse r = bonded(link.elongation, slid, motion.v_t, law.k_t, law.eta_t);
    const double elastic = law.force(d, link.rest), viscous = -law.eta * motion.v_n,
                 central = elastic + viscous;
    out.trial_link.push_back(r.elongation);
    const Mat2 before = out.virial;
    frame_.scatter(central * n - r.force * turned_left(n), system.state, out);
    out.link_force.push_back({elastic, viscous, r.force, out.virial + -1.0 * before});

    if (detail != Detail::energies) continue;
    lossy_.push_back({frame_, viscous, r.force - law.k_t * r.elongation, 0});
    const TouchMotion booked = booked_motion(frame_, now, motion, out.now);
    const TangentialBooks books = book(r, link.elongation, slid, booked.v_t, dt, law.k_t, Slip::clamp);
    out.energy.elastic += law.energy(d, link.rest);
    out.energy.tangential += books.energy;
    out.energy.viscous_power -= viscous * booked.v_n;
    out.energy.tangential_viscous_power += books.viscous_power;
  }
}

void LinkForces::commit(System<2>& system, Evaluation<2>& evaluation) {
  for (std::size_t k = 0; k < evaluation.trial_link.size(); ++k)
    system.links[k].elongation = evaluation.trial_link[k];
}

}  // namespace supple
