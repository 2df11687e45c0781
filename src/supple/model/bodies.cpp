#include "supple/model/bodies.hpp"

#include <algorithm>

namespace supple {

Vec2 body_centre(const System<2>& system, int b) {
  const int first = system.topology.body_begin(b), end = system.topology.body_end(b);
  Vec2 sum{};
  for (int i = first; i < end; ++i) sum += system.state.position[i] - system.state.position[first];
  return system.state.position[first] + (1.0 / (end - first)) * sum;
}

double outer_radius(const System<2>& system, int b) {
  const Vec2 centre = body_centre(system, b);
  double radius = 0;
  for (int i = system.topology.body_begin(b); i < system.topology.body_end(b); ++i)
    radius = std::max(radius, norm(system.state.position[i] - centre) + system.state.radius[i]);
  return radius;
}

void move_body(System<2>& system, int b, const Vec2& move) {
  if (const int r = rigid_index(system, b); r >= 0) system.rigid.centre[r] += move;
  for (int i = system.topology.body_begin(b); i < system.topology.body_end(b); ++i)
    system.state.position[i] += move;
}

void scale_cell(System<2>& system, const Vec2& factor) {
  for (int d = 0; d < 2; ++d) system.box.length[d] *= factor[d];
  for (int b = 0; b < system.topology.body_count(system.state.size()); ++b) {
    const Vec2 centre = body_centre(system, b);
    move_body(system, b, {(factor[0] - 1) * centre[0], (factor[1] - 1) * centre[1]});
  }
  place_sites(system);  // rigid bodies' sites follow from their centres, to the last bit
}

}  // namespace supple
