#include <fmt/format.h>

#include <cmath>

#include "supple/core/error.hpp"
#include "supple/core/expression.hpp"
#include "supple/core/whole_number.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/experiment/frame.hpp"
#include "supple/experiment/key_sets.hpp"
#include "supple/experiment/sheared_suspension.hpp"

namespace supple {

namespace {

std::int64_t step_count(const Case& c, const InitialState* initial) {
  if (c.time.steps > 0 || c.is_given("time.steps")) return c.time.steps;
  if (initial)
    if (const auto at = initial->protocol.find("steps"); at != initial->protocol.end())
      return whole_number(at->second, "steps of the state to start from", "give time.steps");
  throw input_error("[time] steps is missing", "dynamics needs the number of steps", "set time.steps");
}

/// Factor per step: the state's own per time, where the user gave none.
double damping_per_step(const Case& c, const InitialState* initial, double time_step, double of_case) {
  if (initial && !c.is_given("shear.cool_factor"))
    if (const auto at = initial->protocol.find("cool_factor"); at != initial->protocol.end()) {
      const auto dt = initial->protocol.find("dt");
      return dt == initial->protocol.end()
                 ? at->second
                 : std::pow(at->second, time_step / (dt->second * initial->units.time));
    }
  return of_case;
}

/// Finds a rate that is not finite before the run comes to it, at 1000 times.
void check_rate(const Expression& rate, double start, double duration) {
  constexpr int points = 1000;
  for (int i = 0; i <= points; ++i) rate(start + duration * i / points);
}

double start_time(const Case&, const InitialState* initial) {
  return initial ? system_of<2>(*initial).time * initial->units.time : 0;
}

std::vector<Derived> derive_dynamics(const Case& c, const InitialState* initial) {
  const Expression rate(c.shear.rate, {"t"}, "[shear] rate");
  std::vector<Derived> all = suspension_model(c).constants(c, initial);
  const double dt = suspension_model(c).time_step(c, initial);
  all.push_back({{"time_step", "s", "time step"}, dt});
  const auto steps = static_cast<double>(step_count(c, initial));
  all.push_back({{"steps", "", "steps"}, steps});
  check_rate(rate, start_time(c, initial), steps * dt);
  return all;
}

void run_dynamics(const Case& c, const InitialState* initial, Recorder& recorder) {
  const Expression rate(c.shear.rate, {"t"}, "[shear] rate");
  const std::int64_t steps = step_count(c, initial);
  Suspension s = make_suspension(c, initial, recorder);
  s.damping = damping_per_step(c, initial, s.time_step * s.units.time, s.damping);
  start_clock(s.system, c, recorder);
  const auto rate_at = [&](double t) { return rate(t * s.units.time) * s.units.time; };

  recorder.begin(make_run_info(s.system, s.units));
  record_constants(s, initial, derive_dynamics(c, initial), recorder);
  ShearedSuspension sheared(c, initial, s, recorder);
  sheared.move({"dynamics", steps, steps + 1, c.is_given("output.frames") ? c.output.frames : steps + 1,
                s.time_step, s.damping, [&](std::int64_t step, double t) {
                  return ShearRates{rate_at(t), rate_at(step < steps ? t + 0.5 * s.time_step : t)};
                }});
  sheared.finish({rate_at(s.system.time), rate_at(s.system.time)});
}

void check_protocol(const Case& c, Problems& problems) {
  if (c.box.boundary != "lees_edwards" && c.shear.rate != "0")
    add_problem(
        problems, c,
        fmt::format("shear.rate = \"{}\" in a cell with boundary = \"{}\"", c.shear.rate, c.box.boundary),
        "only Lees-Edwards boundaries can be sheared", "set boundary = \"lees_edwards\" or rate = \"0\"");
  if (!c.is_given("time.steps") && c.time.steps == 0 && c.initial.state.empty())
    add_problem(problems, c, "time.steps is missing", "dynamics records that many steps",
                "set steps in [time]");
}

}  // namespace

Experiment dynamics() {
  return {.name = "dynamics",
          .meaning = "discs moving under a prescribed shear rate, every step recorded",
          .matter = &disc_matter(),
          .keys = with(disc_keys(), {"shear.relative_frequency", "shear.cool_factor", "shear.rate", "time.*",
                                     "initial.state", "initial.keep_time", "output.tensors",
                                     "output.energies", "output.frames", "output.plot"}),
          .derive = derive_dynamics,
          .run = run_dynamics,
          .figure = always<Figure::stress>,
          .first_keys = {"experiment", "seed", "particles.N", "time.steps", "shear.rate"},
          .set_first =
              [](Case& c) {
                c.time.steps = 1000;
                c.shear.rate = "10*cos(2*pi*50*t)";
              },
          .check = check_protocol,
          .keeps_step = true};
}

}  // namespace supple
