#include "supple/experiment/given_packing.hpp"

#include <algorithm>
#include <array>

#include "supple/build/solid_bodies.hpp"

namespace supple {

namespace {

/// Preferred area and edges of a body; in 3D volume and triangles.
struct Preferred {
  double volume, facet;  ///< of an edge or triangle, in the mean
  int facets;
};
template <int Dim>
Preferred preferred(const System<Dim>& system, std::size_t b) {
  const int first = system.topology.facet_begin[b], end = system.topology.facet_begin[b + 1];
  double boundary = 0;
  for (int f = first; f < end; ++f) boundary += system.shape.rest_facet[f];
  return {system.shape.rest_volume[b], boundary / (end - first), end - first};
}

/// Whether a body is deformable; discs and rigid bodies are not.
bool is_soft(const ShapeStiffness& k) { return k.volume > 0 || k.facet > 0 || k.hinge > 0 || k.tension > 0; }

/// A key of [bodies], the stiffness that it means, and what makes it relative.
struct StiffnessKey {
  const char* name;
  double ParticleKind::*of_case;
  double ShapeStiffness::*of_body;
  double scale;
};
template <int Dim>
std::array<StiffnessKey, 4> stiffness_keys(const Preferred& p) {
  constexpr bool flat = Dim == 2;
  using K = ParticleKind;
  using S = ShapeStiffness;
  return {{{flat ? "bodies.k_a" : "bodies.k_v", flat ? &K::k_a : &K::k_v, &S::volume, p.volume * p.volume},
           {flat ? "bodies.k_l" : "bodies.k_a", flat ? &K::k_l : &K::k_a, &S::facet, p.facet * p.facet},
           {"bodies.k_b", &K::k_b, &S::hinge, 1},
           {"bodies.gamma", &K::gamma, &S::tension, p.facets * p.facet}}};
}

/// The stiffness of the first solid as keys that are not given.
template <int Dim>
void adopt_inside(Case& c, const System<Dim>& system) {
  const auto unless_given = [&](const char* key, double ParticleKind::*of_case, double value) {
    if (!c.is_given(key)) c.bodies.*of_case = value;
  };
  for (int b = 0; b < system.solid.bodies(); ++b) {
    const auto constants = nominal_constants(system, b);
    if (!constants) continue;
    unless_given("bodies.k_s", &ParticleKind::k_s, system.solid.stiffness[b].bond);
    unless_given("bodies.E", &ParticleKind::young_modulus, constants->young_modulus);
    unless_given("bodies.nu", &ParticleKind::poisson_ratio, constants->poisson_ratio);
    return;
  }
}

/// What the case gives of the insides of bodies.
template <int Dim>
void give_inside(const Case& c, System<Dim>& system) {
  const bool has_modulus = c.is_given("bodies.E"), has_ratio = c.is_given("bodies.nu");
  for (int b = 0; b < system.solid.bodies(); ++b) {
    SolidStiffness& k = system.solid.stiffness[b];
    const auto constants = nominal_constants(system, b);
    if (constants && k.bond > 0) {
      if (has_modulus) k.bond *= c.bodies.young_modulus / constants->young_modulus;
      if (c.is_given("bodies.k_s")) k.bond = c.bodies.k_s;
    } else if (constants && (has_modulus || has_ratio)) {
      const LameConstants lame =
          lame_constants<Dim>({has_modulus ? c.bodies.young_modulus : constants->young_modulus,
                               has_ratio ? c.bodies.poisson_ratio : constants->poisson_ratio});
      k.lambda = lame.lambda;
      k.mu = lame.mu;
    }
  }
}

}  // namespace

template <int Dim>
void adopt_stiffness(Case& c, const System<Dim>& system) {
  adopt_inside(c, system);
  const auto& all = system.shape.stiffness;
  const auto soft = std::find_if(all.begin(), all.end(), is_soft);
  if (soft == all.end()) return;
  const Preferred p = preferred(system, static_cast<std::size_t>(soft - all.begin()));
  for (const StiffnessKey& key : stiffness_keys<Dim>(p))
    if (!c.is_given(key.name))
      c.bodies.*key.of_case =
          c.bodies.stiffness == "relative" ? (*soft).*key.of_body * key.scale : (*soft).*key.of_body;
}

template <int Dim>
void give_stiffness(const Case& c, System<Dim>& system) {
  give_inside(c, system);
  const bool relative = c.bodies.stiffness == "relative";
  for (std::size_t body = 0; body < system.shape.stiffness.size(); ++body) {
    ShapeStiffness& k = system.shape.stiffness[body];
    if (!is_soft(k)) continue;
    for (const StiffnessKey& key : stiffness_keys<Dim>(preferred(system, body)))
      if (c.is_given(key.name))
        k.*key.of_body = relative ? c.bodies.*key.of_case / key.scale : c.bodies.*key.of_case;
  }
}

template void adopt_stiffness(Case&, const System<2>&);
template void adopt_stiffness(Case&, const System<3>&);
template void give_stiffness(const Case&, System<2>&);
template void give_stiffness(const Case&, System<3>&);

}  // namespace supple
