#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>
#include <numbers>

#include "supple/core/error.hpp"
#include "supple/core/whole_number.hpp"
#include "supple/experiment/energy_table.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/experiment/frame.hpp"
#include "supple/experiment/frame_schedule.hpp"
#include "supple/experiment/key_sets.hpp"
#include "supple/experiment/microgel.hpp"
#include "supple/experiment/moduli.hpp"
#include "supple/experiment/particleshear_protocol.hpp"
#include "supple/experiment/shear_protocol.hpp"
#include "supple/experiment/suspension.hpp"

namespace supple {

namespace {

/// The protocol in either fidelity: rates at the beginning of each step, windows of the demodulation.
struct ShearProtocol {
  Protocol windows;
  DriftCorrection correction;
  std::int64_t steps,
      rows;  ///< one row a step; the documented protocol closes with the instant after the last
  double time_step, damping;
  std::function<ShearRates(std::int64_t step, double time)> rates;
};

ShearProtocol make_protocol(const Case& c, const InitialState* initial) {
  if (is_package(c)) {
    const ParticleShearRun r = derive_particleshear(c, initial);
    return {{r.frequency, r.amplitude, r.pre_periods, r.periods, r.post_periods},
            DriftCorrection::published,
            r.steps,
            r.steps,
            r.dt,
            r.damping,
            [r](std::int64_t step, double time) {
              return ShearRates{r.rate_at(step, time), 0};
            }};
  }
  const MicrogelConstants k = derive_constants(c, initial);
  const OscillatoryProtocol p = oscillatory_protocol(c, initial, k.frequency, k.time_step);
  return {windows_of(p),
          DriftCorrection::right,
          p.steps(),
          p.steps() + 1,
          p.time_step(),
          std::pow(c.shear.cool_factor, p.periods(1)),
          [p](std::int64_t step, double) { return p.rates(step); }};
}

/// Of the suspension that is to be made, or of the state.
Gap expected_gap(const Case& c, const InitialState* initial, const MicrogelConstants& k) {
  if (initial) return gap_of(initial->system, initial->units);
  return {c.box.height, c.particles.discs * k.mean_mass / (c.box.width * c.box.height)};
}

/// Shear modulus of a triangular lattice of links with springs k and k_t, sqrt(3)/4 (k + k_t): scaffolds,
/// whose discs are in disorder, are softer (0.76 k for 0.87 k with the default laws).
double scaffold_modulus(const MicrogelConstants& k) {
  return 0.25 * std::numbers::sqrt3 * (k.law.link.k + k.law.link.k_t);
}

std::vector<Derived> derive_oscillatory_shear(const Case& c, const InitialState* initial) {
  const ShearProtocol p = make_protocol(c, initial);
  std::vector<Derived> all = is_package(c) ? derived_constants(derive_particleshear(c, initial))
                                           : derived_constants(derive_constants(c, initial));
  for (Derived& d : derived_protocol(p.windows, "Hz")) all.push_back(std::move(d));
  all.push_back({{"time_step", "s", "time step"}, p.time_step});
  all.push_back({{"damping_factor", "", "factor per step on velocity relative to the flow"}, p.damping});
  all.push_back({{"steps_per_period", "", "steps per period"}, 1 / (p.windows.frequency * p.time_step)});
  all.push_back({{"steps", "", "steps of the protocol"}, static_cast<double>(p.steps)});
  if (!is_package(c)) {
    const MicrogelConstants k = derive_constants(c, initial);
    all.push_back({{"wavelength_over_gap_of_scaffold", "",
                    "shear wave of a crosslinked scaffold over the gap; softer samples have shorter waves"},
                   expected_gap(c, initial, k).wavelengths(scaffold_modulus(k), p.windows.frequency)});
  }
  return all;
}

void run_oscillatory_shear(const Case& c, const InitialState* initial, Recorder& recorder) {
  const std::clock_t start = std::clock();
  const ShearProtocol protocol = make_protocol(c, initial);
  Suspension s = make_suspension(c, initial, recorder);
  s.system.time = 0;
  s.system.step = 0;
  recorder.begin(make_run_info(s.system, s.units));
  s.time_step = protocol.time_step;
  s.damping = protocol.damping;
  record_constants(s, initial, derive_oscillatory_shear(c, initial), recorder);

  StressTable table(recorder, s.units, c.output.tensors, s.system, initial);
  std::optional<EnergyTable> energies;
  if (c.output.energies && s.stepper->has_energies())
    energies.emplace(recorder, *s.stepper, s.system, s.units, c, initial);
  FrameSchedule frames(protocol.rows - 1, std::max(c.output.images, c.output.frames));
  for (std::int64_t i = 0; i < protocol.rows; ++i) {
    const ShearRates rates = protocol.rates(i, s.system.time);
    const bool keeps_frame = frames.due(i);
    const Evaluation<2>& evaluation =
        keeps_frame ? s.stepper->evaluate_energies(s.system, rates) : s.stepper->evaluate(s.system, rates);
    table.append(s.system, evaluation, rates.now);
    if (energies) energies->append(s.system, evaluation);
    if (keeps_frame) recorder.frame(frame_of(s, evaluation, rates));
    if (recorder.stop_requested()) {
      if (energies) energies->finish();
      table.finish(s.system, evaluation);
      throw Error(ErrorKind::interrupted, "interrupted at step " + std::to_string(i));
    }
    if (i < protocol.steps) s.stepper->advance(s.system, rates, s.time_step, s.damping);
    if (i % 256 == 0) recorder.progress("oscillatory shear", i, protocol.steps);
  }
  recorder.progress("oscillatory shear", protocol.steps, protocol.steps);
  const Evaluation<2>& last = s.stepper->evaluate(s.system, {});
  if (energies) energies->finish();
  table.finish(s.system, last);
  record_moduli(table, protocol.windows, protocol.correction, gap_of(s.system, s.units), recorder);
  record_counts(s.system, last, recorder);
  recorder.value("results", {"cpu_time", "s", "processor time of the run"},
                 static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
}

void check_boundary(const Case& c, Problems& problems) {
  if (c.box.boundary != "lees_edwards")
    add_problem(problems, c, fmt::format("box.boundary = \"{}\" cannot be sheared", c.box.boundary),
                "oscillatory_shear strains the cell",
                "set boundary = \"lees_edwards\", or experiment = \"dynamics\"");
}

void doubt_protocol(const Case& c, Doubts& doubts) {
  if (is_package(c) && c.shear.pre_periods == 0)
    doubts.push_back("shear.pre_periods = 0: drift and offset cannot be removed");
  doubt_periods(c, doubts);
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
          .doubt = doubt_protocol};
}

}  // namespace supple
