#include "supple/experiment/derived.hpp"

namespace supple {

std::vector<Derived> name_constants(const LawConstants& law, const Units& units) {
  const double spring = units.stiffness(), drag = units.viscosity();
  return {
      {{"mean_mass", "kg/m", "mass of a disc that defines tau, per metre of depth"},
       law.mean_mass * units.mass},
      {{"time_constant", "s", "tau = sqrt(m/k)"}, law.tau * units.time},
      {{"friction", "", "Coulomb coefficient mu"}, law.friction},
      {{"spring_constant", "N/m^2", "k of contacts, (pi/8) E (S1-8), per metre of depth"}, law.k * spring},
      {{"tangential_spring_constant", "N/m^2", "k_t of contacts"}, law.k_t * spring},
      {{"viscosity", "N s/m^2", "eta of contacts (S1-9)"}, law.eta * drag},
      {{"tangential_viscosity", "N s/m^2", "eta_t of contacts"}, law.eta_t * drag},
      {{"link_spring_constant", "N/m^2", "k of permanent links"}, law.link_k * spring},
      {{"link_tangential_spring_constant", "N/m^2", "k_t of permanent links"}, law.link_k_t * spring},
      {{"link_viscosity", "N s/m^2", "eta of permanent links"}, law.link_eta * drag},
      {{"link_tangential_viscosity", "N s/m^2", "eta_t of permanent links"}, law.link_eta_t * drag},
  };
}

}  // namespace supple
