/// How the published package prepares a suspension: fixed numbers of steps, first coarse and damped, then
/// finer.
#include <cmath>
#include <numbers>

#include "supple/compat/particleshear/protocol.hpp"
#include "supple/core/random.hpp"
#include "supple/experiment/suspension.hpp"
#include "supple/model/discs.hpp"
#include "supple/model/sanity.hpp"

namespace supple {
namespace {

using Stage = ParticleShearStage;
using Stages = std::vector<Stage>;
using Friction = Stage::Friction;
using Then = Stage::Then;

/// Without plates: n frictionless steps at each of dt_max, dt_max/2, ... while above dt, with less and less
/// damping and the mean velocity taken out; then n at dt without friction; then n with it (`last`).
void relax_freely(Stages& stages, int n, double dt_max, double dt, Friction last = Friction::on) {
  double damping = 0.5;
  for (double step = dt_max; step > dt; step /= 2) {
    stages.push_back({n, step, damping, Friction::off, Plates::none, Then::remove_drift});
    damping = (1 + damping) / 2;
  }
  stages.push_back({n, dt, 1, Friction::off, Plates::none});
  stages.push_back({n, dt, 1, last, Plates::none});
}

/// The suspension before it is crosslinked.
void relax_suspension(Stages& stages, const Case& c, const ParticleShearRun& run) {
  const double amplitude = c.shear.amplitude;
  const bool reenforced = c.material.interface_reenforcement_central != 1;
  const int coarse = reenforced ? 100 : 300, fine = reenforced ? 100 : 200;
  relax_freely(stages, coarse, run.first_dt_max, run.dt);
  if (amplitude <= 0.01 || c.material.relative_transversal_link_strength < 0.1)
    relax_freely(stages, coarse, run.first_dt_max, run.dt);
  relax_freely(stages, fine, run.dt_max, run.dt);
  if (amplitude <= 0.01 && !reenforced) relax_freely(stages, fine, run.dt_max, run.dt);
  if (amplitude <= 0.001 && !reenforced) relax_freely(stages, fine, run.dt_max, run.dt);
}

/// Where relaxations start once there are links.
double linked_dt_max(const Case& c, const ParticleShearRun& run) {
  const double dt_max = std::min(2 * run.dt, run.dt_max);
  return c.material.relative_transversal_link_strength > 5 ? dt_max / 2 : dt_max;
}

/// The crosslinked particles; the smaller the amplitude, the longer. Returns the dt_max that is in force
/// afterwards.
double relax_linked(Stages& stages, const Case& c, const ParticleShearRun& run) {
  const double amplitude = c.shear.amplitude;
  double dt_max = linked_dt_max(c, run);
  relax_freely(stages, 300, dt_max, run.dt);
  if (amplitude < 0.1) {
    relax_freely(stages, 150, dt_max, run.dt, Friction::off);
    relax_freely(stages, 150, dt_max, run.dt);
  }
  for (const double limit : {0.01, 0.001, 0.0001}) {
    if (amplitude > limit) continue;
    relax_freely(stages, 100, dt_max, run.dt);
    relax_freely(stages, 100, dt_max, run.dt, Friction::off);
    relax_freely(stages, 100, dt_max, run.dt);
  }
  const bool reenforced =
      c.material.interface_reenforcement_central != 1 || c.material.interface_reenforcement_tangential != 1;
  if (amplitude <= 0.001 && reenforced) {
    dt_max /= 3;
    relax_freely(stages, 200, dt_max, run.dt);
    relax_freely(stages, 200, dt_max, run.dt, Friction::off);
    relax_freely(stages, 200, dt_max, run.dt);
  }
  return dt_max;
}

/// Between the plates and with friction; longer where little dissipates or little stress is to be measured.
void relax_between_plates(Stages& stages, const Case& c, const ParticleShearRun& run, double dt_max) {
  const double mu = c.material.friction, amplitude = c.shear.amplitude;
  double factor = 1;
  if (mu <= 0.1) factor *= 1.5;
  if (mu <= 0.01) factor *= 2;
  if (mu <= 0.001) factor *= 2;
  if (amplitude <= 0.01) factor *= 1 - (std::log10(amplitude) + 2);
  if (amplitude <= 0.005) factor *= 2;
  if (c.material.relative_viscosity <= 0.1) factor *= 2;
  const int n = 25 * static_cast<int>(factor);
  const auto add = [&](int steps, double dt, double damping) {
    stages.push_back({steps, dt, damping, Friction::on, Plates::capture});
  };
  double damping = 0.5;
  for (double step = dt_max > run.dt ? dt_max : 10 * run.dt; step > run.dt; step /= 2) {
    add(n / 2, step, damping);
    damping = (1 + damping) / 2;
  }
  add(2 * n, run.dt, 0.98);
  add(n, run.dt, run.damping);
}

/// The package does not weigh by mass.
void remove_mean_velocity(State<2>& s) {
  Vec2 mean{};
  for (const Vec2& v : s.velocity) mean += (1.0 / s.size()) * v;
  for (Vec2& v : s.velocity) v -= mean;
}

}  // namespace

System<2> package_discs(const Box<2>& box, const DiscSpec& spec, std::uint64_t seed) {
  const double b = spec.size_ratio, mean_square = (b + 1 / b) / 2;  // of sqrt(b) and 1/sqrt(b)
  const double unit =
      std::sqrt(spec.packing_fraction * box.volume() / (spec.count * std::numbers::pi * mean_square));
  std::vector<Vec2> position = random_discs(box, spec, seed).state.position;
  std::vector<double> radius;
  for (std::size_t i = 0; i < position.size(); ++i) {
    position[i] = {std::floor(position[i][0]), std::floor(position[i][1])};
    const bool large = RandomStream(seed, Purpose::disc_size, i).below(2) == 1;
    radius.push_back(unit * (large ? std::sqrt(b) : 1 / std::sqrt(b)));
  }
  return listed_discs(box, position, radius, spec.density * mean_square);
}

std::vector<ParticleShearStage> particleshear_preparation(const Case& c, const ParticleShearRun& run) {
  Stages stages;
  relax_suspension(stages, c, run);
  double dt_max = run.dt_max;
  if (c.particles.permanent_links) {
    stages.back().then = Then::link;
    dt_max = relax_linked(stages, c, run);
  }
  relax_between_plates(stages, c, run, dt_max);
  return stages;
}

ParticleShearPreparation begin_preparation(const Case& c) {
  const Units units = particleshear_units();
  const Particles& p = c.particles;
  ParticleShearPreparation begin;
  begin.system =
      package_discs(make_box(c, units),
                    {p.discs, p.packing_fraction, p.bimodal_factor, c.material.density / units.density()},
                    static_cast<std::uint64_t>(c.general.seed));
  require_sane(begin.system, "this suspension");
  std::vector<double>& angle = begin.system.state.angle;
  std::fill(angle.begin(), angle.end(), -std::numbers::pi / 2);
  return begin;
}

void prepare_particleshear(const Case& c, const ParticleShearRun& run, ParticleShearStepper& stepper,
                           ParticleShearPreparation& state,
                           const std::function<void(std::int64_t, std::int64_t)>& progress) {
  System<2>& system = state.system;
  const Stages stages = particleshear_preparation(c, run);
  std::int64_t total = 0;
  for (const Stage& stage : stages) total += stage.steps;
  for (; state.stage < static_cast<std::int64_t>(stages.size()); ++state.stage, state.step = 0) {
    const Stage& stage = stages[static_cast<std::size_t>(state.stage)];
    stepper.set_friction(stage.friction == Friction::on ? run.constants.mu : 0);
    stepper.set_plates(stage.plates == Plates::capture && c.box.plates == "none" ? Plates::none
                                                                                 : stage.plates);
    for (; state.step < stage.steps; ++state.step) {
      if (progress) progress(system.step, total);
      stepper.evaluate(system, {});
      stepper.advance(system, {}, stage.dt, stage.damping);
    }
    if (stage.then == Then::remove_drift) remove_mean_velocity(system.state);
    if (stage.then == Then::link) {
      stepper.update_neighbors(system);
      CrosslinkSpec spec = crosslink_spec(c);
      spec.join = IsolatedJoin::last;
      crosslink(system, spec, static_cast<std::uint64_t>(c.general.seed));
    }
  }
  system.time = 0;
  system.step = 0;
}

}  // namespace supple
