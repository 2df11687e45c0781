#include "supple/experiment/frame.hpp"

#include "supple/model/links.hpp"

namespace supple {

Frame make_frame(const System<2>& system, const Evaluation<2>& evaluation) {
  const State<2>& s = system.state;
  const PairTable& pairs = system.pairs;
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
  for (int row = 0; row < pairs.size(); ++row) {
    if (evaluation.trial_state[row] == ContactState::open) continue;
    const PairForce<2>& p = evaluation.pair[row];
    const double* u = &evaluation.trial_history[static_cast<std::size_t>(row) * pairs.width];
    frame.contacts.push_back({pairs.first[row], pairs.second[row], evaluation.trial_state[row], u[0], u[pairs.width - 1],
                              p.elastic + p.viscous, p.tangential});
  }
  return frame;
}

Frame make_frame(const System<2>& system, const Evaluation<2>& evaluation, const std::vector<ContactRecord<2>>&, const Harmonic&) {
  const State<2>& s = system.state;
  Frame frame;
  frame.step = system.step;
  frame.time = system.time;
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

RunInfo make_run_info(const System<2>& system, const Units& units) {
  return {units, system.box, system.state.radius, system.state.mass, system.state.inertia, connected_particles(system)};
}

}  // namespace supple
