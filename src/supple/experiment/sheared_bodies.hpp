/// What experiments on deformable particles in a sheared cell share.
#pragma once
#include <vector>

#include "supple/experiment/body_stress_table.hpp"
#include "supple/experiment/course.hpp"
#include "supple/experiment/energy_table.hpp"
#include "supple/experiment/packing_record.hpp"
#include "supple/solve/mover.hpp"

namespace supple {

/// `making`, with the flow, links and contact memory of a state kept (Flow::kept).
Making sheared(Making making);

/// The plates of the case; input error where they would repel.
Plates plates_of_bodies(const Case& c);

/// Takes the particles from the checkpoint of a run that goes on and was sheared already.
void restore_sheared(Packing<2>& packing, const Recorder& recorder);

/// Links the particles if the case asks for it and they are not linked yet; records the numbers of links and
/// clusters. A run that goes on has done so.
void link_packing(const Case& c, Packing<2>& packing, Recorder& recorder);

/// A packing in motion in a sheared cell, with its laws, its tables and its account of energy.
class ShearedBodies {
 public:
  ShearedBodies(const Case& c, const InitialState* initial, Packing<2>& packing, Recorder& recorder);

  const BodyStressTable& table() const { return table_; }
  /// All energy lost up to each row.
  std::vector<double> lost() const { return energies_.lost(); }

  /// A row of the tables at every row of the course, from the first, or that of the run that goes on. `more`
  /// saves what else the experiment needs. Hands over the last good state where it stops.
  void move(const Course& course, const Keep& more);

  /// Records the results of the account, and the packing at the end.
  void finish();

 private:
  Packing<2>& packing_;
  Recorder& recorder_;
  Mover<2> dynamics_;
  BodyStressTable table_;
  EnergyTable energies_;
  std::int64_t row_ = 0;
};

/// The experiment `dynamics` of deformable particles where the case has a shear rate.
std::vector<Derived> derive_sheared_dynamics(const Case& c, const InitialState* initial);
void run_sheared_dynamics(const Case& c, const InitialState* initial, Recorder& recorder);

}  // namespace supple
