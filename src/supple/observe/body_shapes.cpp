#include "supple/observe/body_shapes.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "supple/core/error.hpp"
#include "supple/geometry/facet.hpp"
#include "supple/geometry/hinge.hpp"
#include "supple/geometry/polygon.hpp"

namespace supple {
namespace {

[[noreturn]] void refuse(int body, const char* why, const char* to_do) {
  throw input_error(fmt::format("no area or volume for body {}", body), why, to_do);
}

template <int Dim>
void check_numbers(const std::vector<Vec<Dim>>& site, const std::vector<double>& radius, int body,
                   Outline outline) {
  for (std::size_t i = 0; i < site.size(); ++i) {
    for (int d = 0; d < Dim; ++d)
      if (!std::isfinite(site[i][d])) refuse(body, "a position is not finite", "look at the state");
    if (!(radius[i] >= 0) || std::isinf(radius[i]))
      refuse(body, "a radius is negative or not finite", "give radii");
    if (outline == Outline::smooth && radius[i] != radius[0])
      refuse(body, "its radii differ", "give one radius to a body of smooth outline");
  }
}

void check(const BodyShape& shape, int body, Outline outline) {
  check_numbers<2>(shape.ring, shape.radius, body, outline);
  if (shape.is_disc()) return;
  for (int i = 0; i < shape.size(); ++i)
    if (shape.ring[i] == shape.ring[shape.next(i)])
      refuse(body, "two neighbours on its ring are in one place", "move them apart");
  if (shape.size() < 3) refuse(body, "it has two sites", "give one (a disc) or at least three (a polygon)");
  if (!(polygon_area(shape.ring) > 0))
    refuse(body, "its sites run clockwise", "order them counter-clockwise, unwrapped");
}

void check(const BodySurface& shape, int body, Outline outline) {
  check_numbers<3>(shape.vertex, shape.radius, body, outline);
  if (shape.size() == 1) return;
  if (shape.is_sphere())
    refuse(body, "it has several sites and no surface", "give one site (a sphere) or a closed surface");
  if (!(shape.polyhedron() > 0))
    refuse(body, "its triangles look inward, or it encloses nothing",
           "order the corners of every triangle counter-clockwise as seen from outside");
}

template <int Dim>
BoundsOf<Dim> bounds_with_discs(const std::vector<Vec<Dim>>& site, const std::vector<double>& radius) {
  BoundsOf<Dim> all{site[0], site[0]};
  for (std::size_t i = 0; i < site.size(); ++i) all.include(BoundsOf<Dim>{site[i], site[i]}.grown(radius[i]));
  return all;
}

/// Copies the sites of a body and brings the middle of their bounds into the cell.
template <int Dim>
BoundsOf<Dim> lay_out(const System<Dim>& system, int body, std::vector<Vec<Dim>>& site,
                      std::vector<double>& radius) {
  const State<Dim>& state = system.state;
  const int first = system.topology.body_begin(body);
  if (system.topology.body_size(body) < 1) refuse(body, "it has no site", "leave it out");
  const int last = first + system.topology.boundary_size(body);
  site.assign(state.position.begin() + first, state.position.begin() + last);
  radius.assign(state.radius.begin() + first, state.radius.begin() + last);
  const BoundsOf<Dim> bounds = bounds_with_discs(site, radius);
  const Lattice<Dim> lattice = system.box.lattice();
  const Vec<Dim> shift = -lattice.vector(lattice.cell_of(0.5 * (bounds.low + bounds.high)));
  for (Vec<Dim>& x : site) x += shift;
  return bounds.shifted(shift);
}

template <int Dim>
void check_cell(const Box<Dim>& box) {
  for (int d = 0; d < Dim; ++d)
    if (!(box.length[d] > 0) || std::isinf(box.length[d]))
      throw input_error(fmt::format("the cell has length {}", box.length[d]), "out of range",
                        "give positive lengths");
}

/// [from, to) of these lists of sites, in the numbers of the body that begins at site `first`.
template <std::size_t N>
void own_numbers(const std::vector<std::array<std::int32_t, N>>& all, std::int32_t from, std::int32_t to,
                 std::int32_t first, std::vector<std::array<std::int32_t, N>>& own) {
  own.assign(all.begin() + from, all.begin() + to);
  for (auto& sites : own)
    for (std::int32_t& site : sites) site -= first;
}

}  // namespace

double BodyShape::distance_to_edge(int k, const Vec2& x) const {
  return distance_to_segment(x, ring[k], ring[next(k)]);
}

double BodyShape::turn_at(int i) const {
  const Vec2 corner[3] = {ring[previous(i)], ring[i], ring[next(i)]};
  return hinge_angle(corner);
}

double BodySurface::polyhedron() const {
  double volume = 0;
  for (const auto& f : face) {
    const Vec3 x[3] = {vertex[f[0]] - vertex[0], vertex[f[1]] - vertex[0], vertex[f[2]] - vertex[0]};
    volume += facet_volume(x);
  }
  return volume;
}

std::vector<BodyShape> lay_out_bodies(const System<2>& system) {
  check_cell(system.box);
  std::vector<BodyShape> shapes(static_cast<std::size_t>(system.topology.body_count(system.state.size())));
  for (int body = 0; body < static_cast<int>(shapes.size()); ++body)
    shapes[body].bounds = lay_out(system, body, shapes[body].ring, shapes[body].radius);
  return shapes;
}

std::vector<BodySurface> lay_out_bodies(const System<3>& system) {
  check_cell(system.box);
  const Topology<3>& t = system.topology;
  std::vector<BodySurface> shapes(static_cast<std::size_t>(t.body_count(system.state.size())));
  for (int body = 0; body < static_cast<int>(shapes.size()); ++body) {
    BodySurface& shape = shapes[body];
    shape.bounds = lay_out(system, body, shape.vertex, shape.radius);
    if (shape.size() == 1) continue;
    own_numbers(t.facet, t.facet_begin[body], t.facet_begin[body + 1], t.body_begin(body), shape.face);
    own_numbers(t.hinge, t.hinge_begin[body], t.hinge_begin[body + 1], t.body_begin(body), shape.hinge);
  }
  return shapes;
}

std::vector<BodyShape> body_shapes(const System<2>& system, Outline outline) {
  std::vector<BodyShape> shapes = lay_out_bodies(system);
  for (int body = 0; body < static_cast<int>(shapes.size()); ++body) check(shapes[body], body, outline);
  return shapes;
}

std::vector<BodySurface> body_shapes(const System<3>& system, Outline outline) {
  std::vector<BodySurface> shapes = lay_out_bodies(system);
  for (int body = 0; body < static_cast<int>(shapes.size()); ++body) check(shapes[body], body, outline);
  return shapes;
}

}  // namespace supple
