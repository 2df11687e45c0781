#include "supple/draw/solid/hidden_lines.hpp"

#include <algorithm>
#include <cmath>

namespace supple {

namespace {

/// Shares of the line; empty where low >= high.
struct Part {
  double low = 0, high = 1;

  /// Keeps where a number that changes evenly, from `at_a` to `at_b`, is positive.
  void keep_positive(double at_a, double at_b) {
    if (at_a <= 0 && at_b <= 0) low = high;
    if ((at_a > 0) == (at_b > 0)) return;
    const double zero = at_a / (at_a - at_b);
    (at_a > 0 ? high : low) = at_a > 0 ? std::min(high, zero) : std::max(low, zero);
  }
};

/// Where x + s y, two-dimensional or three-dimensional, is within a distance r of 0, for s in [0, 1].
template <int Dim>
Part within(const Vec<Dim>& x, const Vec<Dim>& y, double r) {
  const double square = dot(y, y), half = dot(x, y), rest = dot(x, x) - r * r;
  if (square == 0) return rest < 0 ? Part{} : Part{0, 0};
  const double root = half * half - square * rest;
  if (!(root > 0)) return {0, 0};
  const double width = std::sqrt(root);
  return {std::max((-half - width) / square, 0.0), std::min((-half + width) / square, 1.0)};
}

Vec2 in_picture(const Vec3& x) { return {x[0], x[1]}; }

/// What is drawn of a shape in the picture, around it.
bool misses(const Vec3& a, const Vec3& b, const BoundsOf<3>& shape) {
  for (int d = 0; d < 2; ++d)
    if (std::max(a[d], b[d]) < shape.low[d] || std::min(a[d], b[d]) > shape.high[d]) return true;
  return std::min(a[2], b[2]) > shape.high[2];
}

/// Where the line from a to b lies behind the triangle; places along right, up and towards the viewer.
Part behind(const Vec3& a, const Vec3& b, std::array<Vec3, 3> corner) {
  const Vec2 p = in_picture(corner[0]);
  const double area = cross(in_picture(corner[1]) - p, in_picture(corner[2]) - p);
  if (area == 0) return {0, 0};
  if (area < 0) std::swap(corner[1], corner[2]);
  Part part;
  double above_a = 0, above_b = 0;  // depth of the triangle's plane there, times its area
  for (int k = 0; k < 3; ++k) {
    const Vec2 from = in_picture(corner[(k + 1) % 3]), side = in_picture(corner[(k + 2) % 3]) - from;
    const double at_a = cross(side, in_picture(a) - from), at_b = cross(side, in_picture(b) - from);
    part.keep_positive(at_a, at_b);
    above_a += at_a * (corner[k][2] - a[2]);
    above_b += at_b * (corner[k][2] - b[2]);
  }
  part.keep_positive(above_a, above_b);
  return part;
}

/// Where it lies behind the sphere or in it.
Part behind(const Vec3& a, const Vec3& b, const Vec3& centre, double radius) {
  const Vec3 x = a - centre, y = b - a;
  Part part =
      within(in_picture(x), in_picture(y), radius);  // there it is beyond the middle, or in the sphere
  part.keep_positive(-x[2], -(b - centre)[2]);
  const Part inside = within(x, y, radius);
  if (inside.low >= inside.high) return part;
  if (part.low >= part.high) return inside;
  return {std::min(part.low, inside.low), std::max(part.high, inside.high)};
}

}  // namespace

std::vector<std::pair<double, double>> visible_parts(const SolidScene& scene, const ViewAxes& axes,
                                                     const Vec3& a, const Vec3& b) {
  const Vec3 from = axes.of(a), to = axes.of(b);
  std::vector<Part> hidden;
  const auto hide = [&](const Part& part) {
    if (part.low < part.high) hidden.push_back(part);
  };
  std::vector<Vec3> vertex;
  for (const Vec3& x : scene.vertex) vertex.push_back(axes.of(x));
  for (const SolidTriangle& t : scene.triangle) {
    const std::array<Vec3, 3> corner{vertex[t.vertex[0]], vertex[t.vertex[1]], vertex[t.vertex[2]]};
    BoundsOf<3> bounds{corner[0], corner[0]};
    bounds.include(corner[1]);
    bounds.include(corner[2]);
    if (!misses(from, to, bounds)) hide(behind(from, to, corner));
  }
  for (const SolidSphere& s : scene.sphere) {
    const Vec3 centre = axes.of(s.centre);
    if (!misses(from, to, BoundsOf<3>{centre, centre}.grown(s.radius)))
      hide(behind(from, to, centre, s.radius));
  }
  constexpr double rounding = 1e-9;  // shorter parts are gaps between triangles that share an edge
  std::ranges::sort(hidden, {}, &Part::low);
  std::vector<std::pair<double, double>> visible;
  double end = 0;
  for (const Part& part : hidden) {
    if (part.low > end + rounding) visible.emplace_back(end, part.low);
    end = std::max(end, part.high);
  }
  if (end < 1 - rounding) visible.emplace_back(end, 1);
  return visible;
}

std::vector<std::pair<double, double>> uncovered_parts(const SolidImage& image, const Vec2& a,
                                                       const Vec2& b) {
  const auto is_covered = [&](double share) {
    const Vec2 at = a + share * (b - a);
    const double x = std::floor(at[0]), y = std::floor(at[1]);
    if (!(0 <= x && x < image.width && 0 <= y && y < image.height)) return false;
    return image.covered[static_cast<std::size_t>(y) * image.width + static_cast<std::size_t>(x)] >= 8;
  };
  const int steps = std::max(1, static_cast<int>(2 * norm(b - a)));
  std::vector<std::pair<double, double>> parts;
  bool goes_on = false;
  for (int k = 0; k < steps; ++k) {
    const bool is_shown = !is_covered((k + 0.5) / steps);
    if (is_shown && !goes_on) parts.emplace_back(1.0 * k / steps, 0);
    if (is_shown) parts.back().second = (k + 1.0) / steps;
    goes_on = is_shown;
  }
  std::erase_if(parts, [&](const auto& part) { return (part.second - part.first) * norm(b - a) < 2; });
  return parts;
}

}  // namespace supple
