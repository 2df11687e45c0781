/// What is recorded of two particles of which one slides over the other.
#pragma once
#include "supple/experiment/observable.hpp"
#include "supple/experiment/sliding_pair.hpp"
#include "supple/observe/pair_friction.hpp"

namespace supple {

/// The pair at one place of its path, relaxed.
struct SlidingInstant {
  std::int64_t leg = 0;                   ///< which way over the lower particle, from 0
  double x = 0, x_in_widths = 0;          ///< x_bm, [length] and [D]
  MutualForce force;                      ///< on the upper particle
  double contact_energy = 0, energy = 0;  ///< energy: of shapes, contacts and springs
  double residual = 0;                    ///< largest net force on a vertex [force]
  double kinetic = 0;                     ///< kinetic energy [k_c sigma^2]
};

/// Evaluates the forces at the present state, with the springs of this place.
SlidingInstant look_at_pair(SlidingPair& pair, std::int64_t place);

/// The columns of the table "friction".
const Observables<SlidingInstant>& sliding_observables();

/// Records the results, from that table: extremes of mu_eff, where they are, and jumps. Where nothing touches
/// mu_eff is not defined; the table holds 0 there, and results leave it out, as they do where the force is
/// below SlidingPair::least_force. Warns where the particles touch
/// at no place, or at an end of the path.
void record_sliding(const SlidingPair& pair, Recorder& recorder);

}  // namespace supple
