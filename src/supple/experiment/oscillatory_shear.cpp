#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "supple/core/error.hpp"
#include "supple/core/whole_number.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/experiment/frame.hpp"
#include "supple/experiment/key_sets.hpp"
#include "supple/experiment/microgel.hpp"
#include "supple/experiment/moduli.hpp"
#include "supple/experiment/sheared_suspension.hpp"

namespace supple {

namespace {

std::vector<Derived> derive_oscillatory_shear(const Case& c, const InitialState* initial) {
  const SuspensionModel& model = suspension_model(c);
  const ShearProtocol p = model.protocol(c, initial);
  std::vector<Derived> all = model.constants(c, initial);
  for (Derived& d : derived_protocol(p.windows, "Hz")) all.push_back(std::move(d));
  all.push_back({{"time_step", "s", "time step"}, p.time_step});
  all.push_back({{"damping_factor", "", "factor per step on velocity relative to the flow"}, p.damping});
  all.push_back({{"steps_per_period", "", "steps per period"}, 1 / (p.windows.frequency * p.time_step)});
  all.push_back({{"steps", "", "steps of the protocol"}, static_cast<double>(p.steps)});
  for (Derived& d : model.consequences(c, initial, p)) all.push_back(std::move(d));
  return all;
}

void run_oscillatory_shear(const Case& c, const InitialState* initial, Recorder& recorder) {
  const ShearProtocol protocol = suspension_model(c).protocol(c, initial);
  Suspension s = make_suspension(c, initial, recorder);
  if (resumed_part(recorder) != sheared_part) s.system.time = 0, s.system.step = 0;
  recorder.begin(make_run_info(s.system, s.units));
  s.time_step = protocol.time_step;
  s.damping = protocol.damping;
  record_constants(s, initial, derive_oscillatory_shear(c, initial), recorder);

  ShearedSuspension sheared(c, initial, s, recorder);
  try {
    sheared.move({"oscillatory shear", protocol.steps, protocol.rows,
                  std::max(c.output.images, c.output.frames), s.time_step, s.damping, protocol.rates});
  } catch (const Error& e) {
    if (e.kind() != ErrorKind::interrupted) throw;
    if (const auto cycles = whole_cycles(protocol.windows, sheared.table().column("t")))
      record_moduli(sheared.table(), *cycles, protocol.demodulator, gap_of(s.system, s.units), recorder);
    throw;
  }
  const Evaluation<2>& last = sheared.finish({});
  record_moduli(sheared.table(), protocol.windows, protocol.demodulator, gap_of(s.system, s.units), recorder);
  record_counts(s.system, last, recorder);
  recorder.value("results", {"cpu_time", "s", "processor time of the run"}, recorder.cpu_time());
}

void check_boundary(const Case& c, Problems& problems) {
  if (c.box.boundary != "lees_edwards")
    add_problem(problems, c, fmt::format("box.boundary = \"{}\" cannot be sheared", c.box.boundary),
                "oscillatory_shear strains the cell",
                "set boundary = \"lees_edwards\", or experiment = \"dynamics\"");
}

}  // namespace

Experiment oscillatory_shear() {
  return {.name = "oscillatory_shear",
          .meaning = "G' and G'' of a suspension of crosslinked particles under oscillatory shear",
          .matter = &disc_matter(),
          .keys = with(disc_keys(), {"shear.*", "-shear.rate", "time.step", "time.step_factor",
                                     "initial.state", "output.*"}),
          .derive = derive_oscillatory_shear,
          .run = run_oscillatory_shear,
          .figure = always<Figure::stress>,
          .first_keys = microgel_first_keys(),
          .check = check_boundary,
          .doubt = doubt_periods};
}

}  // namespace supple
