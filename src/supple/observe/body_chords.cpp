#include "supple/observe/body_chords.hpp"

#include <algorithm>
#include <array>

namespace supple {
namespace {

template <std::size_t N>
BoundsOf<3> bounds_of_corners(const std::array<Vec3, N>& x, double reach) {
  BoundsOf<3> bounds{x[0], x[0]};
  for (const Vec3& corner : x) bounds.include(corner);
  return bounds.grown(reach);
}

/// Sorts crossings and appends the intervals where the winding number is not 0.
void append_inside(std::vector<Crossing>& crossings, std::vector<Interval>& chords) {
  std::sort(crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) {
    return a.height < b.height || (a.height == b.height && a.winding > b.winding);
  });
  int winding = 0;
  for (std::size_t k = 0; k + 1 < crossings.size(); ++k) {
    winding += crossings[k].winding;
    if (winding != 0) chords.push_back({crossings[k].height, crossings[k + 1].height});
  }
}

}  // namespace

void unite(std::vector<Interval>& intervals) {
  std::sort(intervals.begin(), intervals.end(),
            [](const Interval& a, const Interval& b) { return a.low < b.low; });
  std::size_t last = 0;
  for (std::size_t k = 0; k < intervals.size(); ++k) {
    if (is_empty(intervals[k])) continue;
    if (last > 0 && intervals[k].low <= intervals[last - 1].high)
      intervals[last - 1].high = std::max(intervals[last - 1].high, intervals[k].high);
    else intervals[last++] = intervals[k];
  }
  intervals.resize(last);
}

void intersect(const std::vector<Interval>& a, const std::vector<Interval>& b, std::vector<Interval>& both) {
  both.clear();
  for (std::size_t i = 0, k = 0; i < a.size() && k < b.size();) {
    const Interval common{std::max(a[i].low, b[k].low), std::min(a[i].high, b[k].high)};
    if (!is_empty(common)) both.push_back(common);
    if (a[i].high < b[k].high) ++i;
    else ++k;
  }
}

BodyChords::BodyChords(const BodySurface& shape, Outline outline) : shape_(&shape), tiles_(x_, y_) {
  const bool smooth = outline == Outline::smooth && !shape.is_sphere();
  for (std::int32_t k = 0; k < shape.size(); ++k)
    if (shape.radius[k] > 0)
      add(Kind::sphere, k, bounds_of_corners(std::array{shape.vertex[k]}, shape.radius[k]));
  if (smooth && shape.radius[0] > 0) {
    for (std::int32_t k = 0; k < static_cast<std::int32_t>(shape.hinge.size()); ++k) {
      const auto [a, b, c, d] = shape.corners(shape.hinge[k]);
      add(Kind::cylinder, k, bounds_of_corners(std::array{a, b}, shape.radius[0]));
    }
    for (std::int32_t k = 0; k < static_cast<std::int32_t>(shape.face.size()); ++k)
      add(Kind::prism, k, bounds_of_corners(shape.corners(shape.face[k]), shape.radius[0]));
  }
  for (std::int32_t k = 0; k < static_cast<std::int32_t>(shape.face.size()); ++k)
    add(Kind::triangle, k, bounds_of_corners(shape.corners(shape.face[k]), 0));
  tiles_ = Tiles(x_, y_);
}

void BodyChords::add(Kind kind, std::int32_t number, const BoundsOf<3>& bounds) {
  parts_.push_back({kind, number});
  x_.push_back({bounds.low[0], bounds.high[0]});
  y_.push_back({bounds.low[1], bounds.high[1]});
}

Interval BodyChords::chord_of(const Part& part, const LineAlongZ& line) const {
  const BodySurface& s = *shape_;
  if (part.kind == Kind::sphere) return chord_of_sphere(line, s.vertex[part.number], s.radius[part.number]);
  if (part.kind == Kind::cylinder) {
    const auto& hinge = s.hinge[part.number];
    return chord_of_cylinder(line, s.vertex[hinge[0]], s.vertex[hinge[1]], s.radius[0]);
  }
  const auto [a, b, c] = s.corners(s.face[part.number]);
  return chord_of_prism(line, {a, b, c}, s.radius[0]);
}

void BodyChords::find(const LineAlongZ& line, std::vector<Interval>& chords) const {
  static thread_local std::vector<Crossing> crossings;
  crossings.clear();
  chords.clear();
  if (!(shape_->bounds.low[0] <= line[0] && line[0] <= shape_->bounds.high[0])) return;
  for (const std::int32_t k : tiles_.at(line[0], line[1])) {
    const Part& part = parts_[k];
    if (line[0] < x_[k].low || x_[k].high < line[0] || line[1] < y_[k].low || y_[k].high < line[1]) continue;
    if (part.kind == Kind::triangle) {
      const auto [a, b, c] = shape_->corners(shape_->face[part.number]);
      if (const Crossing at = crossing_of(line, {a, b, c}); at.winding != 0) crossings.push_back(at);
    } else if (const Interval chord = chord_of(part, line); !is_empty(chord)) {
      chords.push_back(chord);
    }
  }
  append_inside(crossings, chords);
  unite(chords);
}

}  // namespace supple
