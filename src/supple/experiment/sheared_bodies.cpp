#include "supple/experiment/sheared_bodies.hpp"

#include <string>

#include "supple/core/error.hpp"
#include "supple/experiment/body_rheology.hpp"
#include "supple/experiment/sound_states.hpp"
#include "supple/experiment/suspension.hpp"

namespace supple {

namespace {

/// Velocities of the instant of the positions; the packing's own report of everything else.
Frame<2> sheared_frame(Packing<2>& packing, const Mover<2>& dynamics, const PresentMotion<2>& now,
                       double rate_now) {
  Frame<2> frame = packing_frame(packing, report_packing(packing, now));
  dynamics.bring_to_instant(packing.system, rate_now, frame.velocity, frame.spin);
  frame.strain_rate = rate_now;
  return frame;
}

}  // namespace

Making sheared(Making making) {
  making.flow = Flow::kept;
  return making;
}

void restore_sheared(Packing<2>& packing, const Recorder& recorder) {
  if (resumed_part(recorder) == sheared_part) Keeper::restoring (*recorder.resumed())("packing", packing);
}

void link_packing(const Case& c, Packing<2>& packing, Recorder& recorder) {
  if (resumed_part(recorder) == sheared_part) return;
  if (c.particles.permanent_links && packing.system.links.empty())
    recorder.value("results", {"clusters", "", "clusters of particles that links hold together"},
                   crosslink_bodies(c, packing));
  recorder.value("results", {"links", "", "permanent links of vertices"},
                 static_cast<double>(packing.system.links.size()));
}

Plates plates_of_bodies(const Case& c) {
  if (c.box.plates == "repulsive")
    throw input_error("box.plates = \"repulsive\" with deformable particles",
                      "only discs are repelled by plates", "set it to \"capture\" or \"none\"");
  return c.box.plates == "capture" ? Plates::capture : Plates::none;
}

namespace {

/// The packing with its plates in place, or without those of its state.
Packing<2>& between_plates(const Case& c, Packing<2>& packing) {
  if (plates_of_bodies(c) == Plates::capture) capture_at_boundaries(packing.system, Plates::capture);
  else leave_plates(packing.system);
  return packing;
}

}  // namespace

ShearedBodies::ShearedBodies(const Case& c, const InitialState* initial, Packing<2>& packing,
                             Recorder& recorder)
    : packing_(between_plates(c, packing)),
      recorder_(recorder),
      dynamics_(*packing.field),
      table_(packing, c.output.tensors, recorder),
      energies_(recorder, dynamics_, packing.system, reduced_units(), c, initial) {
  dynamics_.set_plates(plates_of_bodies(c));
}

void ShearedBodies::move(const Course& course, const Keep& more) {
  LastGood<2> good(packing_);
  const Keep keep = in_part(sheared_part, [&](Keeper& k) {
    k("row", row_);
    k("packing", packing_);
    k("good", good);
    k("stress", table_);
    k("energy", energies_);
    more(k);
  });
  restore(recorder_, keep, sheared_part);
  const auto append = [&](const Evaluation<2>& evaluation, double rate) {
    table_.append(evaluation, rate);
    energies_.append(packing_.system, evaluation);
  };
  try {
    const auto see = [&](const CourseRow& now) {
      if (now.keeps_frame || now.row % look_interval(course.steps) == 0) good.look();
      append(now.evaluation, now.rates.now);
      if (now.keeps_frame)
        recorder_.frame(sheared_frame(packing_, dynamics_, now.evaluation.now, now.rates.now));
    };
    supple::move(course, packing_.system, dynamics_, recorder_, row_, keep, see);
  } catch (const Error& e) {
    if (e.kind() == ErrorKind::interrupted) {  // a row of the last instant
      const ShearRates rates = course.rates(row_, packing_.system.time);
      append(dynamics_.evaluate_energies(packing_.system, rates), rates.now);
    }
    energies_.finish();
    hand_over(packing_, recorder_);
    throw;
  }
}

void ShearedBodies::finish() {
  const Evaluation<2>& last = dynamics_.evaluate_energies(packing_.system, {});
  energies_.finish();
  recorder_.value("results",
                  {"energy_residual", "", "what the balance of energy lacks, over all that was lost"},
                  energies_.relative_residual(packing_.system, last));
  record_packing(packing_, {}, recorder_, Surroundings::closed, last.now);
}

}  // namespace supple
