/// Laws of deformable particles that rub and are linked, as a case asks for them.
#pragma once
#include "supple/contact/laws/touch.hpp"
#include "supple/experiment/packing_record.hpp"

namespace supple {

/// Numbers that follow from a case and its particles, in units of the run. `k` is the stiffness of a contact
/// of two vertices of mean size, `mass` that of a vertex; tau = sqrt(m/k) with the mean mass m of a particle.
struct BodyLaws {
  double k = 0, mass = 0, tau = 0;
  TouchLaw touch;
  LinkLaw link;
};
BodyLaws body_laws(const Case& c, const Packing& packing);
std::vector<Derived> derived_laws(const BodyLaws& laws);

/// The packing's contacts get friction and viscosity, and its links, which are there or will be, their
/// forces. Without any of these nothing is added.
void add_rheology(const BodyLaws& laws, Packing& packing);

/// Links vertices that touch into clusters of particles, as the keys of [particles] say. Returns how many
/// there are.
int crosslink_bodies(const Case& c, Packing& packing);

/// The step of a leapfrog [time]: this share of 2/w (sqrt(1 + z^2) - z), w the largest frequency of shapes,
/// contacts and links of a vertex that six others touch, z the damping ratio there [O'Sullivan & Bray 2004,
/// with damping].
double sheared_body_step(const Case& c, const BodyLaws& laws, Packing& packing);

}  // namespace supple
