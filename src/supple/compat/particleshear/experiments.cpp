#include "supple/compat/particleshear/experiments.hpp"

#include <fmt/format.h>

#include "supple/compat/particleshear/demodulate.hpp"
#include "supple/compat/particleshear/protocol.hpp"
#include "supple/core/error.hpp"
#include "supple/experiment/suspension.hpp"

namespace supple::particleshear {

namespace {

std::vector<Derived> constants(const Case& c, const InitialState* initial) {
  return derived_constants(derive_particleshear(c, initial));
}

double time_step(const Case& c, const InitialState* initial) { return derive_particleshear(c, initial).dt; }

ShearProtocol protocol_of(const Case& c, const InitialState* initial) {
  const ParticleShearRun r = derive_particleshear(c, initial);
  return {{r.frequency, r.amplitude, r.pre_periods, r.periods, r.post_periods},
          demodulate_as_published,
          r.steps,
          r.steps,
          r.dt,
          r.damping,
          [r](std::int64_t step, double time) {
            return ShearRates{r.rate_at(step, time), 0};
          }};
}

MaterialConstants material_of(const ParticleShearConstants& p) {
  return {p.k,
          p.nu,
          p.k_t,
          p.nu_t,
          p.mu,
          p.central_repulsion_coefficient,
          p.permanent_ratio_central,
          p.permanent_ratio_tangential,
          p.keep_viscosity_coefficients_constant};
}

Suspension make(const Case& c, const InitialState* initial, Recorder& recorder) {
  const ParticleShearRun run = derive_particleshear(c, initial);
  const bool reset = !initial || initial->reset_force_each_step;
  auto stepper = std::make_unique<ParticleShearStepper>(run.constants,
                                                        reset ? PlateForce::reset : PlateForce::accumulate);
  ParticleShearStepper& package = *stepper;
  Suspension s{particleshear_units(),     {}, std::move(stepper), run.dt, run.damping,
               material_of(run.constants)};
  if (initial) {
    take_state(s, c, *initial, 2);
    return s;
  }
  if (resumed_part(recorder) == sheared_part) {
    package.set_plates(c.box.plates == "none" ? Plates::none : Plates::capture);
    return s;
  }
  ParticleShearPreparation preparation = begin_preparation(c);
  const Keep keep = in_part(preparation_part, [&](Keeper& k) {
    k("preparation", preparation);
    package.keep(k);
  });
  restore(recorder, keep, preparation_part);
  prepare_particleshear(c, run, package, preparation, [&](std::int64_t done, std::int64_t total) {
    if (done % 256 == 0) recorder.progress("prepare as the package does", done, total);
    recorder.safe_point(keep, "while preparing, at step", done);
  });
  s.system = std::move(preparation.system);
  return s;
}

const Matter& matter() {
  static const SuspensionModel model{
      constants, time_step, protocol_of,
      [](const Case&, const InitialState*, const ShearProtocol&) { return std::vector<Derived>{}; }, make};
  static const Matter discs = [] {
    Matter m = disc_matter();
    m.name = "discs of the published package";
    m.physics = "particleshear-1.0.2";
    m.suspension = &model;
    m.curves = {{"internal", "internal (overall tensor)"}, {"external", "external forces"}};
    return m;
  }();
  return discs;
}

/// The documented experiment, of the package's discs: these relax for numbers of steps of their own, and
/// their contacts have no energy.
Experiment of_package(Experiment e, const UsedKeys& more = {}) {
  e.matter = &matter();
  e.keys = with(with(e.keys, {"-preparation.stress_tolerance", "-preparation.max_time", "-output.energies"}),
                more);
  e.meaning = "as particleShear 1.0.2 computes it";
  return e;
}

}  // namespace

Experiment oscillatory_shear() {
  Experiment e = of_package(supple::oscillatory_shear());
  e.complete = [](Case& c) {
    if (!c.is_given("shear.periods")) c.shear.periods = 3;
  };
  e.doubt = [](const Case& c, Doubts& doubts) {
    if (c.shear.pre_periods == 0)
      doubts.push_back("shear.pre_periods = 0: drift and offset cannot be removed");
    if (c.shear.periods < 2)
      doubts.push_back(fmt::format(
          "shear.periods = {}: the first period is transient and there is no second to demodulate",
          c.shear.periods));
  };
  return e;
}

Experiment preparation() {
  return of_package(supple::preparation(), {"shear.amplitude", "shear.relative_frequency",
                                            "shear.cool_factor", "time.step", "time.step_factor"});
}

Experiment dynamics() { return of_package(supple::dynamics(), {"shear.amplitude"}); }

}  // namespace supple::particleshear
