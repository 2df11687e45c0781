#include <algorithm>
#include <cmath>
#include <ctime>
#include <numbers>
#include <numeric>
#include <string>

#include "supple/core/error.hpp"
#include "supple/core/expression.hpp"
#include "supple/experiment/body_rheology.hpp"
#include "supple/experiment/body_stress_table.hpp"
#include "supple/experiment/energy_table.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/experiment/frame_schedule.hpp"
#include "supple/experiment/jam.hpp"
#include "supple/experiment/moduli.hpp"
#include "supple/experiment/shear_protocol.hpp"
#include "supple/experiment/sound_states.hpp"
#include "supple/experiment/suspension.hpp"
#include "supple/experiment/way_to_jam.hpp"
#include "supple/solve/disc_dynamics.hpp"

namespace supple {

namespace {

Making sheared(Making making) {
  making.flow = Flow::kept;
  return making;
}

void refuse_rigid(const Packing& packing) {
  if (!packing.system.rigid.empty())
    throw input_error("shear of rigid particles", "rigid polygons cross no sheared boundary yet",
                      "choose another family, or discs (bodies.family = \"disc\")");
}

/// Particles of the state, or random ones, jammed.
Packing jammed_packing(const Case& c, const InitialState* initial, Recorder& recorder) {
  Packing packing = make_periodic_packing(c, initial, sheared(at_random(recorder)));
  refuse_rigid(packing);
  if (initial) return packing;
  packing.minimise.stop_requested = [&recorder] { return recorder.stop_requested(); };
  WayToJam way(c.jamming.pressure);
  jam(packing, jam_spec(c), [&](const JamProgress& p) {
    recorder.progress("jam", static_cast<std::int64_t>(999 * way.share(p)), 1000);
    return !recorder.stop_requested();
  });
  return packing;
}

OscillatoryProtocol protocol_of(const Case& c, const InitialState* initial, const BodyLaws& laws,
                                Packing& packing) {
  return oscillatory_protocol(c, initial, c.shear.relative_frequency / laws.tau,
                              sheared_body_step(c, laws, packing));
}

std::vector<Derived> derived_shear(const Packing& packing, const BodyLaws& laws, const OscillatoryProtocol& p,
                                   double damping) {
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

/// Velocities of the instant of the positions; the packing's own report of everything else.
Frame sheared_frame(Packing& packing, const DiscDynamics& dynamics, double rate_now) {
  Frame frame = packing_frame(packing, report_packing(packing));
  dynamics.bring_to_instant(packing.system, rate_now, frame.velocity, frame.spin);
  frame.strain_rate = rate_now;
  return frame;
}

/// The particles of a packing in motion, sheared: with their laws and links, tables and account.
class ShearedBodies {
 public:
  ShearedBodies(const Case& c, const InitialState* initial, Packing& packing, Recorder& recorder)
      : packing_(packing),
        recorder_(recorder),
        dynamics_(*packing.field),
        table_(packing, c.output.tensors, recorder),
        energies_(recorder, dynamics_, packing.system, reduced_units(), c, initial) {}

  const BodyStressTable& table() const { return table_; }
  const std::vector<double>& lost() const { return energies_.lost(); }

  /// So many steps, each at rates(i), of which one frame in so many is kept. Hands over the last good state
  /// where it stops.
  template <class Rates>
  void move(const char* phase, std::int64_t steps, double dt, double damping, int frames,
            const Rates& rates_at) {
    System<2>& s = packing_.system;
    FrameSchedule schedule(steps, frames);
    LastGood good(packing_);
    try {
      for (std::int64_t i = 0; i <= steps; ++i) {
        const ShearRates rates = rates_at(i);
        const bool keeps_frame = schedule.due(i);
        if (keeps_frame || i % look_interval(steps) == 0) good.look();
        const Evaluation<2>& now = dynamics_.evaluate_energies(s, rates);
        table_.append(now, rates.now);
        energies_.append(s, now);
        if (keeps_frame) recorder_.frame(sheared_frame(packing_, dynamics_, rates.now));
        if (recorder_.stop_requested())
          throw Error(ErrorKind::interrupted, "interrupted at step " + std::to_string(i));
        if (i < steps) dynamics_.advance(s, rates, dt, damping);
        if (i % 256 == 0) recorder_.progress(phase, i, steps);
      }
    } catch (const Error&) {
      energies_.finish();
      hand_over(packing_, recorder_);
      throw;
    }
    recorder_.progress(phase, steps, steps);
  }

  /// What the account says, and the packing at the end.
  void finish() {
    const Evaluation<2>& last = dynamics_.evaluate_energies(packing_.system, {});
    energies_.finish();
    recorder_.value("results",
                    {"energy_residual", "", "what the balance of energy lacks, over all that was lost"},
                    energies_.relative_residual(packing_.system, last));
    record_packing(packing_, {}, recorder_);
  }

 private:
  Packing& packing_;
  Recorder& recorder_;
  DiscDynamics dynamics_;
  BodyStressTable table_;
  EnergyTable energies_;
};

/// Links them, where the case says so and they are not.
void link_packing(const Case& c, Packing& packing, Recorder& recorder) {
  if (c.particles.permanent_links && packing.system.links.empty())
    recorder.value("results", {"clusters", "", "clusters of particles that links hold together"},
                   crosslink_bodies(c, packing));
  recorder.value("results", {"links", "", "permanent links of vertices"},
                 static_cast<double>(packing.system.links.size()));
}

/// G'' by what was lost: energy per measured cycle over pi A^2 and the area of the cell.
double dissipated_modulus(const std::vector<double>& lost, const OscillatoryProtocol& p, int cycles,
                          const Packing& packing) {
  const auto end = static_cast<std::size_t>(p.pre_steps + p.shear_steps),
             begin = end - static_cast<std::size_t>(cycles * p.steps_per_period);
  return (lost[end] - lost[begin]) / (cycles * std::numbers::pi * p.amplitude * p.amplitude *
                                      packing.system.box.volume() * packing.pressure_unit);
}

void record_moduli(const BodyStressTable& table, const std::vector<double>& lost,
                   const OscillatoryProtocol& p, const Packing& packing, Recorder& recorder) {
  const auto record = [&](const char* name, const std::vector<double>& stress, const char* meaning) {
    const StressSeries series{name, meaning, packing.pressure_symbol, table.time, stress};
    return Estimate{name, series.unit,
                    record_modulus(series, windows_of(p), DriftCorrection::right, recorder)};
  };
  const Estimate total = record("total", table.total, "the virial with the kinetic part"),
                 virial = record("virial", table.virial, "the virial of shapes, contacts and links");
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
  recorder.value("results",
                 {"mean_pressure", packing.pressure_symbol, "mean of the pressure over the protocol"},
                 std::accumulate(table.pressures.begin(), table.pressures.end(), 0.0) /
                     static_cast<double>(table.pressures.size()));
}

std::vector<Derived> derived_dynamics(const Case& c, Packing& packing, const BodyLaws& laws) {
  std::vector<Derived> all = derived_packing(packing);
  for (Derived& d : derived_laws(laws)) all.push_back(std::move(d));
  all.push_back({{"time_step", "", "time step"}, sheared_body_step(c, laws, packing)});
  all.push_back({{"steps", "", "steps"}, static_cast<double>(c.time.steps)});
  return all;
}

}  // namespace

std::vector<Derived> derive_body_shear(const Case& c, const InitialState* initial) {
  Packing packing = make_periodic_packing(c, initial, sheared(set_apart));
  refuse_rigid(packing);
  const BodyLaws laws = body_laws(c, packing);
  const OscillatoryProtocol p = protocol_of(c, initial, laws, packing);
  return derived_shear(packing, laws, p, damping_of(c, p));
}

void run_body_shear(const Case& c, const InitialState* initial, Recorder& recorder) {
  const std::clock_t start = std::clock();
  Packing packing = jammed_packing(c, initial, recorder);
  const BodyLaws laws = body_laws(c, packing);
  const OscillatoryProtocol p = protocol_of(c, initial, laws, packing);
  const double damping = damping_of(c, p);
  add_rheology(laws, packing);
  begin_packing(packing, derived_shear(packing, laws, p, damping), recorder);
  link_packing(c, packing, recorder);
  packing.system.time = 0;
  packing.system.step = 0;
  ShearedBodies bodies(c, initial, packing, recorder);
  bodies.move("oscillatory shear", p.steps(), p.time_step(), damping,
              std::max(c.output.images, c.output.frames), [&](std::int64_t i) { return p.rates(i); });
  record_moduli(bodies.table(), bodies.lost(), p, packing, recorder);
  bodies.finish();
  recorder.value("results", {"cpu_time", "s", "processor time of the run"},
                 static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
}

std::vector<Derived> derive_sheared_dynamics(const Case& c, const InitialState* initial) {
  Packing packing = make_packing(c, initial, c.jamming.packing_fraction, sheared(set_apart));
  refuse_rigid(packing);
  const Expression rate(c.shear.rate, {"t"}, "[shear] rate");
  return derived_dynamics(c, packing, body_laws(c, packing));
}

void run_sheared_dynamics(const Case& c, const InitialState* initial, Recorder& recorder) {
  Packing packing = make_packing(c, initial, c.jamming.packing_fraction, sheared(at_random(recorder)));
  refuse_rigid(packing);
  const Expression rate(c.shear.rate, {"t"}, "[shear] rate");
  const BodyLaws laws = body_laws(c, packing);
  const double dt = sheared_body_step(c, laws, packing);
  start_clock(packing.system, c);
  const double begin = packing.system.time;
  add_rheology(laws, packing);
  begin_packing(packing, derived_dynamics(c, packing, laws), recorder);
  link_packing(c, packing, recorder);
  ShearedBodies bodies(c, initial, packing, recorder);
  bodies.move("dynamics", c.time.steps, dt,
              std::pow(c.shear.cool_factor, dt * c.shear.relative_frequency / laws.tau), c.output.frames,
              [&](std::int64_t i) {
                const double t = begin + static_cast<double>(i) * dt;
                return ShearRates{rate(t), i < c.time.steps ? rate(t + 0.5 * dt) : rate(t)};
              });
  bodies.finish();
}

}  // namespace supple
