#include "supple/compat/particleshear/protocol.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "supple/core/error.hpp"
#include "supple/core/whole_number.hpp"
#include "supple/experiment/material.hpp"

namespace supple {
namespace {

constexpr double pi = std::numbers::pi;

void reject_what_the_package_lacks(const Case& c) {
  const auto reject = [](const std::string& key, const std::string& value, const std::string& instead) {
    throw input_error(key + " = \"" + value + "\" with physics = \"particleshear-1.0.2\"",
                      "the package does not have it", "use " + instead + ", or physics = \"documented\"");
  };
  const Material& m = c.material;
  if (m.elastic_law != "divergent" && m.elastic_law != "linear" && m.elastic_law != "plateau")
    reject("material.elastic_law", m.elastic_law, "\"divergent\", \"linear\" or \"plateau\"");
  if (m.tensile_law == "exponential")
    reject("material.tensile_law", m.tensile_law, "\"linear\" or \"saturating\"");
  if (c.is_given("material.slip") && m.slip != "reset") reject("material.slip", m.slip, "\"reset\"");
  if (c.is_given("material.lever_arm") && m.lever_arm != "radius")
    reject("material.lever_arm", m.lever_arm, "\"radius\"");
  if (c.box.boundary != "lees_edwards") reject("box.boundary", c.box.boundary, "\"lees_edwards\"");
  if (c.box.plates == "repulsive") reject("box.plates", c.box.plates, "\"capture\"");
}

ParticleShearConstants contact_constants(const Case& c, const MaterialConstants& stored,
                                         const ParticleShearScales& scales) {
  const Material& m = c.material;
  const MaterialConstants material = resolve_material(c, stored, scales.k, scales.mass);
  ParticleShearConstants p;
  p.k = *material.k;
  p.k_t = *material.k_t;
  p.nu = *material.nu;
  p.nu_t = *material.nu_t;
  p.mu = *material.mu;
  p.central_repulsion_coefficient = m.elastic_law == "linear" ? 0 : *material.central_repulsion_coefficient;
  p.permanent_ratio_central = *material.permanent_ratio_central;
  p.permanent_ratio_tangential = *material.permanent_ratio_tangential;
  p.keep_viscosity_coefficients_constant = *material.keep_viscosity_coefficients_constant;
  p.elastic = m.elastic_law == "plateau" ? ParticleShearElastic::plateau : ParticleShearElastic::divergent;
  p.tensile = m.tensile_law == "saturating" ? ParticleShearTensile::saturating : ParticleShearTensile::linear;
  p.plateau_begin = m.plateau_begin;
  p.plateau_end = m.plateau_end;
  p.plateau_slope = m.plateau_slope;
  p.tensile_range = m.tensile_range;
  return p;
}

void choose_time_steps(const Case& c, ParticleShearRun& run) {
  const double mu = c.material.friction, viscosity = c.material.relative_viscosity,
               amplitude = c.shear.amplitude;
  const double transversal = c.material.relative_transversal_link_strength;
  const double b = c.particles.bimodal_factor, tau = run.scales.tau;

  run.dt = 0.1 * tau / b;
  if (mu <= 1 || transversal < 1) run.dt /= 2;
  if (amplitude <= 0.05) run.dt /= 2;
  if (mu <= 0.1 || transversal < 0.1) run.dt /= 2;
  if (amplitude <= 0.005) run.dt /= 2;
  if (amplitude >= 0.5) run.dt /= 2;

  run.dt_max = 0.25 * tau / b;
  if ((viscosity <= 0.1 && mu < 0.1) || transversal < 0.1 || transversal > 5) run.dt_max = 0.125 * tau / b;
  if ((viscosity < 0.01 && mu < 0.01) || transversal < 0.01) run.dt_max = 0.04 * tau / b;
  run.dt = std::min(run.dt, run.dt_max);
  if (viscosity > 1) run.dt_max /= viscosity;

  run.first_dt_max = (viscosity <= 0.1 ? 0.2 : 0.25) * tau / b;
  if (c.particles.packing_fraction > 2) run.first_dt_max /= 2;
}

/// What the state's file says wins over the case, unless the user gave the key.
void take_from_state(const Case& c, const InitialState& initial, ParticleShearRun& run) {
  if (initial.units.name != particleshear_units().name)
    throw input_error(
        "a state in units \"" + initial.units.name + "\" with physics = \"particleshear-1.0.2\"",
        "the package computes in \"" + particleshear_units().name + "\"",
        "start from a state of this physics, or use physics = \"documented\"");
  const auto take = [&](const char* key, const auto& stored, auto& value) {
    if (stored && !c.is_given(key)) value = *stored;
  };
  const auto number = [&](const char* name) {
    const auto found = initial.protocol.find(name);
    return found == initial.protocol.end() ? std::optional<double>{} : found->second;
  };
  take("time.step", number("dt"), run.dt);
  take("shear.relative_frequency", number("f"), run.frequency);
  take("shear.amplitude", number("amplitude"), run.amplitude);
  take("shear.pre_periods", number("pre"), run.pre_periods);
  take("shear.periods", number("periods"), run.periods);
  take("shear.post_periods", number("post"), run.post_periods);
}

}  // namespace

ParticleShearScales particleshear_scales(int discs, double area, double packing_fraction,
                                         double young_modulus, double density, double size_ratio) {
  const double mean_square = (size_ratio + 1 / size_ratio) / 2;
  const Units units = particleshear_units();
  ParticleShearScales s;
  s.radius = std::sqrt(area * packing_fraction / discs / pi / mean_square);
  s.mass = density / units.density() * pi * s.radius * s.radius;
  s.k = pi / 8 * young_modulus / units.stiffness();
  s.tau = std::sqrt(s.mass / s.k) / std::sqrt(size_ratio);
  return s;
}

double ParticleShearRun::rate_at(std::int64_t step, double time) const {
  const double i = static_cast<double>(step);
  if (i < pre_periods / frequency / dt || i > (periods + pre_periods) / frequency / dt) return 0;
  return amplitude * std::cos(2 * pi * (time * frequency - pre_periods)) * 2 * pi * frequency;
}

namespace {
constexpr const char* frequency_to_do = "raise shear.relative_frequency";
}  // namespace

ParticleShearRun derive_particleshear(const Case& c, const InitialState* initial) {
  reject_what_the_package_lacks(c);
  const double um = particleshear_units().length;
  ParticleShearRun run;
  run.scales =
      particleshear_scales(c.particles.discs, c.box.width / um * (c.box.height / um),
                           c.particles.packing_fraction, c.material.young_modulus, c.material.density);
  run.constants = contact_constants(c, initial ? initial->material : MaterialConstants{}, run.scales);
  run.frequency = c.shear.relative_frequency / run.scales.tau;
  run.amplitude = c.shear.amplitude;
  run.pre_periods = c.shear.pre_periods;
  run.periods = c.shear.periods;
  run.post_periods = c.shear.post_periods;
  choose_time_steps(c, run);
  run.dt *= c.time.step_factor;
  if (c.time.time_step > 0) run.dt = c.time.time_step;
  if (initial) take_from_state(c, *initial, run);

  const double per_period = 1 / run.frequency / run.dt;
  const double steps = (run.periods + run.pre_periods + run.post_periods) / run.frequency / run.dt;
  run.steps = whole_number(std::floor(std::max(steps, 0.0)), "steps of the protocol", frequency_to_do);
  whole_number(per_period, "steps of a period", frequency_to_do);
  run.damping = std::pow(c.shear.cool_factor, 1 / (1 / run.frequency / run.dt));
  return run;
}

std::vector<Derived> derived_constants(const ParticleShearRun& run) {
  const ParticleShearConstants& p = run.constants;
  const double central = p.permanent_ratio_central, tangential = p.permanent_ratio_tangential;
  const bool keep = p.keep_viscosity_coefficients_constant;
  return name_constants({run.scales.mass, run.scales.tau, p.mu, p.k, p.k_t, p.nu, p.nu_t, p.k * central,
                         p.k_t * tangential, p.nu * (keep ? 1 : central), p.nu_t * (keep ? 1 : tangential)},
                        particleshear_units());
}

}  // namespace supple
