#include "supple/core/error.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/experiment/frame.hpp"
#include "supple/experiment/key_sets.hpp"
#include "supple/experiment/microgel.hpp"
#include "supple/experiment/moduli.hpp"
#include "supple/experiment/suspension.hpp"
#include "supple/observe/stress.hpp"

namespace supple {

namespace {

std::vector<Derived> derive_preparation(const Case& c, const InitialState* initial) {
  if (initial)
    throw input_error("experiment = \"preparation\" with initial.state", "a state is prepared already",
                      "leave one of them away");
  return suspension_model(c).constants(c, nullptr);
}

void run_preparation(const Case& c, const InitialState* initial, Recorder& recorder) {
  const std::vector<Derived> derived = derive_preparation(c, initial);
  Suspension s = make_suspension(c, nullptr, recorder);
  recorder.begin(make_run_info(s.system, s.units));
  record_constants(s, nullptr, derived, recorder);
  const Evaluation<2>& evaluation = s.stepper->evaluate_energies(s.system, {});
  recorder.frame(frame_of(s, evaluation, {}));
  recorder.final_state(FinalState<2>{s.system, evaluation});
  const StressTensors stress = stress_tensors(s.system, evaluation, s.units.stress());
  recorder.value("results", {"mean_normal_stress", "Pa", "(xx + yy)/2 of the overall tensor, at rest"},
                 stress.pressure());
  recorder.value("results", {"shear_stress_virial", "Pa", "left by the preparation"}, stress.shear_virial());
  record_counts(s.system, evaluation, recorder);
}

}  // namespace

Experiment preparation() {
  return {.name = "preparation",
          .meaning = "such a suspension brought to rest, for runs that start from it",
          .matter = &disc_matter(),
          .keys = disc_keys(),
          .derive = derive_preparation,
          .run = run_preparation,
          .first_keys = microgel_first_keys(),
          .next = "oscillatory_shear"};
}

}  // namespace supple
