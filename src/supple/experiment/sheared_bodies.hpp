/// Packings of deformable particles in a sheared cell: what their experiments share.
#pragma once
#include <functional>
#include <vector>

#include "supple/experiment/body_stress_table.hpp"
#include "supple/experiment/energy_table.hpp"
#include "supple/experiment/packing_record.hpp"
#include "supple/solve/disc_dynamics.hpp"

namespace supple {

/// Particles whose contacts and steps are those of a sheared cell.
Making sheared(Making making);

/// Input error: rigid polygons cross no sheared boundary yet.
void refuse_rigid(const Packing& packing);

/// Links the particles, where the case says so and they are not; records how many links and clusters.
void link_packing(const Case& c, Packing& packing, Recorder& recorder);

/// The particles of a packing in motion, sheared: with their laws and links, tables and account.
class ShearedBodies {
 public:
  ShearedBodies(const Case& c, const InitialState* initial, Packing& packing, Recorder& recorder);

  const BodyStressTable& table() const { return table_; }
  const std::vector<double>& lost() const { return energies_.lost(); }

  /// So many steps, each at rates(i), of which one frame in so many is kept. Hands over the last good state
  /// where it stops.
  void move(const char* phase, std::int64_t steps, double dt, double damping, int frames,
            const std::function<ShearRates(std::int64_t)>& rates_at);

  /// What the account says, and the packing at the end.
  void finish();

 private:
  Packing& packing_;
  Recorder& recorder_;
  DiscDynamics dynamics_;
  BodyStressTable table_;
  EnergyTable energies_;
};

/// `dynamics` of deformable particles with a shear rate.
std::vector<Derived> derive_sheared_dynamics(const Case& c, const InitialState* initial);
void run_sheared_dynamics(const Case& c, const InitialState* initial, Recorder& recorder);

}  // namespace supple
