#include "supple/observe/surface_look.hpp"

#include <algorithm>

#include "supple/contact/edge_cover.hpp"
#include "supple/geometry/facet.hpp"
#include "supple/geometry/line_chord.hpp"
#include "supple/geometry/star_surface.hpp"
#include "supple/geometry/surface_crossings.hpp"
#include "supple/geometry/triangles_cross.hpp"

namespace supple {

namespace {

BoundsOf<3> bounds_of_surface(const BodySurface& shape) {
  BoundsOf<3> bounds{shape.vertex[0], shape.vertex[0]};
  for (const Vec3& x : shape.vertex) bounds.include(x);
  return bounds;
}

Vec3 middle_of(const BodySurface& shape) {
  Vec3 sum{};
  for (const Vec3& x : shape.vertex) sum += x - shape.vertex[0];
  return shape.vertex[0] + (1.0 / shape.size()) * sum;
}

bool crosses_itself(const BodySurface& shape) {
  if (is_seen_from(middle_of(shape), shape.vertex, shape.face)) return false;
  return !self_crossings({shape.vertex, shape.face}).empty();
}

}  // namespace

SurfaceLook::SurfaceLook(std::size_t bodies, const std::vector<BodySurface>& shapes, Outline outline)
    : shapes_(shapes), outline_(outline), tally_(bodies) {
  for (const BodySurface& shape : shapes) {
    surfaces_.push_back(bounds_of_surface(shape));
    middle_.push_back(middle_of(shape));
  }
}

void SurfaceLook::alone(int b, const BodySurface& shape, double narrowest) {
  if (shape.is_sphere()) return;
  tally_.count(b, &Soundness::turned_over, !(shape.polyhedron() > 0));
  tally_.count(b, &Soundness::self_crossing, crosses_itself(shape));
  look_at_holes(b, shape, narrowest);
}

void SurfaceLook::look_at_holes(int b, const BodySurface& shape, double narrowest) {
  const bool rough = outline_ == Outline::rough;
  const double least = rough ? least_rough_diameter : least_smooth_diameter;
  bool open = false, uncovered = false;
  double longest = 0;
  for (const auto& hinge : shape.hinge) {
    const double length = norm(shape.vertex[hinge[1]] - shape.vertex[hinge[0]]);
    const double spheres = shape.radius[hinge[0]] + shape.radius[hinge[1]];
    if (spheres > 0) longest = std::max(longest, length / spheres);
    uncovered = uncovered || spheres < (1 - 1e-12) * least * length;
  }
  tally_.found.uncovered += uncovered;
  if (!rough) return;
  for (std::size_t k = 0; k < shape.face.size() && !open; ++k) {
    const auto [a, c, d] = shape.corners(shape.face[k]);
    double reach[3];
    for (std::size_t i = 0; i < 3; ++i) reach[i] = shape.radius[shape.face[k][i]] + 0.5 * narrowest;
    open = !spheres_cover({a, c, d}, reach);
  }
  tally_.found.longest_edge = std::max(tally_.found.longest_edge, longest);
  tally_.count(b, &Soundness::open, open);
}

void SurfaceLook::together(int a, const ImageOf<3>& image) {
  const BodySurface &first = shapes_[a], &second = shapes_[image.body];
  if (first.is_sphere() && second.is_sphere()) {
    const double distance = norm(second.vertex[0] + image.shift - first.vertex[0]);
    return tally_.look_at_round(a, first.radius[0], image.body, second.radius[0], distance);
  }
  const BoundsOf<3> other = surfaces_[image.body].shifted(image.shift);
  if (!surfaces_[a].meets(other)) return;
  // Most that is near each other is on either side of a plane across the line of their middles.
  const Vec3 direction = middle_[image.body] + image.shift - middle_[a];
  sides_[0].shape = &first;
  sides_[0].shift = {};
  sides_[1].shape = &second;
  sides_[1].shift = image.shift;
  for (Side& side : sides_) measure_heights(direction, side);
  const std::vector<double>&below = sides_[0].height, &above = sides_[1].height;
  const Common common{
      common_part(surfaces_[a], other),
      {*std::min_element(above.begin(), above.end()), *std::max_element(below.begin(), below.end())}};
  if (common.heights.low > common.heights.high) return;
  if (has_site_inside(sides_[0], sides_[1], common)) tally_.note_inside(a);
  if (has_site_inside(sides_[1], sides_[0], common)) tally_.note_inside(image.body);
  if (!boundaries_cross(common)) return;
  tally_.note_crossing(a);
  tally_.note_crossing(image.body);
}

void SurfaceLook::measure_heights(const Vec3& direction, Side& side) {
  side.height.clear();
  const double shift = dot(direction, side.shift);
  for (const Vec3& x : side.shape->vertex) side.height.push_back(dot(direction, x) + shift);
}

/// Whether a vertex of one body lies within the surface of the other.
bool SurfaceLook::has_site_inside(const Side& one, const Side& other, const Common& common) {
  for (std::size_t k = 0; k < one.height.size(); ++k) {
    if (one.height[k] < common.heights.low || one.height[k] > common.heights.high) continue;
    const Vec3 x = one.shape->vertex[k] + one.shift;
    if (common.box.holds(x) && winding_along_z(x - other.shift, other.shape->vertex, other.shape->face) != 0)
      return true;
  }
  return false;
}

/// The triangles of a displaced body that meet the common part, from left to right.
void SurfaceLook::triangles_in(const Side& side, const Common& common, std::vector<Triangle>& triangles) {
  triangles.clear();
  for (const auto& face : side.shape->face) {
    const auto [low, high] = std::minmax({side.height[face[0]], side.height[face[1]], side.height[face[2]]});
    if (high < common.heights.low || low > common.heights.high) continue;
    const auto [a, b, c] = side.shape->corners(face);
    Triangle t{{a + side.shift, b + side.shift, c + side.shift}, {}};
    t.bounds = {t.corner[0], t.corner[0]};
    t.bounds.include(t.corner[1]);
    t.bounds.include(t.corner[2]);
    if (t.bounds.meets(common.box)) triangles.push_back(t);
  }
  std::sort(triangles.begin(), triangles.end(),
            [](const Triangle& a, const Triangle& b) { return a.bounds.low[0] < b.bounds.low[0]; });
}

bool SurfaceLook::boundaries_cross(const Common& common) {
  triangles_in(sides_[0], common, first_);
  if (first_.empty()) return false;
  triangles_in(sides_[1], common, second_);
  for (const Triangle& a : first_)
    for (const Triangle& b : second_) {
      if (b.bounds.low[0] > a.bounds.high[0]) break;
      if (a.bounds.meets(b.bounds) && triangles_cross(a.corner, b.corner)) return true;
    }
  return false;
}

}  // namespace supple
