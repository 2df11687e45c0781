/// Systems of discs and polygons for tests.
#pragma once
#include <numbers>

#include "supple/core/random.hpp"
#include "supple/model/system.hpp"

namespace supple::testing {

using Ring = std::vector<Vec2>;

inline System<2> empty_cell(double width, double height) {
  System<2> system;
  system.box.length = {width, height};
  system.topology.begin = {0};
  return system;
}

/// Adds a body of sites that all have this radius.
inline void add_outline(System<2>& system, const Ring& ring, double radius) {
  for (const Vec2& x : ring) {
    const int site = system.state.size();
    system.state.resize(site + 1);
    system.state.position[site] = x;
    system.state.radius[site] = radius;
  }
  system.topology.begin.push_back(system.state.size());
}

inline Ring regular_polygon(int n, double circumradius, const Vec2& centre = {}, double angle = 0) {
  Ring ring;
  for (int i = 0; i < n; ++i) {
    const double a = angle + 2 * std::numbers::pi * i / n;
    ring.push_back(centre + circumradius * Vec2{std::cos(a), std::sin(a)});
  }
  return ring;
}

/// A ring of 2 n vertices round its centre, at the two radii in turn.
inline Ring star(int n, double outer, double inner, const Vec2& centre = {}, double angle = 0) {
  Ring ring = regular_polygon(2 * n, 1, {}, angle);
  for (int i = 0; i < 2 * n; ++i) ring[i] = centre + (i % 2 ? inner : outer) * ring[i];
  return ring;
}

/// Rings of random shapes, many of them not convex, and some discs, at random places; they may overlap.
inline System<2> random_shapes(int bodies, std::uint64_t seed) {
  System<2> system = empty_cell(6, 5);
  for (int b = 0; b < bodies; ++b) {
    RandomStream draw(seed, Purpose::test, static_cast<std::uint64_t>(b));
    const Vec2 centre{draw.uniform(-20, 20), draw.uniform(-20, 20)};
    const int n = b % 4 == 3 ? 1 : 3 + static_cast<int>(draw.below(10));
    Ring ring = regular_polygon(n, 1, {}, draw.uniform(0, 7));
    for (Vec2& x : ring) x = centre + draw.uniform(0.4, 0.9) * x;
    add_outline(system, ring, n == 1 ? draw.uniform(0.2, 0.7) : draw.uniform(0.05, 0.4));
  }
  return system;
}

}  // namespace supple::testing
