#include "supple/draw/solid/solid_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>

#include "supple/core/error.hpp"
#include "supple/draw/scene/colors_apart.hpp"
#include "supple/draw/scene/drawn_cell.hpp"
#include "supple/draw/solid/cell_planes.hpp"
#include "supple/draw/solid/vertex_normals.hpp"

namespace supple {

namespace {

bool is_finite(const Vec3& x) { return std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]); }

/// Lattice vector that brings the mean of these sites into the leaning cell.
Vec3 shift_home(const Box<3>& box, std::span<const Vec3> sites) {
  Vec3 mean{};
  for (const Vec3& x : sites) mean += (1.0 / static_cast<double>(sites.size())) * x;
  return into_cell(box, mean) - mean;
}

/// Moves each vertex outward, along its normal, by its radius.
void inflate(SolidScene& scene, std::span<const double> radius) {
  const std::vector<Vec3> normal = vertex_normals(scene);
  for (std::size_t i = 0; i < scene.vertex.size(); ++i) scene.vertex[i] += radius[i] * normal[i];
}

void check_arrays(const Topology<3>& topology, std::size_t positions, std::size_t radii) {
  const std::string what = "these particles cannot be drawn";
  if (positions != radii) throw input_error(what, fmt::format("{} radii for {} sites", radii, positions));
  const std::vector<std::int32_t>&begin = topology.begin, &facets = topology.facet_begin;
  const bool covers = begin.empty() || (begin.front() == 0 && std::ranges::is_sorted(begin) &&
                                        static_cast<std::size_t>(begin.back()) == positions);
  if (!covers) throw input_error(what, "bodies do not cover all sites");
  const bool fits = begin.empty() ? topology.facet.empty()
                                  : facets.size() == begin.size() && facets.front() == 0 &&
                                        std::ranges::is_sorted(facets) &&
                                        static_cast<std::size_t>(facets.back()) == topology.facet.size();
  if (!fits) throw input_error(what, "triangles do not belong to bodies");
  const auto is_site = [&](std::int32_t i) { return 0 <= i && static_cast<std::size_t>(i) < positions; };
  for (const auto& facet : topology.facet)
    if (!std::ranges::all_of(facet, is_site))
      throw input_error(what, "a triangle names a site that is not there");
}

/// A sphere about each body: the middle of the bounds of its vertices, and how far it reaches from there.
struct Ball {
  BoundsOf<3> bounds;
  double reach = 0;
  Vec3 centre() const { return 0.5 * (bounds.low + bounds.high); }
};

std::vector<Ball> balls_about(const SolidScene& scene) {
  constexpr double far = std::numeric_limits<double>::max();
  std::vector<Ball> ball(scene.particle.size(), Ball{{{far, far, far}, {-far, -far, -far}}});
  const auto each_corner = [&](auto&& visit) {
    for (const SolidTriangle& t : scene.triangle)
      for (const std::int32_t v : t.vertex) visit(ball[t.body], scene.vertex[v], 0.0);
    for (const SolidSphere& s : scene.sphere) visit(ball[s.body], s.centre, s.radius);
  };
  each_corner([](Ball& b, const Vec3& x, double r) { b.bounds.include(BoundsOf<3>{x, x}.grown(r)); });
  each_corner(
      [](Ball& b, const Vec3& x, double r) { b.reach = std::max(b.reach, norm(x - b.centre()) + r); });
  return ball;
}

/// The sides of the cell in its periodic directions.
std::vector<CellPlane> periodic_sides(const Box<3>& box) {
  std::vector<CellPlane> sides = cell_planes(box);
  std::erase_if(sides, [&](const CellPlane& p) { return !box.periodic[p.direction]; });
  return sides;
}

/// Adds the images of all bodies that reach into the cell.
void add_images(SolidScene& scene) {
  const std::vector<CellPlane> sides = periodic_sides(scene.box);
  const std::vector<Ball> ball = balls_about(scene);
  std::vector<std::vector<Vec3>> shifts(ball.size());  // of the images of each body
  for (const Vec3& shift : neighbour_cells(scene.box))
    for (std::size_t b = 0; b < ball.size(); ++b)
      if (shift != Vec3{} && std::ranges::all_of(sides, [&](const CellPlane& p) {
            return dot(p.normal, ball[b].centre() + shift) < p.level + ball[b].reach;
          }))
        shifts[b].push_back(shift);
  const auto copy = [&](auto& shapes, auto&& copied) {
    std::vector<std::int32_t> first(ball.size());  // the body of the first image
    for (std::size_t b = 0, next = ball.size(); b < ball.size(); next += shifts[b++].size())
      first[b] = static_cast<std::int32_t>(next);
    const std::size_t count = shapes.size();
    for (std::size_t k = 0; k < count; ++k)
      for (std::size_t i = 0; i < shifts[shapes[k].body].size(); ++i) {
        auto shape = shapes[k];
        const Vec3& shift = shifts[shape.body][i];
        shape.body = first[shape.body] + static_cast<std::int32_t>(i);
        copied(shape, shift);
        shapes.push_back(shape);
      }
  };
  std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> moved;  // vertex and body: the vertex there
  copy(scene.triangle, [&](SolidTriangle& t, const Vec3& shift) {
    for (std::int32_t& v : t.vertex) {
      const auto [at, is_new] =
          moved.try_emplace({t.body, v}, static_cast<std::int32_t>(scene.vertex.size()));
      if (is_new) scene.vertex.push_back(scene.vertex[v] + shift);
      v = at->second;
    }
  });
  copy(scene.sphere, [](SolidSphere& s, const Vec3& shift) { s.centre += shift; });
  for (std::size_t b = 0; b < ball.size(); ++b)
    scene.particle.insert(scene.particle.end(), shifts[b].size(), scene.particle[b]);
}

