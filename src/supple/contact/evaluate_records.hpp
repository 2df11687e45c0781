/// The reference path of contact forces: any detection, any law. Specialised loops are tested against it.
#pragma once
#include <algorithm>
#include <span>

#include "supple/contact/record.hpp"
#include "supple/model/evaluation.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// What a law answers: the force on the side of positive weight [force], the energy stored [energy], and the
/// new state.
template <int Dim>
struct ContactResponse {
  Vec<Dim> force{};
  double elastic_energy = 0, tangential_energy = 0;
  ContactState state = ContactState::stick;
};

/// What a law sees: the record, the velocity of the side of positive weight relative to the other, with and
/// without their spins [length/time], what the contact remembers, and the time `dt` over which these
/// velocities have acted since.
template <int Dim>
struct ContactMotion {
  const ContactRecord<Dim>& record;
  Vec<Dim> velocity, branch_velocity;
  ContactState state;
  std::span<const double> history;
  double dt;
};

/// Adds forces, torques, energies and virial of the records to `out`, and fills its trial state and history;
/// rows without a record open and forget. law(motion, new_history) returns a ContactResponse, fills
/// `new_history` and changes nothing else.
template <int Dim, class Law>
void evaluate_records(const System<Dim>& system, const std::vector<ContactRecord<Dim>>& records,
                      const Law& law, double dt, Evaluation<Dim>& out) {
  const PairTable& pairs = system.pairs;
  const auto width = static_cast<std::size_t>(pairs.width);
  out.trial_state.assign(pairs.state.size(), ContactState::open);
  out.trial_history.assign(pairs.history.size(), 0.0);
  for (const ContactRecord<Dim>& record : records) {
    const std::span old(pairs.history.data() + record.row * width, width);
    const std::span trial(out.trial_history.data() + record.row * width, width);
    const ContactMotion<Dim> motion{record,
                                    relative_velocity(record, system.state, system.box),
                                    branch_velocity(record, system.state, system.box),
                                    pairs.state[record.row],
                                    old,
                                    dt};
    const ContactResponse<Dim> response = law(motion, trial);
    out.trial_state[record.row] = response.state;
    scatter(record, response.force, out.force, out.torque);
    out.energy.elastic += response.elastic_energy;
    out.energy.tangential += response.tangential_energy;
    out.virial.add_outer(1, response.force, record.branch);
  }
}

}  // namespace supple
