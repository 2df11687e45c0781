/// A suspension of discs in a sheared cell: what its experiments share.
#pragma once
#include <optional>

#include "supple/experiment/course.hpp"
#include "supple/experiment/energy_table.hpp"
#include "supple/experiment/stress_table.hpp"
#include "supple/experiment/suspension.hpp"

namespace supple {

/// The discs in motion, with the tables that the case asks for.
class ShearedSuspension {
 public:
  ShearedSuspension(const Case& c, const InitialState* initial, Suspension& suspension, Recorder& recorder);

  const StressTable& table() const { return table_; }

  /// A row of the tables at every row of the course, from the first, or that of the run that goes on. Where
  /// it stops early it hands over the state and throws `interrupted`.
  void move(const Course& course);

  /// Hands over the state at the end, in a cell that shears at these rates; the last evaluation.
  const Evaluation<2>& finish(ShearRates rates);

 private:
  void keep(Keeper& k);

  Suspension& suspension_;
  Recorder& recorder_;
  StressTable table_;
  std::optional<EnergyTable> energies_;
  std::int64_t row_ = 0;
};

}  // namespace supple
