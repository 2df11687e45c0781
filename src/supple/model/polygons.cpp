#include "supple/model/polygons.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "supple/core/error.hpp"
#include "supple/model/add_sites.hpp"

namespace supple {

using std::numbers::pi;

double least_shape_parameter(int n) { return n * std::tan(pi / n) / pi; }

ShapeStiffness absolute_stiffness(const ShapeSpec& shape, double a0, double l0, int n) {
  if (shape.kind == StiffnessKind::absolute) return {shape.area, shape.length, shape.bending, shape.tension};
  return {shape.area / (a0 * a0), shape.length / (l0 * l0), shape.bending, shape.tension / (n * l0)};
}

void add_ring(System<2>& system, const std::vector<Vec2>& vertices, double radius,
              const ShapeStiffness& stiffness, double rest_area, const std::vector<double>& rest_length,
              const std::vector<double>& rest_angle) {
  const auto n = static_cast<std::int32_t>(vertices.size());
  if (n < 3)
    throw input_error(fmt::format("a polygon of {} vertices", n), "it encloses nothing", "give at least 3");
  if (rest_length.size() != vertices.size() || rest_angle.size() != vertices.size())
    throw input_error(fmt::format("a polygon of {} vertices with {} rest lengths and {} rest angles", n,
                                  rest_length.size(), rest_angle.size()),
                      "they do not match");
  begin_bodies(system);
  const std::int32_t first = system.state.size();
  add_sites(system, vertices, radius);
  Topology<2>& t = system.topology;
  for (std::int32_t k = 0; k < n; ++k) {
    const std::int32_t before = first + (k + n - 1) % n, after = first + (k + 1) % n;
    t.facet.push_back({first + k, after});
    t.hinge.push_back({before, first + k, after});
  }
  t.facet_begin.push_back(static_cast<std::int32_t>(t.facet.size()));
  t.hinge_begin.push_back(static_cast<std::int32_t>(t.hinge.size()));
  Shape& shape = system.shape;
  shape.stiffness.push_back(stiffness);
  shape.rest_volume.push_back(rest_area);
  shape.rest_facet.insert(shape.rest_facet.end(), rest_length.begin(), rest_length.end());
  shape.rest_hinge.insert(shape.rest_hinge.end(), rest_angle.begin(), rest_angle.end());
}

void add_disc_body(System<2>& system, const Vec2& centre, double radius) {
  add_round_body(system, centre, radius);
}

void add_polygon(System<2>& system, const Vec2& centre, double a0, int n, double angle, double diameter_ratio,
                 const ShapeSpec& shape) {
  if (n < 3)
    throw input_error(fmt::format("a polygon of {} vertices", n), "it encloses nothing", "give at least 3");
  const double least = least_shape_parameter(n),
               wanted = shape.shape_parameter > 0 ? shape.shape_parameter : least;
  if (!(a0 > 0 && diameter_ratio > 0))
    throw input_error(fmt::format("a polygon of area {} and vertex diameter {} edges", a0, diameter_ratio),
                      "both must be positive");
  if (wanted < least * (1 - 1e-12))
    throw input_error(fmt::format("shape parameter {} of a polygon of {} vertices", wanted, n),
                      fmt::format("p^2/(4 pi a) is at least N tan(pi/N)/pi = {:.6f}", least),
                      "raise it, or leave it at 0 for the regular polygon");
  const double l0 = std::sqrt(4 * pi * wanted * a0) / n;
  const double circumradius = std::sqrt(2 * a0 / (n * std::sin(2 * pi / n)));
  std::vector<Vec2> vertices;
  for (int k = 0; k < n; ++k)
    vertices.push_back(centre + circumradius *
                                    Vec2{std::cos(angle + 2 * pi * k / n), std::sin(angle + 2 * pi * k / n)});
  const auto count = static_cast<std::size_t>(n);
  add_ring(system, vertices, 0.5 * diameter_ratio * l0, absolute_stiffness(shape, a0, l0, n), a0,
           std::vector<double>(count, l0), std::vector<double>(count, shape.regular_angles ? 2 * pi / n : 0));
}

}  // namespace supple
