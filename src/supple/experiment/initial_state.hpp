/// What a run starts from when a state file is given.
#pragma once
#include <map>
#include <optional>
#include <string>

#include "supple/contact/laws/harmonic.hpp"
#include "supple/contact/walls.hpp"
#include "supple/experiment/held_keys.hpp"
#include "supple/model/evaluation.hpp"
#include "supple/model/system.hpp"
#include "supple/model/units.hpp"

namespace supple {

/// Constants of the contact law of discs, in the units of the state. One that is unset is not in the file,
/// and the case decides. A run records them in the group `material_group`, so that its continuation has the
/// same bits.
struct MaterialConstants {
  std::optional<double> k, nu, k_t,
      nu_t;  ///< springs and viscosities of free contacts, central and tangential
  std::optional<double> mu, central_repulsion_coefficient;
  std::optional<double> permanent_ratio_central, permanent_ratio_tangential;  ///< link over contact stiffness
  std::optional<bool> keep_viscosity_coefficients_constant;
};
inline constexpr auto material_group = "material";
/// Names in that group of the two numbers of Harmonic.
inline constexpr auto contact_stiffness = "contact_stiffness";
inline constexpr auto contact_is_relative = "contact_is_relative";
/// Group of a run for what else its continuation takes over: dt, cool_factor, reset_force_each_step,
/// removed_stress and, if the run keeps an account of energy, account_numbers().
inline constexpr auto protocol_group = "protocol";

/// visit(name, constant) for each constant; names are those in files.
template <class Constants, class Visit>
void for_each_constant(Constants& c, Visit&& visit) {
  visit("k", c.k);
  visit("nu", c.nu);
  visit("k_t", c.k_t);
  visit("nu_t", c.nu_t);
  visit("mu", c.mu);
  visit("central_repulsion_coefficient", c.central_repulsion_coefficient);
  visit("permanent_ratio_central", c.permanent_ratio_central);
  visit("permanent_ratio_tangential", c.permanent_ratio_tangential);
  visit("keep_viscosity_coefficients_constant", c.keep_viscosity_coefficients_constant);
}

/// What acts on deformable particles from outside.
struct Environment {
  /// stands[d][0], stands[d][1]: whether a wall stands at the lower and the upper end of direction d, if that
  /// is not periodic.
  std::array<std::array<bool, 2>, 2> stands{{{true, true}, {true, true}}};
  Vec2 gravity{};

  bool is_closed() const { return stands == Environment{}.stands; }
};
/// Group of a run for the environment.
inline constexpr auto environment_group = "environment";
/// visit(name, stands) for each wall; names are those in files.
template <class AnyEnvironment, class Visit>
void for_each_wall(AnyEnvironment& e, Visit&& visit) {
  visit("left", e.stands[flow][0]);
  visit("right", e.stands[flow][1]);
  visit("floor", e.stands[gradient][0]);
  visit("lid", e.stands[gradient][1]);
}

/// A state to start from, with what its file says besides the system.
struct InitialState {
  Units units;
  System<2> system;
  std::optional<Evaluation<2>> evaluation;  ///< forces and torques carried over; no pair forces
  MaterialConstants material;
  std::optional<Harmonic> contact;  ///< contact law of deformable particles, if the file has it
  HeldKeys keys;                    ///< laws and sample by name, if the file has them
  Environment environment;          ///< of deformable particles
  /// Numbers of the protocol that the file has, of these: dt, cool_factor (per step), steps, f, amplitude,
  /// pre, periods, post, removed_stress [Pa] (JumpCorrection), account_numbers() [J/m] (EnergyTable).
  std::map<std::string, double> protocol;
  bool reset_force_each_step = true;  ///< false: forces on plate discs add up step by step, as in the package
};

}  // namespace supple
