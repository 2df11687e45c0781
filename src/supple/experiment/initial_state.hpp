/// What a run starts from when a state file is given.
#pragma once
#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "supple/contact/laws/harmonic.hpp"
#include "supple/core/error.hpp"
#include "supple/experiment/held_keys.hpp"
#include "supple/model/any_system.hpp"
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

/// What acts on deformable particles from outside. Particles in 2D know nothing of the third direction.
struct Environment {
  /// stands[d][0], stands[d][1]: whether a wall stands at the lower and the upper end of direction d, if that
  /// is not periodic.
  std::array<std::array<bool, 2>, 3> stands{{{true, true}, {true, true}, {true, true}}};
  Vec3 gravity{};  ///< acceleration [length/time^2]

  bool is_closed() const { return stands == Environment{}.stands; }
  /// The same in as many directions as the particles have (WallLaw::stands, External::gravity).
  template <int Dim>
  std::array<std::array<bool, 2>, Dim> stands_in() const {
    std::array<std::array<bool, 2>, Dim> walls;
    std::copy_n(stands.begin(), Dim, walls.begin());
    return walls;
  }
  template <int Dim>
  Vec<Dim> gravity_in() const {
    Vec<Dim> g;
    for (int d = 0; d < Dim; ++d) g[d] = gravity[d];
    return g;
  }
};
/// Group of a run for the environment.
inline constexpr auto environment_group = "environment";
/// visit(name, stands) for each wall of so many directions; names are those in files.
template <int Dim = 2, class AnyEnvironment, class Visit>
void for_each_wall(AnyEnvironment& e, Visit&& visit) {
  visit("left", e.stands[flow][0]);
  visit("right", e.stands[flow][1]);
  visit("floor", e.stands[gradient][0]);
  visit("lid", e.stands[gradient][1]);
  if constexpr (Dim == 3) {
    visit("back", e.stands[2][0]);
    visit("front", e.stands[2][1]);
  }
}

/// A state to start from, with what its file says besides the system.
struct InitialState {
  Units units;
  AnySystem system;
  std::optional<AnyEvaluation> evaluation;  ///< forces and torques carried over; no pair forces
  MaterialConstants material;
  std::optional<Harmonic> contact;  ///< contact law of deformable particles, if the file has it
  HeldKeys keys;                    ///< laws and sample by name, if the file has them
  Environment environment;          ///< of deformable particles
  /// Numbers of the protocol that the file has, of these: dt, cool_factor (per step), steps, f, amplitude,
  /// pre, periods, post, removed_stress [Pa] (JumpCorrection), account_numbers() [J/m] (EnergyTable).
  std::map<std::string, double> protocol;
  bool reset_force_each_step = true;  ///< false: forces on plate discs add up step by step, as in the package
};

/// The system of a state, where it has this dimension. Input error where it has the other one.
template <int Dim>
const System<Dim>& system_of(const InitialState& initial) {
  if (const auto* system = std::get_if<System<Dim>>(&initial.system)) return *system;
  constexpr bool flat = Dim == 2;
  throw input_error(
      std::string("the state to start from holds particles in ") + (flat ? "three" : "two") + " dimensions",
      std::string("this is about particles in ") + (flat ? "two" : "three"),
      "start from a state in as many, or set bodies.dim to that of the state");
}
template <int Dim>
System<Dim>& system_of(InitialState& initial) {
  return const_cast<System<Dim>&>(system_of<Dim>(std::as_const(initial)));
}

/// The forces of such a state; null where it has none.
template <int Dim>
const Evaluation<Dim>* evaluation_of(const InitialState& initial) {
  return initial.evaluation ? std::get_if<Evaluation<Dim>>(&*initial.evaluation) : nullptr;
}

}  // namespace supple
