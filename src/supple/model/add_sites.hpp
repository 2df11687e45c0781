/// How a system gets bodies: the part that polygons, surfaces, discs and spheres share.
#pragma once
#include <vector>

#include "supple/core/error.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// Begins the lists of bodies of a system that has none yet. Input error where it holds sites that are bodies
/// of their own.
template <int Dim>
void begin_bodies(System<Dim>& system) {
  Topology<Dim>& t = system.topology;
  if (!t.begin.empty()) return;
  if (system.state.size() > 0)
    throw input_error("cannot add a body to these sites", "each of them is a body of its own",
                      "add all bodies in one way");
  t.begin = t.facet_begin = t.hinge_begin = {0};
  system.pairs.width = 0;  // conservative contacts remember nothing
}

/// Takes memory at once for polygons and discs of this many sites in all, that will be added.
inline void reserve_polygons(System<2>& system, std::size_t bodies, std::size_t sites) {
  system.state.reserve(sites);
  Topology<2>& t = system.topology;
  for (auto* begin : {&t.begin, &t.facet_begin, &t.hinge_begin}) begin->reserve(bodies + 1);
  t.facet.reserve(sites);
  t.hinge.reserve(sites);
  system.shape.rest_facet.reserve(sites);
  system.shape.rest_hinge.reserve(sites);
}

/// Adds the sites of one more body, each of mass 1 and this radius [length], with the moment of inertia of a
/// disc or a sphere.
template <int Dim>
void add_sites(System<Dim>& system, const std::vector<Vec<Dim>>& position, double radius) {
  constexpr double inertia = Dim == 2 ? 0.5 : 0.4;  // over m r^2
  State<Dim>& s = system.state;
  const int first = s.size();
  s.resize(first + static_cast<int>(position.size()));
  for (std::size_t k = 0; k < position.size(); ++k) {
    const std::size_t i = static_cast<std::size_t>(first) + k;
    s.position[i] = position[k];
    s.radius[i] = radius;
    s.mass[i] = 1;
    s.inertia[i] = inertia * radius * radius;
  }
  system.topology.begin.push_back(s.size());
}

/// Adds a smooth disc or sphere: a body of one site of mass 1.
template <int Dim>
void add_round_body(System<Dim>& system, const Vec<Dim>& centre, double radius) {
  begin_bodies(system);
  add_sites(system, std::vector{centre}, radius);
  Topology<Dim>& t = system.topology;
  t.facet_begin.push_back(t.facet_begin.back());
  t.hinge_begin.push_back(t.hinge_begin.back());
  system.shape.stiffness.push_back({});
  system.shape.rest_volume.push_back(0);
}

}  // namespace supple
