/// One time step of the published package particleShear 1.0.2.
#pragma once
#include <vector>

#include "supple/compat/particleshear/contacts.hpp"
#include "supple/contact/neighbor_list.hpp"
#include "supple/solve/stepper.hpp"

namespace supple {

/// What becomes of the force on plate discs after a step. The protocol of the package sets it to zero; its
/// relaxation adds the next one to it (the sum moves nothing, but is reported).
enum class PlateForce { reset, accumulate };

/// Semi-implicit Euler as the package does it, in micrometre, milligram and second. Contacts remember two
/// elongations (PairTable of width 2): that of `first` toward `second`, and that of `second`.
class ParticleShearStepper : public Stepper<2> {
 public:
  explicit ParticleShearStepper(const ParticleShearConstants& constants,
                                PlateForce plate_force = PlateForce::reset)
      : constants_(constants), plate_force_(plate_force) {}

  /// Brings velocities and spins to the rate `now`, decides which discs the plates hold, and evaluates all
  /// contacts. Throws an input error unless the box is periodic in both directions.
  const Evaluation<2>& evaluate(System<2>& system, ShearRates rates) override;
  void advance(System<2>& system, ShearRates rates, double dt, double damping) override;

  void keep(Keeper& k) override { k("carried_force", carried_force_); }

  void set_friction(double coefficient) override { constants_.mu = coefficient; }
  double friction() const override { return constants_.mu; }
  /// Throws an input error on repulsive plates, which the package does not have.
  void set_plates(Plates plates) override;
  const ParticleShearConstants& constants() const { return constants_; }

  /// Brings the pair table up to date, as linking needs it, without evaluating forces.
  void update_neighbors(System<2>& system);

 private:
  void accelerate(System<2>& system, double dt);

  ParticleShearConstants constants_;
  PlateForce plate_force_;
  Plates plates_ = Plates::none;
  NeighborList<2> neighbors_;
  ParticleShearContacts contacts_;
  Evaluation<2> evaluation_;
  std::vector<Vec2> carried_force_;  ///< summed over steps on plate discs
};

}  // namespace supple
