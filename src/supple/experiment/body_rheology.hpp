/// Laws of friction, viscosity and links of deformable particles, as a case asks for them.
#pragma once
#include "supple/contact/laws/table.hpp"
#include "supple/contact/laws/touch.hpp"
#include "supple/experiment/packing_record.hpp"
#include "supple/experiment/pairs_of_case.hpp"

namespace supple {

/// The laws, and the numbers that they follow from, in units of the run. `k` is the stiffness of a contact of
/// two vertices of mean size by [contact], `mass` the mass of a vertex; tau = sqrt(m/k) with the mean mass m
/// of a particle.
struct BodyLaws {
  double k = 0, mass = 0, tau = 0;
  LawTable<TouchLaw> touch{TouchLaw{}};
  LawTable<LinkLaw> link{LinkLaw{}};
  /// Those that have laws of their own, and their k.
  std::vector<std::pair<PairOfSpecies, double>> pairs;
};
BodyLaws body_laws(const Case& c, const Packing<2>& packing);
std::vector<Derived> derived_laws(const BodyLaws& laws);

/// Adds friction and viscosity to the contacts of the packing, and the forces of links that exist or will be
/// made. A law that is off adds nothing.
void add_rheology(const BodyLaws& laws, Packing<2>& packing);

/// Links vertices that touch into clusters of particles, as the keys of [particles] say. Returns the number
/// of clusters.
int crosslink_bodies(const Case& c, Packing<2>& packing);

/// The step of the leapfrog [time]: time.step if given, else time.step_factor times 0.1 of the stability
/// limit 2/w (sqrt(1 + z^2) - z), w the largest angular frequency of shapes, contacts and links of a vertex
/// that six others touch, z its damping ratio [O'Sullivan & Bray 2004, with damping].
double sheared_body_step(const Case& c, const BodyLaws& laws, Packing<2>& packing);

}  // namespace supple
