#include "supple/draw/scene/body_scene.hpp"

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

template <int Dim>
void check_sites(const BodyScene<Dim>& scene, const std::string& what) {
  if (scene.begin.empty()) return;
  if (scene.begin.front() != 0 || scene.begin.back() != scene.sites())
    throw input_error(what, "its bodies do not cover all sites");
  for (std::int32_t b = 0; b < scene.bodies(); ++b) {
    const std::int32_t sites = scene.begin[b + 1] - scene.begin[b];
    if (sites < 1 || (sites != 1 && sites <= Dim))
      throw input_error(
          what, fmt::format("body {} has {} sites", b, sites),
          Dim == 2 ? "a disc has 1, a polygon 3 or more" : "a sphere has 1, a closed surface 4 or more");
  }
}

/// A surface without triangles would be in no file.
void check_facets(const BodyScene<3>& scene, const std::string& what) {
  const std::vector<std::int32_t> body = body_of_sites(scene);
  std::vector<bool> has_facets(scene.bodies(), false);
  for (const auto& facet : scene.facet) {
    for (const std::int32_t i : facet)
      if (i < 0 || i >= scene.sites()) throw input_error(what, "a triangle names a site that is not there");
    for (const std::int32_t i : facet)
      if (body[i] != body[facet[0]])
        throw input_error(what, fmt::format("a triangle joins bodies {} and {}", body[facet[0]], body[i]));
    has_facets[body[facet[0]]] = true;
  }
  for (std::int32_t b = 0; b < scene.bodies(); ++b)
    if (scene.is_disc(b) == has_facets[b])
      throw input_error(
          what,
          fmt::format("body {} {}", b, scene.is_disc(b) ? "is one site with triangles" : "has no triangles"));
}

}  // namespace

template <int Dim>
Vec<Dim> BodyScene<Dim>::centre_of(std::int32_t b) const {
  Vec<Dim> sum{};
  for (const Vec<Dim>& x : positions_of(b)) sum += x;
  return (1.0 / static_cast<double>(positions_of(b).size())) * sum;
}

template <int Dim>
void check_bodies(const BodyScene<Dim>& scene, const std::string& path) {
  const std::string what = "cannot write '" + path + "'";
  if (scene.radius.size() != scene.position.size())
    throw input_error(what, fmt::format("{} radii for {} sites", scene.radius.size(), scene.position.size()));
  check_sites(scene, what);
  if constexpr (Dim == 3) check_facets(scene, what);
  check_arrays(scene.of_sites, scene.sites(), "sites", what);
  check_arrays(scene.of_bodies, scene.bodies(), "bodies", what);
}

template <int Dim>
std::vector<std::int32_t> body_of_sites(const BodyScene<Dim>& scene) {
  std::vector<std::int32_t> body;
  for (std::int32_t b = 0; b < scene.bodies(); ++b) body.resize(scene.body(b).second, b);
  return body;
}

template <int Dim>
std::vector<Vec<Dim>> placement_shifts(const BodyScene<Dim>& scene, Placement placement) {
  std::vector<Vec<Dim>> shifts(scene.bodies());
  if (placement == Placement::unwrapped) return shifts;
  for (std::int32_t b = 0; b < scene.bodies(); ++b) {
    const Vec<Dim> mean = scene.centre_of(b);
    shifts[b] = into_cell(scene.box, mean) - mean;
  }
  return shifts;
}

template struct BodyScene<2>;
template struct BodyScene<3>;
template void check_bodies(const BodyScene<2>&, const std::string&);
template void check_bodies(const BodyScene<3>&, const std::string&);
template std::vector<std::int32_t> body_of_sites(const BodyScene<2>&);
template std::vector<std::int32_t> body_of_sites(const BodyScene<3>&);
template std::vector<Vec2> placement_shifts(const BodyScene<2>&, Placement);
template std::vector<Vec3> placement_shifts(const BodyScene<3>&, Placement);

}  // namespace supple
