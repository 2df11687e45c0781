#include "supple/experiment/microgel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "supple/core/error.hpp"
#include "supple/core/expression.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/experiment/material.hpp"
#include "supple/model/discs.hpp"
#include "supple/solve/time_step.hpp"

namespace supple {

namespace {

constexpr double pi = std::numbers::pi;

void set_masses(const Case& c, const InitialState* initial, MicrogelConstants& k) {
  std::vector<double> mass;
  if (initial) {
    mass = system_of<2>(*initial).state.mass;
    for (double& m : mass) m *= initial->units.mass;
  } else {
    const DiscSpec spec{c.particles.discs, c.particles.packing_fraction, c.particles.bimodal_factor,
                        c.material.density};
    for (double r :
         bimodal_radii(spec, c.box.width * c.box.height, static_cast<std::uint64_t>(c.general.seed)))
      mass.push_back(c.material.density * pi * r * r);
  }
  double sum = 0;
  for (double m : mass) sum += m;
  k.mean_mass = sum / static_cast<double>(mass.size());
  k.smallest_mass = *std::min_element(mass.begin(), mass.end());
}

DiscLaw make_law(const Material& m, const MaterialConstants& material) {
  const double central = *material.permanent_ratio_central, tangential = *material.permanent_ratio_tangential;
  const bool keep = *material.keep_viscosity_coefficients_constant;
  DiscLaw law;
  law.contact = {*material.k, *material.nu, *material.k_t, *material.nu_t};
  law.link = {law.contact.k * central, law.contact.eta * (keep ? 1 : central), law.contact.k_t * tangential,
              law.contact.eta_t * (keep ? 1 : tangential)};
  law.friction = *material.mu;
  law.tension = Tensile(m.tensile_law == "exponential"  ? Tensile::Kind::exponential
                        : m.tensile_law == "saturating" ? Tensile::Kind::saturating
                                                        : Tensile::Kind::linear,
                        m.tensile_range);
  law.slip = m.slip == "freeze" ? Slip::freeze : m.slip == "reset" ? Slip::reset : Slip::clamp;
  law.lever_arm = m.lever_arm == "radius" ? LeverArm::radius : LeverArm::distance;
  return law;
}

/// Largest -dF/dd over k up to 50 % overlap, and down to the core of a plateau law; at least 1.
double stiffening(const Repulsion& repulsion) {
  const double h = 1e-4, least = std::holds_alternative<Plateau>(repulsion) ? 0.2 : 0.5;
  double most = 1;
  for (double d = least; d <= 1 - h; d += 0.005)
    most = std::max(most, std::visit(
                              [&](const auto& law) {
                                return (law.force(d - h, 1, 1) - law.force(d + h, 1, 1)) / (2 * h);
                              },
                              repulsion));
  return most;
}

/// The same of a stretched link, up to the stretch sqrt(1 + A^2/4) + A/2 of an affine shear by A.
double tensile_stiffening(const Tensile& tension, double amplitude) {
  const double h = 1e-4, d = std::sqrt(1 + 0.25 * amplitude * amplitude) + 0.5 * amplitude;
  return std::max(1.0, (tension.force(d - h, 1, 1) - tension.force(d + h, 1, 1)) / (2 * h));
}

/// Where strains exceed 1, discs are pushed through each other, deeper than the limit allows for.
double share_at(double amplitude) { return step_share / std::pow(std::max(1.0, amplitude), 2); }

}  // namespace

double stable_time_step(const DiscLaw& law, const Repulsion& repulsion, double smallest_mass,
                        double amplitude) {
  constexpr double contacts = 6;
  const double compressed = stiffening(repulsion);
  double least = std::numeric_limits<double>::infinity();
  const auto limit = [&](const PairStiffness& p, double s) {
    const double w = std::sqrt(contacts * (s * p.k + 3 * p.k_t) / smallest_mass);
    const double z = contacts * (p.eta + 3 * p.eta_t) / (2 * smallest_mass * w);
    least = std::min(least, leapfrog_limit(w, z));
  };
  limit(law.contact, compressed);
  limit(law.link, std::max(compressed, tensile_stiffening(law.tension, amplitude)));
  return least;
}

Repulsion make_repulsion(const Material& m, double share) {
  ElasticParameters parameters{share, m.plateau_begin, m.plateau_end, m.plateau_slope, m.attraction_range};
  if (m.elastic_law == "expression") {
    const auto formula = std::make_shared<Expression>(
        m.elastic_expression, std::vector<std::string>{"d", "d0", "k", "c"}, "[material] elastic_expression");
    parameters.formula = [=](double d, double d0, double stiffness, double coefficient) {
      return (*formula)(std::vector<double>{d, d0, stiffness, coefficient});
    };
    parameters.formula_is = "[material] elastic_expression \"" + m.elastic_expression + "\"";
  }
  return make_elastic(m.elastic_law, parameters);
}

MicrogelConstants derive_constants(const Case& c, const InitialState* initial) {
  MicrogelConstants k;
  set_masses(c, initial, k);
  k.k = pi / 8 * c.material.young_modulus;
  const MaterialConstants stored =
      initial ? convert(initial->material, initial->units, si_units()) : MaterialConstants{};
  k.material = resolve_material(c, stored, k.k, k.mean_mass);
  k.law = make_law(c.material, k.material);
  k.k = k.law.link.k;
  k.tau = std::sqrt(k.mean_mass / k.k);
  k.frequency = c.shear.relative_frequency / k.tau;
  if (initial && !c.is_given("shear.relative_frequency"))
    if (const auto f = initial->protocol.find("f"); f != initial->protocol.end())
      k.frequency = f->second / initial->units.time;

  const Repulsion repulsion = make_repulsion(c.material, *k.material.central_repulsion_coefficient);
  k.stable_step = stable_time_step(k.law, repulsion, k.smallest_mass, c.shear.amplitude);
  k.time_step = share_at(c.shear.amplitude) * k.stable_step * c.time.step_factor;
  k.relaxation_step = relaxation_share * stable_time_step(k.law, repulsion, k.smallest_mass, 0);
  if (initial && experiment_of(c).keeps_step)
    if (const auto dt = initial->protocol.find("dt"); dt != initial->protocol.end())
      k.time_step = dt->second * initial->units.time * c.time.step_factor;
  if (c.time.time_step > 0) k.time_step = c.time.time_step;
  if (k.time_step > k.stable_step)
    throw input_error(
        fmt::format("time step {:.4g} s is above the stability limit {:.4g} s", k.time_step, k.stable_step),
        "the stiffest disc would gain energy at every step",
        fmt::format("set [time] step to at most {:.3g} s, or leave it out for {:.3g} s", 0.9 * k.stable_step,
                    step_share * k.stable_step));
  return k;
}

std::set<std::string> microgel_first_keys() {
  return {"experiment",          "seed",
          "particles.N",         "particles.packing_fraction",
          "particles.cut_lines", "material.young_modulus",
          "material.friction",   "shear.amplitude"};
}

std::vector<Derived> derived_constants(const MicrogelConstants& k) {
  const PairStiffness &contact = k.law.contact, &link = k.law.link;
  std::vector<Derived> all =
      name_constants({k.mean_mass, k.tau, k.law.friction, contact.k, contact.k_t, contact.eta, contact.eta_t,
                      link.k, link.k_t, link.eta, link.eta_t},
                     si_units());
  all.push_back({{"stable_time_step", "s", "stability limit of the time step"}, k.stable_step});
  return all;
}

Plates plates_of(const Case& c) {
  if (c.box.boundary == "periodic") return Plates::none;
  return c.box.plates == "repulsive" ? Plates::repulsive
         : c.box.plates == "none"    ? Plates::none
                                     : Plates::capture;
}

std::unique_ptr<Mover<2>> make_dynamics(const Case& c, const MicrogelConstants& k) {
  const Repulsion repulsion = make_repulsion(c.material, *k.material.central_repulsion_coefficient);
  return std::make_unique<Mover<2>>(ForceField<2>(DiscContacts(repulsion, k.law)));
}

}  // namespace supple
