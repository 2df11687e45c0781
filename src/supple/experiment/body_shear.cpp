#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>

#include "supple/core/error.hpp"
#include "supple/experiment/body_rheology.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/experiment/jam.hpp"
#include "supple/experiment/key_sets.hpp"
#include "supple/experiment/moduli.hpp"
#include "supple/experiment/shear_protocol.hpp"
#include "supple/experiment/sheared_bodies.hpp"
#include "supple/experiment/suspension.hpp"
#include "supple/experiment/way_to_jam.hpp"

namespace supple {

namespace {

/// Particles of the state, or random ones, jammed.
Packing<2> jammed_packing(const Case& c, const InitialState* initial, Recorder& recorder) {
  Packing<2> packing = make_periodic_packing(c, initial, sheared(at_random(recorder)));
  restore_sheared(packing, recorder);
  if (initial || resumed_part(recorder) == sheared_part) return packing;
  packing.minimise.stop_requested = [&recorder] { return recorder.stop_requested(); };
  WayToJam way(c.jamming.pressure);
  JamState<2> state;
  const Keep keep = in_part("jam", [&](Keeper& k) {
    k("packing", packing);
    k("jam", state);
  });
  restore(recorder, keep, "jam");
  jam(
      packing, jam_spec(c), state, [&] { recorder.hold(keep, "after minimisation", state.minimisations()); },
      [&](const JamProgress<2>& p) {
        recorder.progress("jam", static_cast<std::int64_t>(999 * way.share(p)), 1000);
        return true;
      });
  return packing;
}

OscillatoryProtocol protocol_of(const Case& c, const InitialState* initial, const BodyLaws& laws,
                                Packing<2>& packing) {
  return oscillatory_protocol(c, initial, c.shear.relative_frequency / laws.tau,
                              sheared_body_step(c, laws, packing));
}

std::vector<Derived> derived_shear(const Packing<2>& packing, const BodyLaws& laws,
                                   const OscillatoryProtocol& p, double damping) {
  std::vector<Derived> all = derived_packing(packing);
  for (Derived& d : derived_laws(laws)) all.push_back(std::move(d));
  for (Derived& d : derived_protocol(windows_of(p), "")) all.push_back(std::move(d));
  all.push_back({{"time_step", "", "time step"}, p.time_step()});
  all.push_back(
      {{"damping_factor", "", "factor per step on motion of particles relative to the flow"}, damping});
  all.push_back({{"steps_per_period", "", "steps per period"}, static_cast<double>(p.steps_per_period)});
  all.push_back({{"steps", "", "steps of the protocol"}, static_cast<double>(p.steps())});
  return all;
}

double damping_of(const Case& c, const OscillatoryProtocol& p) {
  return std::pow(c.shear.cool_factor, p.periods(1));
}

/// G'' by what was lost: energy per measured cycle over pi A^2 and the area of the cell.
double dissipated_modulus(const std::vector<double>& lost, const OscillatoryProtocol& p, int cycles,
                          const Packing<2>& packing) {
  const auto end = static_cast<std::size_t>(p.pre_steps + p.shear_steps),
             begin = end - static_cast<std::size_t>(cycles * p.steps_per_period);
  return (lost[end] - lost[begin]) / (cycles * std::numbers::pi * p.amplitude * p.amplitude *
                                      packing.system.box.volume() * packing.pressure_unit);
}

void record_moduli(const BodyStressTable& table, const std::vector<double>& lost,
                   const OscillatoryProtocol& p, const Packing<2>& packing, Recorder& recorder) {
  const auto record = [&](const char* name, const std::vector<double>& stress, const char* meaning) {
    const StressSeries series{name, meaning, packing.pressure_symbol, table.column("t"), stress};
    return Estimate{name, series.unit, record_modulus(series, windows_of(p), fit_harmonics, recorder)};
  };
  const Estimate total =
                     record("total", table.column("shear_stress_total"), "the virial with the kinetic part"),
                 virial = record("virial", table.column("shear_stress_virial"),
                                 "the virial of shapes, contacts and links");
  if (table.has_plates())
    record("plates", table.column("shear_stress_plates"),
           "forces from outside, of plates and of images beyond them, over the width");
  recorder.value("results", {"cycles", "", "whole cycles of shear that were demodulated"},
                 total.found.cycles);
  warn_if_apart(total, virial, "particles move against each other by inertia; lower shear.relative_frequency",
                recorder);
  warn_of_drift(total, recorder);
  const double dissipated = dissipated_modulus(lost, p, total.found.cycles, packing);
  recorder.value("results",
                 {"dissipated_modulus", packing.pressure_symbol,
                  "G'' from the energy lost in a cycle, which that of the stress is in a steady one"},
                 dissipated);
  Estimate by_losses = total;
  by_losses.name = "dissipated";
  by_losses.found.loss.value = dissipated;
  warn_if_apart(total, by_losses,
                "what the cycles take goes into motion and shapes; more shear.periods, or a lower "
                "shear.relative_frequency",
                recorder);
  const std::vector<double> pressures = table.column("pressure");
  recorder.value(
      "results", {"mean_pressure", packing.pressure_symbol, "mean of the pressure over the protocol"},
      std::accumulate(pressures.begin(), pressures.end(), 0.0) / static_cast<double>(pressures.size()));
}

std::vector<Derived> derive_body_shear(const Case& c, const InitialState* initial) {
  Packing<2> packing = make_periodic_packing(c, initial, sheared(set_apart));
  const BodyLaws laws = body_laws(c, packing);
  const OscillatoryProtocol p = protocol_of(c, initial, laws, packing);
  plates_of_bodies(c);
  return derived_shear(packing, laws, p, damping_of(c, p));
}

void run_body_shear(const Case& c, const InitialState* initial, Recorder& recorder) {
  Packing<2> packing = jammed_packing(c, initial, recorder);
  const BodyLaws laws = body_laws(c, packing);
  OscillatoryProtocol p = protocol_of(c, initial, laws, packing);
  const bool goes_on = resumed_part(recorder) == sheared_part;
  const Keep more = [&](Keeper& k) { k("protocol", p); };
  restore(recorder, more, sheared_part);
  const double damping = damping_of(c, p);
  add_rheology(laws, packing);
  begin_packing(packing, derived_shear(packing, laws, p, damping), recorder);
  link_packing(c, packing, recorder);
  if (!goes_on) packing.system.time = 0, packing.system.step = 0;
  ShearedBodies bodies(c, initial, packing, recorder);
  try {
    bodies.move({"oscillatory shear", p.steps(), p.steps() + 1, std::max(c.output.images, c.output.frames),
                 p.time_step(), damping, [&](std::int64_t step, double) { return p.rates(step); }},
                more);
  } catch (const Error& e) {
    if (e.kind() != ErrorKind::interrupted) throw;
    if (const auto cycles = whole_cycles(windows_of(p), bodies.table().column("t"))) {
      OscillatoryProtocol stopped = p;
      stopped.shear_steps = std::llround(cycles->periods) * p.steps_per_period;
      stopped.post_steps = 0;
      record_moduli(bodies.table(), bodies.lost(), stopped, packing, recorder);
    }
    throw;
  }
  record_moduli(bodies.table(), bodies.lost(), p, packing, recorder);
  bodies.finish();
  recorder.value("results", {"cpu_time", "s", "processor time of the run"}, recorder.cpu_time());
}

}  // namespace

Experiment body_shear() {
  return {.name = "oscillatory_shear",
          .meaning = "the same of deformable particles, jammed and linked",
          .matter = &body_matter(),
          .keys = with(with(minimised_keys(), rubbing_keys()),
                       {"jamming.*", "shear.*", "-shear.rate", "time.step", "time.step_factor", "output.*",
                        "-output.energies", "-output.relative_y_scale_force", "-output.text"}),
          .needs = {{"jamming.packing_fraction jamming.step jamming.pressure jamming.window jamming.search "
                     "jamming.pressure_kind minimise.method minimise.force_tolerance minimise.least_force "
                     "minimise.max_evaluations",
                     Need::Of::value, [](const Case& c) { return !starts_from_file(c); },
                     "particles made from [bodies]: those of a file are sheared as they are"}},
          .derive = derive_body_shear,
          .run = run_body_shear,
          .figure = always<Figure::stress>,
          .first_keys = {"experiment", "physics", "seed", "bodies.family", "bodies.N", "bodies.vertices",
                         "jamming.pressure", "particles.cut_lines", "material.friction", "shear.amplitude"},
          .set_first = [](Case& c) { c.jamming.pressure = 1e-2; },
          .doubt = doubt_periods};
}

}  // namespace supple
