/// The documented microgel model as a case asks for it: constants, laws and time step
/// (docs/theory/microgel.md).
#pragma once
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "supple/experiment/case.hpp"
#include "supple/experiment/derived.hpp"
#include "supple/experiment/initial_state.hpp"
#include "supple/experiment/recorder.hpp"
#include "supple/solve/mover.hpp"

namespace supple {

/// Numbers that follow from a case, in SI; masses, stiffnesses and viscosities are per metre of depth.
struct MicrogelConstants {
  double mean_mass = 0, smallest_mass = 0;
  double k = 0;                           ///< (pi/8) E (S1-8) [N/m per m]
  double tau = 0;                         ///< sqrt(m/k) [s]
  double frequency = 0;                   ///< [Hz]
  double stable_step = 0, time_step = 0;  ///< [s]
  double relaxation_step = 0;             ///< of the preparation, which knows nothing of the protocol [s]
  MaterialConstants material;             ///< SI, every one set: what a continuation starts with
  DiscLaw law;
};

/// Constants of the case, or of the state that it starts from; keys that the user gave win over the state's
/// numbers. Throws an input error where the time step that was asked for is above the stability limit.
MicrogelConstants derive_constants(const Case& c, const InitialState* initial);

/// The constants that a run records.
std::vector<Derived> derived_constants(const MicrogelConstants& k);

/// Keys that everybody changes in a first case of a suspension.
std::set<std::string> microgel_first_keys();

/// The repulsion law that the case names; c is the central repulsion coefficient.
Repulsion make_repulsion(const Material& material, double c);

/// Largest stable step of explicit dynamics [time]: leapfrog_limit() for a disc of the smallest mass m held
/// by six contacts or links, with w^2 = 6 (s k + 3 k_t)/m and damping ratio z = 6 (eta + 3 eta_t)/(2 m w). s
/// is the largest stiffening -F'(d)/k, at least 1, up to 50 % overlap and, of links, up to their stretch in
/// an affine shear by `amplitude`. In the 3, 1 is of translation and 2 of rotation (r^2/I = 2/m).
double stable_time_step(const DiscLaw& law, const Repulsion& repulsion, double smallest_mass,
                        double amplitude);

/// Shares of the stability limit. The time step of protocols: the stiffest contact has about 10 steps in a
/// period, and G' and G'' are within 0.1 % of those of a vanishing step (docs/decisions/0018). That of the
/// preparation, whose first steps are four times as long.
inline constexpr double step_share = 0.5, relaxation_share = 0.2;

/// The plates of the case once the discs are prepared; a periodic cell has none.
Plates plates_of(const Case& c);

/// The stepper of the documented model, with friction and without plates so far.
std::unique_ptr<Mover<2>> make_dynamics(const Case& c, const MicrogelConstants& k);

}  // namespace supple
