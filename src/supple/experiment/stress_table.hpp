/// The table "stress": one row per step, at the instant of the forces.
#pragma once
#include <vector>

#include "supple/experiment/initial_state.hpp"
#include "supple/experiment/recorder.hpp"
#include "supple/model/units.hpp"
#include "supple/observe/jump_correction.hpp"

namespace supple {

/// Declares and fills the table; stresses in Pa, times in s. Keeps the series that demodulation needs.
class StressTable {
 public:
  /// With `tensors`, columns are every component of every tensor, else the shear stresses alone; with plate
  /// discs, also the stress of the plates. The corrected external stress goes on from that of `initial`.
  StressTable(Recorder& recorder, const Units& units, bool tensors, const System<2>& system,
              const InitialState* initial);
  /// Adds a row. The strain rate is that of this instant [1/time]; the box of a leapfrog has that of the step
  /// before.
  void append(const System<2>& system, const Evaluation<2>& evaluation, double strain_rate);

  /// Hands over the final state, at the instant of the last row or one step later, and what a continuation of
  /// this table needs.
  void finish(const System<2>& system, const Evaluation<2>& evaluation);

  const std::vector<double>& time() const { return time_; }
  const std::vector<double>& internal() const { return internal_; }
  const std::vector<double>& external() const { return external_; }
  const std::vector<double>& external_corrected() const { return external_corrected_; }
  const std::vector<double>& periodic() const { return periodic_; }
  const std::vector<double>& virial() const { return virial_; }
  /// Empty without plates.
  const std::vector<double>& plates() const { return plates_; }
  const std::vector<double>& pressure() const { return pressure_; }
  /// Largest |sum of jumps| that was taken out of external_corrected() [Pa].
  double most_removed() const { return jumps_.most_removed(); }

 private:
  Recorder& recorder_;
  Units units_;
  bool tensors_, has_plates_;
  JumpCorrection jumps_;
  std::vector<double> row_, time_, internal_, external_, external_corrected_, periodic_, virial_, plates_,
      pressure_;
};

}  // namespace supple
