/// What experiments on packings tell the recorder.
#pragma once
#include "supple/experiment/derived.hpp"
#include "supple/experiment/jam.hpp"
#include "supple/experiment/recorder.hpp"
#include "supple/observe/body_stress.hpp"
#include "supple/observe/contact_network.hpp"
#include "supple/observe/shape_measures.hpp"
#include "supple/observe/soundness.hpp"

namespace supple {

/// How packings are made to derive numbers from, and to run.
inline const Making set_apart{Places::apart, {}, Flow::stopped};
inline Making at_random(const Recorder& recorder) {
  return {Places::random, [&recorder] { return recorder.stop_requested(); }, Flow::stopped};
}

/// Numbers that are known before the run.
std::vector<Derived> derived_packing(const Packing& packing);
/// The same for experiments that minimise, with what they call equilibrium.
std::vector<Derived> derived_equilibria(const Packing& packing);

/// Begins the run: sizes, bodies, constants. From then on minimisations of the packing heed the recorder's
/// stop requests.
void begin_packing(Packing& packing, const std::vector<Derived>& constants, Recorder& recorder);

/// Everything that is said of a packing at one instant.
struct PackingReport {
  Evaluation<2> evaluation;
  std::vector<ContactRecord<2>> records;
  std::vector<SiteContact> contacts;
  ContactNetwork network;
  std::vector<std::uint8_t> rattlers;
  ContactNumbers numbers;  ///< without rattlers
  ConstraintCount constraints;
  BodyStresses stresses;
  ShapeMeasures shapes;
  PackingFraction fraction;
  Soundness soundness;
};
PackingReport report_packing(Packing& packing);

/// What the column "unsound" of a table says.
inline constexpr const char* unsound_meaning =
    "particles that have got into another one, cross themselves, or have holes between their vertices";

/// Names of the columns that every table of packings has, and their numbers: phi, pressures, contacts,
/// rattlers, energy, residual, work.
std::vector<Column> packing_columns(const Packing& packing);
std::vector<double> packing_row(const Packing& packing, const PackingReport& report, const JamProgress& work);

/// Closed: particles fill a cell. Open: they lie where there is room: neither a packing fraction nor a
/// stress.
enum class Surroundings { closed, open };

/// The instant of the report: positions, forces, contacts, of each body its stress, shape, contacts; energies
/// and, closed, stresses of the whole.
Frame packing_frame(const Packing& packing, const PackingReport& report,
                    Surroundings surroundings = Surroundings::closed);

/// Results of a packing, its last frame and its state. Warns of what the reader must know: bodies inside
/// others, minimisations that did not converge. Without minimisations in `progress` the particles move: no
/// work is recorded, and stresses have their kinetic part.
void record_packing(Packing& packing, const JamProgress& progress, Recorder& recorder,
                    Surroundings surroundings = Surroundings::closed);

/// Walls and gravity of a packing as they are.
Environment environment_of(const Packing& packing);

/// The same of a packing in a cell, with what it is there: a frame, its fraction, pressures and residual.
void hand_over_packing(Packing& packing, Recorder& recorder);

/// The state as it is, for a run that ends early.
void hand_over(Packing& packing, Recorder& recorder);

}  // namespace supple
