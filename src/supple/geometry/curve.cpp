#include "supple/geometry/curve.hpp"

#include <algorithm>
#include <numbers>

namespace supple {
namespace {

constexpr double slack = 1e-9;  // of t: an extra cut costs nothing, a missed one an area
constexpr double turn = 2 * std::numbers::pi;

void append_clamped(double t, std::vector<double>& list) {
  if (t >= -slack && t <= 1 + slack) list.push_back(std::clamp(t, 0.0, 1.0));
}

void append_angle(const Curve& arc, double angle, std::vector<double>& list) {
  double ahead = std::fmod(angle - arc.begin, turn);
  if (ahead < 0) ahead += turn;
  append_clamped(ahead / arc.sweep, list);
  append_clamped((ahead - turn) / arc.sweep, list);  // just before the begin
}

/// Both t of the line `s` at which it meets the circle, also where it only nearly touches; false if far from
/// it.
bool line_meets_circle(const Curve& s, const Vec2& centre, double radius, double (&t)[2]) {
  const double square = dot(s.along, s.along);
  if (!(square > 0)) return false;
  const Vec2 r = centre - s.from;
  const double foot = dot(r, s.along) / square, height = cross(s.along, r) / std::sqrt(square);
  const double half_chord_square = (radius - height) * (radius + height);
  if (half_chord_square < -slack * radius * radius) return false;
  const double half = std::sqrt(std::max(half_chord_square, 0.0) / square);
  t[0] = foot - half;
  t[1] = foot + half;
  return true;
}

void cut_segment_by_segment(const Curve& a, const Curve& b, std::vector<double>& list) {
  const Vec2 r = b.from - a.from;
  const double area = cross(a.along, b.along);
  const double scale = std::sqrt(dot(a.along, a.along) * dot(b.along, b.along));
  if (!(scale > 0)) return;
  if (std::abs(area) <= slack * scale) {  // on one line, nearly: where the other begins and ends, too
    const double square = dot(a.along, a.along);
    if (std::abs(cross(r, a.along)) > slack * (square + scale)) return;
    append_clamped(dot(r, a.along) / square, list);
    append_clamped(dot(r + b.along, a.along) / square, list);
    if (area == 0) return;
  }
  const double u = cross(r, a.along) / area;
  if (u >= -slack && u <= 1 + slack) append_clamped(cross(r, b.along) / area, list);
}

void cut_arc_by_segment(const Curve& a, const Curve& b, std::vector<double>& list) {
  double t[2];
  if (!line_meets_circle(b, a.centre, a.radius, t)) return;
  for (const double u : t) {
    if (u < -slack || u > 1 + slack) continue;
    const Vec2 r = b.at(u) - a.centre;
    append_angle(a, std::atan2(r[1], r[0]), list);
  }
}

void cut_arc_by_circle(const Curve& a, const Curve& b, std::vector<double>& list) {
  const Vec2 r = b.centre - a.centre;
  const double distance = norm(r);
  if (!(distance > 0)) return;
  const double along = 0.5 * (distance + (a.radius - b.radius) * (a.radius + b.radius) / distance);
  const double cosine = along / a.radius;
  if (std::abs(cosine) > 1 + slack) return;
  const double half = std::acos(std::clamp(cosine, -1.0, 1.0)), middle = std::atan2(r[1], r[0]);
  append_angle(a, middle - half, list);
  append_angle(a, middle + half, list);
}

}  // namespace

Curve Curve::circle(const Vec2& centre, double radius) { return arc(centre, radius, 0, turn); }

Vec2 Curve::at(double t) const {
  if (straight()) return from + t * along;
  const double angle = begin + t * sweep;
  return centre + radius * Vec2{std::cos(angle), std::sin(angle)};
}

double Curve::swept_area(const Vec2& origin, double t0, double t1) const {
  if (straight()) return 0.5 * (t1 - t0) * cross(from - origin, along);
  return 0.5 * (radius * radius * sweep * (t1 - t0) + cross(centre - origin, at(t1) - at(t0)));
}

Bounds Curve::bounds() const {
  if (!straight()) {
    const double reach = (1 + slack) * radius;
    return {centre - Vec2{reach, reach}, centre + Vec2{reach, reach}};
  }
  Bounds b{at(-slack), at(-slack)};
  b.include({at(1 + slack), at(1 + slack)});
  return b;
}

void append_crossings(const Curve& a, const Curve& b, std::vector<double>& t) {
  if (a.straight() && b.straight()) return cut_segment_by_segment(a, b, t);
  if (!a.straight()) return b.straight() ? cut_arc_by_segment(a, b, t) : cut_arc_by_circle(a, b, t);
  double meeting[2];
  if (!line_meets_circle(a, b.centre, b.radius, meeting)) return;
  for (const double u : meeting) append_clamped(u, t);
}

}  // namespace supple
