/// The table "energy": where the energy of a suspension is, whence it came and where it went, a row per step.
#pragma once
#include <string>
#include <vector>

#include "supple/experiment/initial_state.hpp"
#include "supple/experiment/recorder.hpp"
#include "supple/model/units.hpp"
#include "supple/observe/energy_balance.hpp"
#include "supple/solve/stepper.hpp"

namespace supple {

/// Declares and fills the table, in J per metre of depth (bodies of many sites: in units of the run), and
/// keeps the account that it is made from: the stepper books every step on it. Only where it has energies.
class EnergyTable {
 public:
  /// With the time of `initial` (initial.keep_time) the account of that run goes on, where it has one.
  EnergyTable(Recorder& recorder, Stepper& stepper, const System<2>& system, const Units& units,
              const Case& c, const InitialState* initial);
  EnergyTable(const EnergyTable&) = delete;
  EnergyTable& operator=(const EnergyTable&) = delete;

  /// What is left over of the balance, over all that was lost so far: the error of the time step.
  double relative_residual(const System<2>& system, const Evaluation<2>& evaluation) const;
  /// One row; the first opens the account. The evaluation is the stepper's at this instant.
  void append(const System<2>& system, const Evaluation<2>& evaluation);
  /// All that was lost up to each row [energy of the run].
  const std::vector<double>& lost() const { return lost_; }
  /// Hands over what a continuation needs of the account.
  void finish();

 private:
  Recorder& recorder_;
  double time_, energy_;  ///< units of the run in SI
  bool has_shapes_;
  EnergyBalance account_;
  bool is_open_ = false;
  std::vector<double> lost_;
};

/// Names in protocol_group of what an account needs to go on [J/m].
std::vector<std::string> account_numbers();

}  // namespace supple
