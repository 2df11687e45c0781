#include "supple/experiment/microgel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "supple/core/error.hpp"
#include "supple/core/expression.hpp"
#include "supple/model/discs.hpp"

namespace supple {

namespace {

constexpr double pi = std::numbers::pi;

/// Number from the state file unless the user gave the key.
double from_state(const Case& c, const char* key, std::optional<double> stored, double unit, double of_case) {
  return stored && !c.is_given(key) ? *stored * unit : of_case;
}

void set_masses(const Case& c, const InitialState* initial, MicrogelConstants& k) {
  std::vector<double> mass;
  if (initial) {
    mass = initial->system.state.mass;
    for (double& m : mass) m *= initial->units.mass;
  } else {
    const DiscSpec spec{c.particles.discs, c.particles.packing_fraction, c.particles.bimodal_factor, c.material.density};
    for (double r : bimodal_radii(spec, c.box.width * c.box.height, static_cast<std::uint64_t>(c.general.seed)))
      mass.push_back(c.material.density * pi * r * r);
  }
  double sum = 0;
  for (double m : mass) sum += m;
  k.mean_mass = sum / static_cast<double>(mass.size());
  k.smallest_mass = *std::min_element(mass.begin(), mass.end());
}

/// Stiffness and viscosity of contacts: re-enforced, while links keep the base values. SI; every constant is set.
MaterialConstants resolve_material(const Case& c, const InitialState* initial, const MicrogelConstants& k) {
  const Material& m = c.material;
  const MaterialConstants stored = initial ? initial->material : MaterialConstants{};
  const Units units = initial ? initial->units : si_units();
  const double central = m.interface_reenforcement_central, tangential = m.interface_reenforcement_tangential;
  const double viscosity = m.relative_viscosity * std::sqrt(k.mean_mass * k.k);
  const double transversal = m.relative_transversal_link_strength;
  const auto take = [&](const char* key, std::optional<double> of_state, double unit, double of_case) {
    return from_state(c, key, of_state, unit, of_case);
  };

  MaterialConstants out;
  const char* keep_key = "material.keep_viscosity_coefficients_constant";
  out.keep_viscosity_coefficients_constant = c.is_given(keep_key)
      ? m.keep_viscosity_coefficients_constant
      : stored.keep_viscosity_coefficients_constant.value_or(m.keep_viscosity_coefficients_constant);
  const bool keep = *out.keep_viscosity_coefficients_constant;
  out.k = take("material.young_modulus", stored.k, units.stiffness(), k.k * central);
  out.k_t = take("material.young_modulus", stored.k_t, units.stiffness(), k.k * transversal * tangential);
  out.nu = take("material.relative_viscosity", stored.nu, units.viscosity(), viscosity * (keep ? 1 : central));
  out.nu_t = take("material.relative_viscosity", stored.nu_t, units.viscosity(),
                  viscosity * transversal * (keep ? 1 : tangential));
  out.mu = take("material.friction", stored.mu, 1, m.friction);
  out.central_repulsion_coefficient = take("material.central_repulsion_coefficient",
                                           stored.central_repulsion_coefficient, 1, m.central_repulsion_coefficient);
  out.permanent_ratio_central = take("material.interface_reenforcement_central", stored.permanent_ratio_central, 1,
                                     1 / central);
  out.permanent_ratio_tangential = take("material.interface_reenforcement_tangential",
                                        stored.permanent_ratio_tangential, 1, 1 / tangential);
  return out;
}

DiscLaw make_law(const Material& m, const MaterialConstants& material) {
  const double central = *material.permanent_ratio_central, tangential = *material.permanent_ratio_tangential;
  const bool keep = *material.keep_viscosity_coefficients_constant;
  DiscLaw law;
  law.contact = {*material.k, *material.nu, *material.k_t, *material.nu_t};
  law.link = {law.contact.k * central, law.contact.eta * (keep ? 1 : central), law.contact.k_t * tangential,
              law.contact.eta_t * (keep ? 1 : tangential)};
  law.friction = *material.mu;
  law.tension = Tensile(m.tensile_law == "exponential" ? Tensile::Kind::exponential
                        : m.tensile_law == "saturating" ? Tensile::Kind::saturating
                                                        : Tensile::Kind::linear,
                        m.tensile_range);
  law.slip = m.slip == "freeze" ? Slip::freeze : m.slip == "reset" ? Slip::reset : Slip::clamp;
  law.lever_arm = m.lever_arm == "radius" ? LeverArm::radius : LeverArm::distance;
  return law;
}

/// -dF/dd over k of the repulsion at 50 % overlap, by a central difference; at least 1.
double stiffening(const Repulsion& repulsion, double k) {
  const double d = 0.5, h = 1e-4;
  const double slope = std::visit([&](const auto& law) {
    return (law.force(d - h, 1, k) - law.force(d + h, 1, k)) / (2 * h * k); }, repulsion);
  return std::max(1.0, slope);
}

}  // namespace

double stable_time_step(const DiscLaw& law, const Repulsion& repulsion, double smallest_mass) {
  constexpr double contacts = 6;
  const double s = stiffening(repulsion, law.contact.k);
  double least = std::numeric_limits<double>::infinity();
  for (const PairStiffness& p : {law.contact, law.link}) {
    const double w = std::sqrt(contacts * (s * p.k + 3 * p.k_t) / smallest_mass);
    const double z = contacts * (p.eta + 3 * p.eta_t) / (2 * smallest_mass * w);
    least = std::min(least, 2 / w * (std::sqrt(1 + z * z) - z));
  }
  return least;
}

Repulsion make_repulsion(const Material& m, double share) {
  if (m.elastic_law == "linear") return Divergent(0);
  if (m.elastic_law == "hertz") return Hertz();
  if (m.elastic_law == "plateau") return Plateau(share, m.plateau_begin, m.plateau_end, m.plateau_slope);
  if (m.elastic_law == "expression") {
    const auto formula = std::make_shared<Expression>(m.elastic_expression, std::vector<std::string>{"d", "d0", "k", "c"},
                                                      "[material] elastic_expression");
    return Tabulated([=](double d, double d0, double stiffness, double coefficient) {
      return (*formula)(std::vector<double>{d, d0, stiffness, coefficient});
    }, share, "[material] elastic_expression \"" + m.elastic_expression + "\"");
  }
  return Divergent(share);
}

MicrogelConstants derive_constants(const Case& c, const InitialState* initial) {
  MicrogelConstants k;
  set_masses(c, initial, k);
  k.k = pi / 8 * c.material.young_modulus;
  k.material = resolve_material(c, initial, k);
  k.law = make_law(c.material, k.material);
  if (initial && initial->material.k && !c.is_given("material.young_modulus")) k.k = k.law.link.k;
  k.tau = std::sqrt(k.mean_mass / k.k);
  k.frequency = c.shear.relative_frequency / k.tau;
  if (initial && !c.is_given("shear.relative_frequency"))
    if (const auto f = initial->protocol.find("f"); f != initial->protocol.end()) k.frequency = f->second / initial->units.time;

  const Repulsion repulsion = make_repulsion(c.material, *k.material.central_repulsion_coefficient);
  k.stable_step = stable_time_step(k.law, repulsion, k.smallest_mass);
  k.time_step = step_share * k.stable_step * c.time.step_factor;
  if (initial && c.general.experiment == "dynamics")
    if (const auto dt = initial->protocol.find("dt"); dt != initial->protocol.end()) k.time_step = dt->second * initial->units.time;
  if (c.time.time_step > 0) k.time_step = c.time.time_step;
  if (k.time_step > k.stable_step)
    throw input_error(fmt::format("time step {:.4g} s is above the stability limit {:.4g} s", k.time_step, k.stable_step),
                      "the stiffest disc would gain energy at every step",
                      fmt::format("set [time] step to at most {:.3g} s, or leave it out for {:.3g} s",
                                  0.5 * k.stable_step, step_share * k.stable_step));
  return k;
}

std::vector<Derived> derived_constants(const MicrogelConstants& k) {
  const PairStiffness &contact = k.law.contact, &link = k.law.link;
  std::vector<Derived> all = name_constants({k.mean_mass, k.tau, k.law.friction, contact.k, contact.k_t, contact.eta,
                                             contact.eta_t, link.k, link.k_t, link.eta, link.eta_t},
                                            si_units());
  all.push_back({{"stable_time_step", "s", "stability limit of the time step"}, k.stable_step});
  return all;
}

Plates plates_of(const Case& c) {
  return c.box.plates == "repulsive" ? Plates::repulsive : c.box.plates == "none" ? Plates::none : Plates::capture;
}

std::unique_ptr<DiscDynamics> make_dynamics(const Case& c, const MicrogelConstants& k) {
  const Repulsion repulsion = make_repulsion(c.material, *k.material.central_repulsion_coefficient);
  return std::make_unique<DiscDynamics>(ForceField(DiscContacts(repulsion, k.law)));
}

}  // namespace supple
