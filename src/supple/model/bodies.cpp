#include "supple/model/bodies.hpp"

#include <algorithm>
#include <cmath>

#include "supple/core/rotation.hpp"

namespace supple {

template <int Dim>
Vec<Dim> body_centre(const System<Dim>& system, int b) {
  const int first = system.topology.body_begin(b), end = system.topology.body_end(b);
  Vec<Dim> sum{};
  for (int i = first; i < end; ++i) sum += system.state.position[i] - system.state.position[first];
  return system.state.position[first] + (1.0 / (end - first)) * sum;
}

template <int Dim>
double outer_radius(const System<Dim>& system, int b) {
  const Vec<Dim> centre = body_centre(system, b);
  double radius = 0;
  for (int i = system.topology.body_begin(b); i < system.topology.body_end(b); ++i)
    radius = std::max(radius, norm(system.state.position[i] - centre) + system.state.radius[i]);
  return radius;
}

template <int Dim>
void move_body(System<Dim>& system, int b, const Vec<Dim>& move) {
  if (const int r = rigid_index(system, b); r >= 0) system.rigid.centre[r] += move;
  for (int i = system.topology.body_begin(b); i < system.topology.body_end(b); ++i)
    system.state.position[i] += move;
}

namespace {

double turned_angle(double first, double second) { return first + second; }
Vec3 turned_angle(const Vec3& first, const Vec3& second) { return combined(first, second); }

Vec2 turned(const Vec2& r, double by) { return std::cos(by) * r + std::sin(by) * turned_left(r); }
Vec3 turned(const Vec3& r, const Vec3& by) { return rotation(by) * r; }

}  // namespace

template <int Dim>
void turn_body(System<Dim>& system, int b, const Angular<Dim>& by) {
  if (const int r = rigid_index(system, b); r >= 0) {
    system.rigid.angle[r] = turned_angle(system.rigid.angle[r], by);
    place_sites(system, r);
    return;
  }
  const Vec<Dim> centre = body_centre(system, b);
  for (int i = system.topology.body_begin(b); i < system.topology.body_end(b); ++i)
    system.state.position[i] = centre + turned(system.state.position[i] - centre, by);
}

template <int Dim>
void scale_cell(System<Dim>& system, const Vec<Dim>& factor) {
  for (int d = 0; d < Dim; ++d) system.box.length[d] *= factor[d];
  for (int b = 0; b < system.topology.body_count(system.state.size()); ++b) {
    const Vec<Dim> centre = body_centre(system, b);
    Vec<Dim> move;
    for (int d = 0; d < Dim; ++d) move[d] = (factor[d] - 1) * centre[d];
    move_body(system, b, move);
  }
  place_sites(system);  // rigid bodies' sites follow from their centres, to the last bit
}

template Vec<2> body_centre(const System<2>&, int);
template double outer_radius(const System<2>&, int);
template void move_body(System<2>&, int, const Vec<2>&);
template void turn_body(System<2>&, int, const Angular<2>&);
template void scale_cell(System<2>&, const Vec<2>&);
template Vec<3> body_centre(const System<3>&, int);
template double outer_radius(const System<3>&, int);
template void move_body(System<3>&, int, const Vec<3>&);
template void turn_body(System<3>&, int, const Angular<3>&);
template void scale_cell(System<3>&, const Vec<3>&);

}  // namespace supple
