/// What experiments on packings tell the recorder.
#pragma once
#include <type_traits>

#include "supple/experiment/derived.hpp"
#include "supple/experiment/jam.hpp"
#include "supple/experiment/observable.hpp"
#include "supple/observe/body_stress.hpp"
#include "supple/observe/contact_network.hpp"
#include "supple/observe/shape_measures.hpp"
#include "supple/observe/soundness.hpp"

namespace supple {

/// How packings are made: to derive numbers from them, and to run. Particles of a run that goes on find their
/// places in its checkpoint.
inline const Making set_apart{Places::apart, {}, Flow::stopped};
inline Making at_random(Recorder& recorder) {
  if (recorder.resumed()) return set_apart;
  return {Places::random, [&recorder] { return recorder.stop_requested(); }, Flow::stopped};
}

/// Numbers of a packing that are known before the run.
template <int Dim>
std::vector<Derived> derived_packing(const Packing<Dim>& packing);
/// The same for experiments that minimise, with the tolerances of equilibrium.
template <int Dim>
std::vector<Derived> derived_equilibria(const Packing<Dim>& packing);

/// Begins the run, if it has not begun: records sizes, bodies and constants. From then on minimisations of
/// the packing stop when the recorder asks for it.
template <int Dim>
void begin_packing(Packing<Dim>& packing, const std::vector<Derived>& constants, Recorder& recorder);

/// Everything that is recorded of a packing at one instant.
template <int Dim>
struct PackingReport {
  Evaluation<Dim> evaluation;
  std::vector<ContactRecord<Dim>> records;
  std::vector<SiteContact<Dim>> contacts;
  ContactNetwork network;
  std::vector<std::uint8_t> rattlers;
  ContactNumbers numbers;  ///< without rattlers
  ConstraintCount constraints;
  BodyStresses<Dim> stresses;
  ShapeMeasures<Dim> shapes;
  PackingFraction fraction;
  Soundness soundness;
};
/// `now`: velocities that dashpots see, where those of the packing lag behind (present_motion).
template <int Dim>
PackingReport<Dim> report_packing(Packing<Dim>& packing,
                                  const std::type_identity_t<PresentMotion<Dim>>& now = {});

/// The meanings of columns of tables.
template <int Dim>
inline constexpr const char* packing_fraction_meaning =
    Dim == 2 ? "covered area over area of the cell" : "covered volume over volume of the cell";
inline constexpr const char* unsound_meaning =
    "particles that have got into another one, cross themselves, or have holes between their vertices";

/// A packing, its report and the work that led to it. Without minimisations the particles move: stresses then
/// have their kinetic part.
template <int Dim>
struct PackingInstant {
  const Packing<Dim>& packing;
  const PackingReport<Dim>& report;
  const JamProgress<Dim>& work;
  bool moves() const { return work.minimisations == 0; }
  /// Compression positive, in units of pressure.
  Mat<Dim> stress() const {
    return (1 / packing.pressure_unit) * (moves() ? report.stresses.total() : report.stresses.virial());
  }
};

/// What every table of packings has: packing fraction, pressures, contacts, rattlers, energy, residual, work.
/// `symbol`: the unit of pressures.
template <int Dim>
Observables<PackingInstant<Dim>> packing_observables(const std::string& symbol);

/// closed: particles fill a cell. open: they lie in more room than they fill, so that there is no packing
/// fraction and no stress.
enum class Surroundings { closed, open };

/// The frame at the instant of the report: positions, forces, contacts; stress, shape and contacts of each
/// body; energies and, if closed, stresses of the whole.
template <int Dim>
Frame<Dim> packing_frame(const Packing<Dim>& packing, const PackingReport<Dim>& report,
                         Surroundings surroundings = Surroundings::closed);

/// Records the results of a packing, its last frame and its state. Warns of bodies inside others and of
/// minimisations that did not converge. If `progress` has no minimisations the particles move: then no work
/// is recorded, and stresses have their kinetic part.
template <int Dim>
void record_packing(Packing<Dim>& packing, const JamProgress<Dim>& progress, Recorder& recorder,
                    Surroundings surroundings = Surroundings::closed,
                    const std::type_identity_t<PresentMotion<Dim>>& now = {});

/// Walls and gravity of a packing as they are now.
template <int Dim>
Environment environment_of(const Packing<Dim>& packing);

/// The same for a packing in a closed cell, with a frame, its packing fraction, pressures and residual.
template <int Dim>
void hand_over_packing(Packing<Dim>& packing, Recorder& recorder);

/// Hands over the state as it is, for a run that ends early.
template <int Dim>
void hand_over(Packing<Dim>& packing, Recorder& recorder);

}  // namespace supple
