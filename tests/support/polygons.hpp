/// Systems of polygons for tests.
#pragma once
#include <cmath>
#include <memory>

#include "supple/core/random.hpp"
#include "supple/force/force_field.hpp"
#include "supple/force/polygon_shape.hpp"
#include "supple/model/polygons.hpp"

namespace supple::testing {

/// Parameters of a random packing of polygons.
struct PackingDraw {
  int bodies = 9;
  std::uint64_t seed = 1;
  ShapeSpec shape{1, 1, 0.1, 0.05};
  double diameter_ratio = 1;  ///< sigma over rest length
  double spacing = 2.2;       ///< of the lattice of centres; particles have radius 1 (small) and 1.3 (large)
  double jitter = 0.12;       ///< of every vertex
};

/// Polygons of 9 to 14 vertices on a jittered square lattice in a sheared periodic cell; neighbours overlap.
/// Bodies stick out of the cell.
inline System<2> random_polygons(const PackingDraw& draw = {}) {
  const int rows = static_cast<int>(std::ceil(std::sqrt(draw.bodies)));
  System<2> system;
  system.box.length = {rows * draw.spacing, rows * draw.spacing * 1.1};
  system.box.strain = 0.13;
  for (int b = 0; b < draw.bodies; ++b) {
    RandomStream stream(draw.seed, Purpose::test, static_cast<std::uint64_t>(b));
    const double radius = b % 2 ? 1.3 : 1;
    const int n = 9 + static_cast<int>(stream.below(6));
    const Vec2 centre{(b % rows) * draw.spacing, (b / rows) * draw.spacing * 1.1};
    add_polygon(system, centre, 3 * radius * radius, n, stream.uniform(0, 6), draw.diameter_ratio,
                draw.shape);
    for (int i = system.topology.begin[b]; i < system.topology.begin[b + 1]; ++i)
      for (int d = 0; d < 2; ++d) system.state.position[i][d] += draw.jitter * stream.uniform(-1, 1);
  }
  return system;
}

/// The force field of such a packing.
inline ForceField<2> polygon_field(const BodyContacts<2>& contacts) {
  ForceField<2> field(contacts);
  field.terms().add(std::make_shared<PolygonShape>());
  return field;
}

}  // namespace supple::testing
