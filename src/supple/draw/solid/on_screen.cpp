#include "supple/draw/solid/on_screen.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "supple/draw/solid/cell_planes.hpp"
#include "supple/draw/solid/light.hpp"
#include "supple/draw/solid/vertex_normals.hpp"

namespace supple {

double ScreenTriangle::from_side(double x, double y) const {
  const Vec2 p{x, y};
  double least = std::numeric_limits<double>::max();
  for (int k = 0; k < 3; ++k) {
    const Vec3 &a = corner[k], &b = corner[(k + 1) % 3];
    const Vec2 from{a[0], a[1]}, side = Vec2{b[0], b[1]} - from;
    least = std::min(least, std::abs(cross(side, p - from)) / norm(side));
  }
  return least;
}

OnScreen::OnScreen(const SolidScene& scene, const SolidWindow& window, int samples, Shading shading)
    : scene_(scene), shading_(shading) {
  const double scale = window.pixels_per_length * samples;
  const double middle =
      dot(window.axes.towards, scene.box.centre());  // depths are floats: near 0 they are fine
  const auto on_screen = [&](const Vec3& x) {
    const Vec3 at = window.axes.of(x);
    return scale * Vec3{at[0] - window.left, window.top - at[1], at[2] - middle};
  };
  for (const Vec3& x : scene.vertex) vertex_.push_back(on_screen(x));
  if (shading == Shading::smooth) normal_ = vertex_normals(scene);
  for (Vec3& n : normal_) n = window.axes.of(n);
  for (const SolidTriangle& t : scene.triangle) body_.push_back(t.body);
  for (const SolidSphere& s : scene.sphere) {
    sphere_.push_back({on_screen(s.centre), scale * s.radius});
    body_.push_back(s.body);
  }
  order_.resize(body_.size());
  std::iota(order_.begin(), order_.end(), 0);
  std::ranges::stable_sort(order_, {}, [&](std::int32_t s) { return body_[s]; });
  if (scene.images == Images::whole) return;
  for (const CellPlane& plane : cell_planes(scene.box)) {
    if (!scene.box.periodic[plane.direction]) continue;
    constexpr double along = 1e-9;  // a side at less than this angle to the view is seen as a line
    const Vec3 n = window.axes.of(plane.normal);
    // The plane is n . (x/scale + left, top - y/scale, depth/scale + middle) = level.
    const double rest = n[0] * window.left + n[1] * window.top + n[2] * middle - plane.level;
    if (std::abs(n[2]) < along) {
      cuts_.push_back({ScreenCut::Lies::along, scale * rest, {n[0], -n[1]}, 1});
    } else {
      cuts_.push_back({n[2] > 0 ? ScreenCut::Lies::near : ScreenCut::Lies::far,
                       -scale * rest / n[2],
                       {-n[0] / n[2], n[1] / n[2]},
                       0.5 + 0.5 * brightness(n)});
    }
  }
}

ScreenTriangle OnScreen::triangle(int shape) const {
  constexpr double sharp = 0.7;  // cosine between a triangle's normal and a corner's
  const std::array<std::int32_t, 3>& v = scene_.triangle[shape].vertex;
  ScreenTriangle t;
  t.corner = {vertex_[v[0]], vertex_[v[1]], vertex_[v[2]]};
  const Vec3 b = t.corner[1] - t.corner[0], c = t.corner[2] - t.corner[0];
  const double area = b[0] * c[1] - b[1] * c[0];  // twice
  t.is_seen = area != 0 && std::isfinite(1 / area);
  if (!t.is_seen) return t;
  t.is_outside = area < 0;  // counter-clockwise as y goes down
  // A number that is b's at b, c's at c and 0 at corner 0 changes by this along x and along y.
  const auto slope = [&](double at_b, double at_c) {
    return Vec2{(at_b * c[1] - at_c * b[1]) / area, (at_c * b[0] - at_b * c[0]) / area};
  };
  t.slope = slope(b[2], c[2]);
  t.farthest = t.corner[0][2] + std::min({0.0, b[2], c[2]});
  t.nearest = t.corner[0][2] + std::max({0.0, b[2], c[2]});
  const Vec3 facing{-t.slope[0], t.slope[1], 1};  // y is down, up is up
  t.normal = (1 / norm(facing)) * facing;
  if (shading_ == Shading::flat) return t;
  const double side = t.is_outside ? 1 : -1;
  std::array<Vec3, 3> n;
  for (int k = 0; k < 3; ++k) {
    n[k] = side * normal_[v[k]];
    if (dot(n[k], t.normal) < sharp) n[k] = t.normal;
  }
  t.normal = n[0];
  for (int d = 0; d < 3; ++d) {
    const Vec2 change = slope(n[1][d] - n[0][d], n[2][d] - n[0][d]);
    t.normal_x[d] = change[0];
    t.normal_y[d] = change[1];
  }
  return t;
}

Bounds OnScreen::bounds(int shape) const {
  if (!is_triangle(shape)) {
    const ScreenSphere& s = sphere(shape);
    return Bounds{{s.centre[0], s.centre[1]}, {s.centre[0], s.centre[1]}}.grown(s.radius);
  }
  const std::array<std::int32_t, 3>& v = scene_.triangle[shape].vertex;
  const auto place = [&](int k) { return Vec2{vertex_[v[k]][0], vertex_[v[k]][1]}; };
  Bounds bounds{place(0), place(0)};
  bounds.include(place(1));
  bounds.include(place(2));
  return bounds;
}

}  // namespace supple
