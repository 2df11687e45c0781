/// A packing of deformable particles: the system, what acts on it, and the ways in which experiments change
/// it.
#pragma once
#include <memory>
#include <optional>
#include <string>

#include "supple/experiment/case.hpp"
#include "supple/experiment/initial_state.hpp"
#include "supple/force/force_field.hpp"
#include "supple/observe/packing_fraction.hpp"
#include "supple/solve/body_objective.hpp"
#include "supple/solve/minimise.hpp"

namespace supple {

struct Soundness;

/// What happens when particles get into each other (contact.unsound).
enum class OnUnsound { stop, mark };

/// Everything that an experiment on bodies needs. Pressures are in units of `pressure_unit` where users see
/// them.
struct Packing {
  System<2> system;
  std::shared_ptr<ForceField> field;
  Outline outline = Outline::rough;
  double pressure_unit = 1;                ///< k_a a0 of a small particle; k_c for discs and rigid particles
  std::string pressure_symbol = "k_a a0";  ///< the name of that unit
  ForceTolerance tolerance;
  MinimiseSpec minimise;
  bool contact_pressure = false;  ///< P is that of contacts alone
  double covered_area = 0;        ///< of all bodies as they were when the packing was made
  double shape_area = 0;          ///< of their polygons and discs then
  OnUnsound on_unsound = OnUnsound::stop;
  Box<2> cell;                       ///< that it begins in; the system's own, but for particles set apart
  std::optional<System<2>> relaxed;  ///< the last state in equilibrium that no look refused: remember()
};

/// Where the particles of a case are put.
enum class Places {
  random,  ///< in the cell, apart
  apart    ///< far apart in a square array, at no cost: for numbers that do not depend on where they are
};

/// What becomes of the flow, the links and the memory of a state that was sheared: the flow stops, links are
/// refused and contacts forget; or all go on.
enum class Flow { stopped, kept };

struct Making {
  Places places = Places::random;
  StopRequest stop_requested;  ///< asked while particles find their places
  Flow flow = Flow::stopped;
};

/// The particles of the case at random positions that do not overlap in a square periodic cell of this
/// packing fraction, or the packing that the case starts from. Input errors where the case asks for what
/// cannot be.
Packing make_packing(const Case& c, const InitialState* initial, double packing_fraction,
                     const Making& making = {});

/// The same between four walls, height over width as given; no particle reaches beyond a wall as far as there
/// is room. The packing fraction is that of the area between the walls. A state to start from is taken with
/// its box; input error where that is periodic.
Packing make_boxed_packing(const Case& c, const InitialState* initial, double packing_fraction,
                           double aspect_ratio, const Making& making = {});

/// The same for experiments that change the size of the cell. Input error where the state to start from is
/// not periodic.
Packing make_periodic_packing(const Case& c, const InitialState* initial, const Making& making = {});

/// The force field that the case describes.
std::shared_ptr<ForceField> make_body_field(const Case& c);

/// The walls that the case describes.
WallLaw wall_law(const Case& c);

/// What a packing is at rest, as far as a search needs it; packing_fraction is near: what the bodies covered
/// at first, times the change of their polygons' area (covered_fraction is right, and takes longer).
struct PackingState {
  double packing_fraction = 0, pressure = 0, contact_pressure = 0,
         full_pressure = 0;  ///< pressures in pressure_unit
  Mat2 stress;               ///< in pressure_unit
  double energy = 0;
};

/// Minimises the energy in the present cell. Not to converge is no error: the report says so. Where the user
/// asked to stop, and where energies are not finite, it goes back to `relaxed` and throws.
MinimiseReport relax(Packing& packing, const MinimiseCallback& callback = {});

/// Keeps the state as `relaxed` where its minimisation converged and no run would have to stop at it.
void remember(Packing& packing, const MinimiseReport& report, const Soundness& soundness);

/// Throws a numerics error, with the packing back at `relaxed`, where a minimisation has not reached its
/// tolerance; `where` says of which state.
void require_converged(Packing& packing, const MinimiseReport& report, const std::string& where);

/// Goes back to `relaxed` and throws where a minimisation was interrupted or met numbers that are not finite.
void require_going_on(Packing& packing, const MinimiseReport& report);

/// An energy that no equilibrium of this pressure [pressure_unit] with the present contacts is below: 2 P V =
/// sum f r <= sqrt(2 U K), K = sum k r^2, by Cauchy and Schwarz. 0 where line tension makes pressure without
/// energy, and where contacts are not harmonic.
double least_energy(Packing& packing, double pressure);

/// The packing fraction as it is now; for rough particles by the published sum, which is much faster and as
/// good below deep overlap.
double covered_fraction(const Packing& packing);

/// Observables at the present state.
PackingState observe(Packing& packing);

}  // namespace supple