/// Adds which particles are close to each other in this scene.
void add_neighbours(const SolidScene& scene, std::map<std::int32_t, std::set<std::int32_t>>& close) {
  constexpr double tolerance = 1.02;  // particles that touch may be apart by the rounding of their surfaces
  const std::vector<Ball> ball = balls_about(scene);
  std::vector<std::int32_t> order(ball.size());
  std::iota(order.begin(), order.end(), 0);
  const auto low = [&](std::int32_t p) { return ball[p].bounds.low[0]; };
  std::ranges::stable_sort(order, {}, low);
  double widest = 0;
  for (const Ball& b : ball) widest = std::max(widest, 2 * tolerance * b.reach);
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i + 1; j < order.size() && low(order[j]) < low(order[i]) + widest; ++j) {
      const Ball &a = ball[order[i]], &b = ball[order[j]];
      if (norm(a.centre() - b.centre()) > tolerance * (a.reach + b.reach)) continue;
      const std::int32_t p = scene.particle[order[i]], q = scene.particle[order[j]];
      if (p == q) continue;
      close[p].insert(q);
      close[q].insert(p);
    }
}

}  // namespace

SolidScene solid_scene_of(const Box<3>& box, const Topology<3>& topology, std::span<const Vec3> position,
                          std::span<const double> radius, Images images, Skin skin) {
  check_arrays(topology, position.size(), radius.size());
  SolidScene scene;
  scene.box = box;
  scene.images = images;
  scene.particles = topology.body_count(static_cast<int>(position.size()));
  scene.vertex.assign(position.begin(), position.end());
  for (std::int32_t b = 0; b < scene.particles; ++b) {
    scene.particle.push_back(b);
    const int first = topology.body_begin(b), size = topology.body_size(b);
    const std::span<Vec3> sites = std::span(scene.vertex).subspan(first, size);
    const Vec3 shift = shift_home(box, sites);
    for (Vec3& x : sites) x += shift;
    const bool is_surface = !topology.begin.empty() && topology.facet_begin[b] < topology.facet_begin[b + 1];
    for (int i = first; i < first + size && (!is_surface || skin == Skin::vertices); ++i)
      scene.sphere.push_back({scene.vertex[i], radius[i], b});
    for (int f = is_surface ? topology.facet_begin[b] : 0; is_surface && f < topology.facet_begin[b + 1]; ++f)
      scene.triangle.push_back({topology.facet[f], b});
  }
  if (skin == Skin::inflated) inflate(scene, radius);
  if (images == Images::cut) add_images(scene);
  return scene;
}

SolidScene solid_scene_of(const System<3>& system, Images images, Skin skin) {
  SolidScene scene =
      solid_scene_of(system.box, system.topology, system.state.position, system.state.radius, images, skin);
  scene.time = system.time;
  return scene;
}

void check_scene(const SolidScene& scene, const std::string& path) {
  const std::string what = "cannot draw '" + path + "'";
  if (scene.triangle.empty() && scene.sphere.empty()) throw input_error(what, "it has no particles");
  const auto is_body = [&](std::int32_t b) { return 0 <= b && b < static_cast<int>(scene.particle.size()); };
  for (const std::int32_t p : scene.particle)
    if (p < 0 || p >= scene.particles) throw input_error(what, "a body is of a particle that is not there");
  const auto vertices = static_cast<std::int32_t>(scene.vertex.size());
  for (std::size_t k = 0; k < scene.triangle.size(); ++k) {
    const SolidTriangle& t = scene.triangle[k];
    if (!is_body(t.body) ||
        !std::ranges::all_of(t.vertex, [&](std::int32_t v) { return 0 <= v && v < vertices; }))
      throw input_error(what, fmt::format("triangle {} names a vertex or a body that is not there", k));
  }
  for (std::int32_t v = 0; v < vertices; ++v)
    if (!is_finite(scene.vertex[v])) throw input_error(what, fmt::format("vertex {} is not finite", v));
  for (std::size_t k = 0; k < scene.sphere.size(); ++k) {
    const SolidSphere& s = scene.sphere[k];
    if (!is_body(s.body)) throw input_error(what, fmt::format("sphere {} is of a body that is not there", k));
    if (!is_finite(s.centre) || !std::isfinite(s.radius) || s.radius < 0)
      throw input_error(what, fmt::format("sphere {} has a centre or radius that cannot be", k));
  }
  for (const double l : scene.box.length.e)
    if (!(std::isfinite(l) && l > 0)) throw input_error(what, "the cell has a side that is not above 0");
  if (!std::isfinite(scene.box.strain) || !std::isfinite(scene.time))
    throw input_error(what, "its time or the strain of its cell is not finite");
}

std::vector<Color> colors_apart(std::span<const SolidScene> scenes) {
  std::map<std::int32_t, std::set<std::int32_t>> close;
  for (const SolidScene& scene : scenes) add_neighbours(scene, close);
  std::vector<std::int32_t> particles(scenes.front().particles);
  std::iota(particles.begin(), particles.end(), 0);
  std::map<std::int32_t, int> choice = palette_apart(particles, close);
  std::vector<Color> color;
  for (const std::int32_t p : particles) color.push_back(area_palette[choice[p]]);
  return color;
}

}  // namespace supple
