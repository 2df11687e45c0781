#include "supple/experiment/material.hpp"

#include <cmath>

namespace supple {

namespace {

/// Constants of links, and what makes contacts of them.
struct Base {
  double k, k_t, eta, eta_t;
  double central, tangential;  ///< re-enforcement of contacts
  bool keep;                   ///< viscosities are not re-enforced
};

Base of_case(const Material& m, double k, double mass) {
  const double eta = m.relative_viscosity * std::sqrt(mass * k),
               transversal = m.relative_transversal_link_strength;
  return {k,
          k * transversal,
          eta,
          eta * transversal,
          m.interface_reenforcement_central,
          m.interface_reenforcement_tangential,
          m.keep_viscosity_coefficients_constant};
}

/// What a state's numbers say, and the user's keys where given.
Base merge(const Case& c, const MaterialConstants& stored, double k, double mass) {
  const Material& m = c.material;
  const auto given = [&](const char* key) { return c.is_given(std::string("material.") + key); };
  const Base fresh = of_case(m, k, mass);
  Base b = fresh;
  if (stored.permanent_ratio_central && !given("interface_reenforcement_central"))
    b.central = 1 / *stored.permanent_ratio_central;
  if (stored.permanent_ratio_tangential && !given("interface_reenforcement_tangential"))
    b.tangential = 1 / *stored.permanent_ratio_tangential;
  const bool kept = stored.keep_viscosity_coefficients_constant.value_or(fresh.keep);
  b.keep = given("keep_viscosity_coefficients_constant") ? fresh.keep : kept;

  const double ratio = stored.permanent_ratio_central.value_or(1 / fresh.central);
  const double ratio_t = stored.permanent_ratio_tangential.value_or(1 / fresh.tangential);
  if (stored.k && !given("young_modulus")) b.k = *stored.k * ratio;
  const double transversal = given("relative_transversal_link_strength") || !stored.k_t || !stored.k
                                 ? m.relative_transversal_link_strength
                                 : *stored.k_t * ratio_t / (*stored.k * ratio);
  b.k_t = b.k * transversal;
  const double eta = m.relative_viscosity * std::sqrt(mass * b.k);
  b.eta = stored.nu && !given("relative_viscosity") ? *stored.nu * (kept ? 1 : ratio) : eta;
  b.eta_t = stored.nu_t && !given("relative_viscosity") && !given("relative_transversal_link_strength")
                ? *stored.nu_t * (kept ? 1 : ratio_t)
                : b.eta * transversal;
  return b;
}

MaterialConstants of_contacts(const Base& b) {
  MaterialConstants out;
  out.k = b.k * b.central;
  out.k_t = b.k_t * b.tangential;
  out.nu = b.eta * (b.keep ? 1 : b.central);
  out.nu_t = b.eta_t * (b.keep ? 1 : b.tangential);
  out.permanent_ratio_central = 1 / b.central;
  out.permanent_ratio_tangential = 1 / b.tangential;
  out.keep_viscosity_coefficients_constant = b.keep;
  return out;
}

}  // namespace

MaterialConstants resolve_material(const Case& c, const MaterialConstants& stored, double k, double mass) {
  MaterialConstants out = of_contacts(merge(c, stored, k, mass));
  bool touched = false;
  for (const char* key : {"young_modulus", "relative_viscosity", "relative_transversal_link_strength",
                          "interface_reenforcement_central", "interface_reenforcement_tangential",
                          "keep_viscosity_coefficients_constant"})
    touched = touched || c.is_given(std::string("material.") + key);
  // As they are: the continuation of a run then has its bits.
  const auto pass = [&](const auto& number, auto& into) {
    if (number && !touched) into = number;
  };
  pass(stored.k, out.k);
  pass(stored.k_t, out.k_t);
  pass(stored.nu, out.nu);
  pass(stored.nu_t, out.nu_t);
  pass(stored.permanent_ratio_central, out.permanent_ratio_central);
  pass(stored.permanent_ratio_tangential, out.permanent_ratio_tangential);

  const auto own = [&](const char* key, std::optional<double> of_state, double of_case) {
    return of_state && !c.is_given(key) ? *of_state : of_case;
  };
  out.mu = own("material.friction", stored.mu, c.material.friction);
  out.central_repulsion_coefficient =
      own("material.central_repulsion_coefficient", stored.central_repulsion_coefficient,
          c.material.central_repulsion_coefficient);
  return out;
}

MaterialConstants convert(MaterialConstants m, const Units& from, const Units& to) {
  const double stiffness = from.stiffness() / to.stiffness(), viscosity = from.viscosity() / to.viscosity();
  for (auto* x : {&m.k, &m.k_t})
    if (*x) **x *= stiffness;
  for (auto* x : {&m.nu, &m.nu_t})
    if (*x) **x *= viscosity;
  return m;
}

}  // namespace supple
