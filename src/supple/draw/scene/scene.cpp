#include "supple/draw/scene/scene.hpp"

#include <algorithm>
#include <map>

#include "supple/core/error.hpp"

namespace supple {

bool Scene::is_held(std::int32_t b) const {
  return !mobility.empty() && std::ranges::count(of_body(mobility, b), Mobility::free) == 0;
}

void check_scene(const Scene& scene, const std::string& path) {
  check_bodies(scene, path);
  const std::string what = "cannot write '" + path + "'";
  const auto fits = [](std::size_t size, std::int32_t count) {
    return size == 0 || size == static_cast<std::size_t>(count);
  };
  if (!fits(scene.mobility.size(), scene.sites()) || !fits(scene.particle.size(), scene.bodies()))
    throw input_error(what, "mobility or particle is not of each site or body");
  const auto is_site = [&](std::int32_t i) { return 0 <= i && i < scene.sites(); };
  for (const SceneContact& c : scene.contacts)
    if (!is_site(c.first) || !is_site(c.second))
      throw input_error(what, "a contact names a site that is not there");
}

std::vector<bool> single_discs(const Scene& scene) {
  std::map<std::int32_t, int> bodies;
  for (const std::int32_t p : scene.particle) ++bodies[p];
  std::vector<bool> single(scene.bodies(), false);
  for (std::int32_t b = 0; b < scene.bodies(); ++b)
    single[b] = scene.is_disc(b) && !scene.particle.empty() && bodies[scene.particle[b]] == 1;
  return single;
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
