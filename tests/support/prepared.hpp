/// Prepared suspensions for physics tests: relaxed, crosslinked, between plates, as a case asks.
#pragma once
#include <cmath>
#include <memory>

#include "supple/experiment/microgel.hpp"
#include "supple/experiment/protocol.hpp"
#include "supple/experiment/suspension.hpp"

namespace supple::testing {

inline Suspension prepared_suspension(const Case& c) {
  MemoryRecorder recorder;
  return make_suspension(c, nullptr, recorder);
}

/// A fresh stepper of the documented model for the discs of this case, its plates in place.
inline std::unique_ptr<Mover<2>> documented_dynamics(const Case& c) {
  std::unique_ptr<Mover<2>> dynamics = make_dynamics(c, derive_constants(c, nullptr));
  dynamics->set_plates(plates_of(c));
  return dynamics;
}

/// One cycle of the case's amplitude and frequency in this many steps, without rests.
inline OscillatoryProtocol one_cycle(const Case& c, int steps) {
  return {c.shear.amplitude, derive_constants(c, nullptr).frequency, steps, 0, steps, 0};
}

/// Damping factor per step that gives cool_factor per cycle.
inline double damping(const Case& c, int steps_per_cycle) {
  return std::pow(c.shear.cool_factor, 1.0 / steps_per_cycle);
}

}  // namespace supple::testing
