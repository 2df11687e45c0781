#include "supple/draw/scene/polygon_scene.hpp"

#include <fmt/format.h>

#include <set>

#include "supple/core/error.hpp"
#include "supple/draw/scene/drawn_cell.hpp"

namespace supple {

namespace {

void check_arrays(const std::vector<SceneArray>& arrays, std::int32_t count, const char* owner,
                  const std::string& what) {
  std::set<std::string> names;
  for (const SceneArray& array : arrays) {
    const std::size_t size = std::visit([](const auto& values) { return values.size(); }, array.values);
    if (size != static_cast<std::size_t>(count))
      throw input_error(what,
                        fmt::format("array '{}' has {} values for {} {}", array.name, size, count, owner));
    if (array.name.empty() || !names.insert(array.name).second)
      throw input_error(what,
                        fmt::format("two arrays of {} are named '{}', or it has no name", owner, array.name));
  }
}

void check_bodies(const PolygonScene& scene, const std::string& what) {
  if (scene.begin.empty()) return;
  if (scene.begin.front() != 0 || scene.begin.back() != scene.sites())
    throw input_error(what, "its bodies do not cover all sites");
  for (std::int32_t b = 0; b < scene.bodies(); ++b) {
    const std::int32_t sites = scene.begin[b + 1] - scene.begin[b];
    if (sites < 1 || sites == 2)
      throw input_error(what, fmt::format("body {} has {} sites", b, sites),
                        "a disc has 1, a polygon 3 or more");
  }
}

}  // namespace

void check_scene(const PolygonScene& scene, const std::string& path) {
  const std::string what = "cannot write '" + path + "'";
  if (scene.radius.size() != scene.position.size())
    throw input_error(what, fmt::format("{} radii for {} sites", scene.radius.size(), scene.position.size()));
  check_bodies(scene, what);
  check_arrays(scene.of_sites, scene.sites(), "sites", what);
  check_arrays(scene.of_bodies, scene.bodies(), "bodies", what);
  const auto is_site = [&](std::int32_t i) { return 0 <= i && i < scene.sites(); };
  for (const SceneContact& c : scene.contacts)
    if (!is_site(c.first) || !is_site(c.second))
      throw input_error(what, "a contact names a site that is not there");
}

std::vector<std::int32_t> body_of_sites(const PolygonScene& scene) {
  std::vector<std::int32_t> body;
  for (std::int32_t b = 0; b < scene.bodies(); ++b) body.resize(scene.body(b).second, b);
  return body;
}

std::vector<Vec2> placement_shifts(const PolygonScene& scene, Placement placement) {
  std::vector<Vec2> shifts(scene.bodies());
  if (placement == Placement::unwrapped) return shifts;
  for (std::int32_t b = 0; b < scene.bodies(); ++b) {
    const auto [first, last] = scene.body(b);
    Vec2 mean{};
    for (std::int32_t i = first; i < last; ++i) mean += scene.position[i];
    mean *= 1.0 / (last - first);
    shifts[b] = into_cell(scene.box, mean) - mean;
  }
  return shifts;
}

}  // namespace supple
