#include "supple/draw/scene/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
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

void check_bodies(const Scene& scene, const std::string& what) {
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

Vec2 Scene::centre_of(std::int32_t b) const {
  Vec2 sum{};
  for (const Vec2& x : positions_of(b)) sum += x;
  return (1.0 / static_cast<double>(positions_of(b).size())) * sum;
}

bool Scene::is_held(std::int32_t b) const {
  return !mobility.empty() && std::ranges::count(of_body(mobility, b), Mobility::free) == 0;
}

void check_scene(const Scene& scene, const std::string& path) {
  const std::string what = "cannot write '" + path + "'";
  if (scene.radius.size() != scene.position.size())
    throw input_error(what, fmt::format("{} radii for {} sites", scene.radius.size(), scene.position.size()));
  check_bodies(scene, what);
  const auto fits = [](std::size_t size, std::int32_t count) {
    return size == 0 || size == static_cast<std::size_t>(count);
  };
  if (!fits(scene.mobility.size(), scene.sites()) || !fits(scene.particle.size(), scene.bodies()))
    throw input_error(what, "mobility or particle is not of each site or body");
  check_arrays(scene.of_sites, scene.sites(), "sites", what);
  check_arrays(scene.of_bodies, scene.bodies(), "bodies", what);
  const auto is_site = [&](std::int32_t i) { return 0 <= i && i < scene.sites(); };
  for (const SceneContact& c : scene.contacts)
    if (!is_site(c.first) || !is_site(c.second))
      throw input_error(what, "a contact names a site that is not there");
}

std::vector<std::int32_t> body_of_sites(const Scene& scene) {
  std::vector<std::int32_t> body;
  for (std::int32_t b = 0; b < scene.bodies(); ++b) body.resize(scene.body(b).second, b);
  return body;
}

std::vector<bool> single_discs(const Scene& scene) {
  std::map<std::int32_t, int> bodies;
  for (const std::int32_t p : scene.particle) ++bodies[p];
  std::vector<bool> single(scene.bodies(), false);
  for (std::int32_t b = 0; b < scene.bodies(); ++b)
    single[b] = scene.is_disc(b) && !scene.particle.empty() && bodies[scene.particle[b]] == 1;
  return single;
}

std::vector<Vec2> placement_shifts(const Scene& scene, Placement placement) {
  std::vector<Vec2> shifts(scene.bodies());
  if (placement == Placement::unwrapped) return shifts;
  for (std::int32_t b = 0; b < scene.bodies(); ++b) {
    const Vec2 mean = scene.centre_of(b);
    shifts[b] = into_cell(scene.box, mean) - mean;
  }
  return shifts;
}

double strongest_force(const Scene& scene) {
  std::vector<double> force;
  for (const SceneContact& c : scene.contacts) force.push_back(c.force);
  if (force.empty()) return 0;
  const auto at = force.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(force.size() - 1));
  std::nth_element(force.begin(), at, force.end());
  return *at * scene.units.force();
}

}  // namespace supple
