/// The table "energy": where the energy of a suspension is, where it came from and where it went, a row per
/// step.
#pragma once
#include <string>
#include <vector>

#include "supple/experiment/initial_state.hpp"
#include "supple/experiment/recorder.hpp"
#include "supple/model/units.hpp"
#include "supple/observe/energy_balance.hpp"
#include "supple/solve/stepper.hpp"

namespace supple {

/// Declares and fills the table, in J per metre of depth (of deformable particles: in units of the run), and
/// holds the account on which the stepper books every step. Only for steppers with has_energies().
class EnergyTable {
 public:
  /// Where time goes on from that of `initial` (initial.keep_time), the account of that run goes on too, if
  /// it has one.
  EnergyTable(Recorder& recorder, Stepper<2>& stepper, const System<2>& system, const Units& units,
              const Case& c, const InitialState* initial);
  EnergyTable(const EnergyTable&) = delete;
  EnergyTable& operator=(const EnergyTable&) = delete;

  /// |residual of the balance| over all energy lost so far: the error of the time step.
  double relative_residual(const System<2>& system, const Evaluation<2>& evaluation) const;
  /// Adds a row; the first one opens the account. The evaluation is the stepper's at the present instant.
  void append(const System<2>& system, const Evaluation<2>& evaluation);
  /// All energy lost up to each row, in the units of the table.
  std::vector<double> lost() const;
  /// Records the numbers of the account that a continuation needs.
  void finish();

  void keep(Keeper& k) {
    k("account", account_);
    k("is_open", is_open_);
  }

 private:
  Recorder& recorder_;
  double time_, energy_;  ///< units of the run in SI
  bool has_shapes_;
  EnergyBalance<2> account_;
  bool is_open_ = false;
};

/// Names in protocol_group of the numbers that an account needs to go on [J/m].
std::vector<std::string> account_numbers();

}  // namespace supple
