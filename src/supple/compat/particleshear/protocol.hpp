/// The oscillatory-shear experiment as the published package particleShear 1.0.2 runs it, in its own units
/// (micrometre, milligram, second; forces per metre of depth).
#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "supple/compat/particleshear/step.hpp"
#include "supple/experiment/case.hpp"
#include "supple/experiment/derived.hpp"
#include "supple/experiment/initial_state.hpp"
#include "supple/model/discs.hpp"

namespace supple {

/// Scales of a suspension: those of equal discs (b = 1), whatever the size ratio of the discs that are then
/// made.
struct ParticleShearScales {
  double radius = 0;  ///< sqrt(phi A / (pi N)), over sqrt((b + 1/b)/2) for size ratio b [um]
  double mass = 0;    ///< rho pi radius^2 [mg/m]
  double k = 0;       ///< (pi/8) E (S1-8) [mg/s^2/m]
  double tau = 0;     ///< sqrt(mass/k), over sqrt(b) [s]
};

/// Scales for `discs` discs in an area [um^2]; Young modulus [Pa], density [kg/m^3].
ParticleShearScales particleshear_scales(int discs, double area, double packing_fraction,
                                         double young_modulus, double density, double size_ratio = 1);

/// Everything that a run of the package derives from its parameters before the first step.
struct ParticleShearRun {
  ParticleShearConstants constants;
  ParticleShearScales scales;
  double dt = 0;            ///< time step of the protocol [s]
  double first_dt_max = 0;  ///< step with which the very first relaxation starts [s]
  double dt_max = 0;        ///< step with which later relaxations start [s]
  double frequency = 0;     ///< [Hz]
  double amplitude = 0, pre_periods = 0, periods = 0, post_periods = 0;
  double damping = 1;  ///< factor per step on velocity and spin
  std::int64_t steps = 0;

  /// Shear rate [1/s] of a step that starts at `time`; zero before and after the oscillation.
  double rate_at(std::int64_t step, double time) const;
};

/// Constants, time step and protocol of a case, or of the state that it starts from; keys that the user gave
/// win over the state's numbers. Throws an input error on what the package does not have.
ParticleShearRun derive_particleshear(const Case& c, const InitialState* initial = nullptr);

/// The numbers that a run records.
std::vector<Derived> derived_constants(const ParticleShearRun& run);

/// The suspension as the package draws it: each disc is large or small at random, so that the packing
/// fraction holds only on average; positions are whole units of length; and the density is (b + 1/b)/2 times
/// the nominal one, because the package takes masses from equal discs.
System<2> package_discs(const Box<2>& box, const DiscSpec& spec, std::uint64_t seed);

/// A part of the preparation: `steps` steps of one kind, and what follows them.
struct ParticleShearStage {
  enum class Friction { off, on };
  enum class Then { nothing, remove_drift, link };
  std::int64_t steps;
  double dt, damping;  ///< damping is per step
  Friction friction;
  Plates plates;
  Then then = Then::nothing;
};

/// The whole preparation, in order.
std::vector<ParticleShearStage> particleshear_preparation(const Case& c, const ParticleShearRun& run);

/// How far the preparation has got; it starts with the discs at random.
struct ParticleShearPreparation {
  System<2> system;
  std::int64_t stage = 0, step = 0;  ///< step: in the stage

  void keep(Keeper& k) {
    k("system", system);
    k("stage", stage);
    k("step", step);
  }
};
ParticleShearPreparation begin_preparation(const Case& c);

/// Relaxes the discs, crosslinks, cuts, and relaxes them between the plates: the system is then that before
/// the first step of the protocol, at time zero. `progress(done, total)` is called before every step and may
/// throw.
void prepare_particleshear(const Case& c, const ParticleShearRun& run, ParticleShearStepper& stepper,
                           ParticleShearPreparation& state,
                           const std::function<void(std::int64_t, std::int64_t)>& progress = {});

}  // namespace supple
