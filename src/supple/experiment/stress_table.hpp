/// The table "stress": one row per step, at the instant of the forces.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "supple/experiment/initial_state.hpp"
#include "supple/experiment/recorder.hpp"
#include "supple/model/units.hpp"
#include "supple/observe/jump_correction.hpp"

namespace supple {

/// Declares and fills the table; stresses in Pa, times in s.
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

  /// A column of the table so far, one value a row.
  std::vector<double> column(const std::string& name) const { return recorder_.column("stress", name); }
  bool has_plates() const { return has_plates_; }
  /// Mean of (xx + yy)/2 of the overall tensor over all rows [Pa].
  double mean_pressure() const { return pressure_sum_ / static_cast<double>(rows_); }
  /// Largest |sum of jumps| that was taken out of external_corrected() [Pa].
  double most_removed() const { return jumps_.most_removed(); }

  void keep(Keeper& k) {
    k("has_plates", has_plates_);
    k("jumps", jumps_);
    k("pressure_sum", pressure_sum_);
    k("rows", rows_);
  }

 private:
  Recorder& recorder_;
  Units units_;
  bool tensors_, has_plates_;
  JumpCorrection jumps_;
  std::vector<double> row_;
  double pressure_sum_ = 0;
  std::int64_t rows_ = 0;
};

}  // namespace supple
