#include "supple/draw/solid/view.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <map>
#include <numbers>
#include <vector>

#include "supple/core/error.hpp"
#include "supple/core/nearest_name.hpp"

namespace supple {

namespace {

/// Cosine and sine of an angle in degrees, exact for quarters of a turn.
Vec2 on_circle(double degrees) {
  const double turns = std::remainder(degrees, 360) / 90;  // in quarters
  if (turns == std::round(turns)) {
    constexpr Vec2 quarter[]{{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    return quarter[static_cast<int>(turns + 4) % 4];
  }
  const double angle = turns * std::numbers::pi / 2;
  return {std::cos(angle), std::sin(angle)};
}

/// Reads all of the text as two numbers.
bool read_pair(const std::string& text, double& a, double& b) {
  const char* const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, a);
  if (first.ec != std::errc{} || first.ptr == end || *first.ptr != ',') return false;
  const auto second = std::from_chars(first.ptr + 1, end, b);
  return second.ec == std::errc{} && second.ptr == end;
}

}  // namespace

View view_of(const std::string& name) {
  static const std::map<std::string, View> views{
      {"corner", {}}, {"x", {0, 0}}, {"y", {-90, 0}}, {"z", {-90, 90}}};
  if (const auto at = views.find(name); at != views.end()) return at->second;
  if (View view; read_pair(name, view.azimuth, view.elevation)) {
    axes_of(view);  // throws where they are no angles
    return view;
  }
  std::vector<std::string> names;
  for (const auto& [known, view] : views) names.push_back(known);
  const auto near = nearest_name(name, names);
  throw input_error(fmt::format("there is no view '{}'", name), "",
                    (near ? fmt::format("did you mean '{}'? Or choose", *near) : std::string("choose")) +
                        " from " + join_names(names) + ", or give AZIMUTH,ELEVATION in degrees: -60,25");
}

ViewAxes axes_of(const View& view) {
  if (!std::isfinite(view.azimuth) || !(std::abs(view.elevation) <= 90))
    throw input_error(
        fmt::format("nobody can look from azimuth {}, elevation {}", view.azimuth, view.elevation), "",
        "give angles in degrees, the elevation from -90 to 90");
  const Vec2 a = on_circle(view.azimuth), e = on_circle(view.elevation);
  const Vec3 towards{e[0] * a[0], e[0] * a[1], e[1]}, right{-a[1], a[0], 0};
  return {right, cross(towards, right), towards};
}

}  // namespace supple
