#include "supple/experiment/frame.hpp"

#include <algorithm>
#include <utility>

#include "supple/model/links.hpp"
#include "supple/observe/contact_network.hpp"

namespace supple {

namespace {

/// All but the contacts and the numbers of bodies.
Frame frame_of_sites(const System<2>& system, const Evaluation<2>& evaluation) {
  const State<2>& s = system.state;
  Frame frame;
  frame.step = system.step;
  frame.time = system.time;
  frame.strain = system.box.strain;
  frame.strain_rate = system.box.strain_rate;
  frame.position = s.position;
  frame.velocity = s.velocity;
  frame.force = evaluation.force;
  frame.angle = s.angle;
  frame.spin = s.spin;
  frame.torque = evaluation.torque;
  frame.mobility = s.mobility;
  frame.length = system.box.length;
  return frame;
}

}  // namespace

Frame make_frame(const System<2>& system, const Evaluation<2>& evaluation) {
  const PairTable& pairs = system.pairs;
  Frame frame = frame_of_sites(system, evaluation);
  for (int row = 0; row < pairs.size(); ++row) {
    if (evaluation.trial_state[row] == ContactState::open) continue;
    const PairForce<2>& p = evaluation.pair[row];
    const double* u = &evaluation.trial_history[static_cast<std::size_t>(row) * pairs.width];
    frame.contacts.push_back({pairs.first[row], pairs.second[row], evaluation.trial_state[row], u[0],
                              u[pairs.width - 1], p.elastic + p.viscous, p.tangential});
  }
  return frame;
}

Frame make_frame(const System<2>& system, const Evaluation<2>& evaluation, const std::vector<ContactRecord<2>>& records,
                 const Harmonic& law) {
  Frame frame = frame_of_sites(system, evaluation);
  std::vector<ContactRow>& rows = frame.contacts;
  for (const SiteContact& c : site_contacts(system, records, law))
    rows.push_back(
        {std::min(c.site, c.other), std::max(c.site, c.other), ContactState::slip, 0, 0, c.normal_force(), 0});
  const auto pair = [](const ContactRow& row) { return std::pair(row.first, row.second); };
  std::stable_sort(rows.begin(), rows.end(), [&](const auto& a, const auto& b) { return pair(a) < pair(b); });
  std::size_t kept = 0;
  for (std::size_t k = 1; k < rows.size(); ++k)
    if (pair(rows[k]) == pair(rows[kept])) rows[kept].normal_force += rows[k].normal_force;
    else rows[++kept] = rows[k];
  if (!rows.empty()) rows.resize(kept + 1);
  return frame;
}

RunInfo make_run_info(const System<2>& system, const Units& units) {
  const State<2>& s = system.state;
  const std::vector<std::int32_t>& begin = system.topology.begin;
  return {units,  system.box, s.radius,
          s.mass, s.inertia,  begin.empty() ? connected_particles(system, LinkKind::all) : bodies_of_sites(system.topology, s.size()),
          begin};
}

}  // namespace supple
