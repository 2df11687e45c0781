/// A packing of deformable particles: the system, what acts on it, and the ways in which experiments change
/// it.
#pragma once
#include <memory>
#include <optional>
#include <string>

#include "supple/experiment/case.hpp"
#include "supple/experiment/initial_state.hpp"
#include "supple/force/force_field.hpp"
#include "supple/model/kept.hpp"
#include "supple/observe/packing_fraction.hpp"
#include "supple/solve/body_objective.hpp"
#include "supple/solve/minimise.hpp"

namespace supple {

struct Soundness;

/// Numbers of reports and progress that checkpoints keep.
void keep(Keeper& k, MinimiseReport& report);

/// What a run does when particles get into each other (contact.unsound): it stops, or marks the state and
/// goes on.
enum class OnUnsound { stop, mark };

/// Everything that an experiment on bodies needs. Pressures that users see are in units of `pressure_unit`.
template <int Dim>
struct Packing {
  System<Dim> system;
  Owned<ForceField<Dim>> field;
  Outline outline = Outline::rough;
  /// k_a a0 (3D: k_v v0) of a small particle; Young's modulus where all that deform are solids; k_c for discs
  /// and rigid ones; 1 for packings in 3D of a file.
  double pressure_unit = 1;
  std::string pressure_symbol = "k_a a0";  ///< the name of that unit
  ForceTolerance tolerance;
  MinimiseSpec minimise;
  bool contact_pressure = false;  ///< P is that of contacts alone
  double covered_area = 0;        ///< (3D: volume) by all bodies when the packing was made [length^Dim]
  double shape_area = 0;          ///< of their polygons (surfaces) and discs then, overlaps counted twice
  OnUnsound on_unsound = OnUnsound::stop;
  Box<Dim> cell;                       ///< at first: that of the system, except for particles set apart
  std::optional<System<Dim>> relaxed;  ///< the last sound state in equilibrium: remember()

  /// All that a case does not say, for a packing that was made from the same case.
  void keep(Keeper& k);
};

/// Where the particles that a case makes are put.
enum class Places {
  random,  ///< in the cell, apart
  apart    ///< far apart in a square array, in no time: for numbers that do not depend on the places
};

/// What becomes of flow, links and contact memory of a state that was sheared. stopped: the flow stops,
/// contacts forget, and links are an input error. kept: all of them go on.
enum class Flow { stopped, kept };

/// How a packing is made.
struct Making {
  Places places = Places::random;
  StopRequest stop_requested;  ///< asked while particles find their places
  Flow flow = Flow::stopped;
};

/// The particles of the case at random positions without overlap in a square (3D: cubic) periodic cell of
/// this packing fraction, or the particles of `initial`. Throws input errors where the case asks for what
/// cannot be.
template <int Dim = 2>
Packing<Dim> make_packing(const Case& c, const InitialState* initial, double packing_fraction,
                          const Making& making = {});

/// The same between four walls, with this height over width; as far as there is room no particle reaches
/// beyond a wall. The packing fraction is of the area between the walls. A state keeps its own box; input
/// error where that is periodic, under gravity or without some of the walls.
Packing<2> make_boxed_packing(const Case& c, const InitialState* initial, double packing_fraction,
                              double aspect_ratio, const Making& making = {});

/// make_packing() for experiments that change the size of the cell, at jamming.packing_fraction. Input error
/// where `initial` is not periodic.
template <int Dim = 2>
Packing<Dim> make_periodic_packing(const Case& c, const InitialState* initial, const Making& making = {});

/// What the case says of these particles, wherever they come from. Input errors on particles that cannot be
/// computed with, are in each other, or would shrink to points.
template <int Dim>
Packing<Dim> packing_of(const Case& c, System<Dim> system, Places places = Places::random);

/// The force field that the case describes.
template <int Dim>
ForceField<Dim> make_body_field(const Case& c);

/// The walls that the case describes.
template <int Dim>
WallLaw<Dim> wall_law(const Case& c);

/// What this pressure is on a line (3D: a square) of this length [force]: of a vertex, or a particle.
template <int Dim>
double force_by_pressure(double pressure, double length) {
  double force = pressure;
  for (int d = 1; d < Dim; ++d) force *= length;
  return force;
}

/// What a search needs to know of a packing at rest. The packing fraction is an estimate: the area covered at
/// first, times the change of the area of polygons and discs since, over the area of the cell.
/// covered_fraction() is right and takes longer.
template <int Dim>
struct PackingState {
  double packing_fraction = 0, pressure = 0, contact_pressure = 0,
         full_pressure = 0;  ///< pressures in pressure_unit
  Mat<Dim> stress;           ///< in pressure_unit
  double energy = 0;

  void keep(Keeper& k) {
    k("packing_fraction", packing_fraction);
    k("pressure", pressure);
    k("contact_pressure", contact_pressure);
    k("full_pressure", full_pressure);
    k("stress", stress);
    k("energy", energy);
  }
};

/// Minimises the energy in the present cell. Where it does not converge the report says so; this is no error.
/// Where the user asks to stop, or energies are not finite, the packing goes back to `relaxed` and an error
/// is thrown.
template <int Dim>
MinimiseReport relax(Packing<Dim>& packing, const MinimiseCallback& callback = {});

/// Keeps the state as `relaxed` if its minimisation converged and no run must stop at it (must_stop).
template <int Dim>
void remember(Packing<Dim>& packing, const MinimiseReport& report, const Soundness& soundness);

/// Throws a numerics error, with the packing back at `relaxed`, where a minimisation has not reached its
/// tolerance; `where` names the state in the error.
template <int Dim>
void require_converged(Packing<Dim>& packing, const MinimiseReport& report, const std::string& where);

/// Goes back to `relaxed` and throws where a minimisation was interrupted or met numbers that are not finite.
template <int Dim>
void require_going_on(Packing<Dim>& packing, const MinimiseReport& report);

/// A lower bound [energy] of the energy U of an equilibrium at this pressure P [pressure_unit] with the
/// present contacts. The inequality of Cauchy and Schwarz gives 2 P A = sum f r <= sqrt(2 U K) with K = sum k
/// r^2 over all springs, A the area of the cell. 0 where line tension makes pressure without energy, with
/// elastic elements, and where contacts are not harmonic.
template <int Dim>
double least_energy(Packing<Dim>& packing, double pressure);

/// The packing fraction as it is now; for rough particles by rough_sum(), which is much faster and as good
/// unless overlaps are deep; in 3D with a standard error of a thousandth where it is not exact.
template <int Dim>
double covered_fraction(const Packing<Dim>& packing);

/// Pressures, stress, energy and estimated packing fraction of the present state.
template <int Dim>
PackingState<Dim> observe(Packing<Dim>& packing);

}  // namespace supple
