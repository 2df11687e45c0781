#include "supple/experiment/sheared_suspension.hpp"

#include <string>

#include "supple/core/error.hpp"

namespace supple {

ShearedSuspension::ShearedSuspension(const Case& c, const InitialState* initial, Suspension& suspension,
                                     Recorder& recorder)
    : suspension_(suspension),
      recorder_(recorder),
      table_(recorder, suspension.units, c.output.tensors, suspension.system, initial) {
  if (c.output.energies && suspension.stepper->has_energies())
    energies_.emplace(recorder, *suspension.stepper, suspension.system, suspension.units, c, initial);
}

void ShearedSuspension::move(const Course& course) {
  Suspension& s = suspension_;
  const auto see = [&](const CourseRow& now) {
    table_.append(s.system, now.evaluation, now.rates.now);
    if (energies_) energies_->append(s.system, now.evaluation);
    if (now.keeps_frame) recorder_.frame(frame_of(s, now.evaluation, now.rates));
  };
  const Keep keeps = in_part(sheared_part, [this](Keeper& k) { keep(k); });
  restore(recorder_, keeps, sheared_part);
  try {
    supple::move(course, s.system, *s.stepper, recorder_, row_, keeps, see);
  } catch (const Error& e) {
    if (e.kind() == ErrorKind::interrupted) {
      const ShearRates rates = course.rates(row_, s.system.time);
      see({row_, s.stepper->evaluate_energies(s.system, rates), rates, false});  // a row of the last instant
      finish(rates);
    }
    throw;
  }
}

void ShearedSuspension::keep(Keeper& k) {
  k("row", row_);
  k("system", suspension_.system);
  suspension_.stepper->keep(k);
  k("stress", table_);
  if (energies_) k("energy", *energies_);
}

const Evaluation<2>& ShearedSuspension::finish(ShearRates rates) {
  const Evaluation<2>& last = suspension_.stepper->evaluate_energies(suspension_.system, rates);
  if (energies_) energies_->finish();
  table_.finish(suspension_.system, last);
  return last;
}

}  // namespace supple
