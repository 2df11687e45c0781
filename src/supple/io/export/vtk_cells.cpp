#include "supple/io/export/vtk_cells.hpp"

#include <cmath>
#include <numbers>

#include "supple/core/error.hpp"
#include "supple/draw/scene/polygon_outline.hpp"

namespace supple {

namespace {

/// Adds polygons with points of their own.
class PolygonWriter {
 public:
  explicit PolygonWriter(VtkCells<2>& to) : to_(to) {}

  void add(std::int32_t site, const Vec2& x) {
    to_.connectivity.push_back(static_cast<std::int64_t>(to_.point.size()));
    to_.point.push_back(x);
    to_.site.push_back(site);
  }
  void close(std::int32_t body) {
    to_.offset.push_back(static_cast<std::int64_t>(to_.point.size()));
    to_.body.push_back(body);
  }

 private:
  VtkCells<2>& to_;
};

std::vector<Vec2> circle(const Vec2& centre, double radius) {
  std::vector<Vec2> out;
  for (int k = 0; k < disc_corners; ++k) {
    const double angle = 2 * std::numbers::pi * k / disc_corners;
    out.push_back(centre + radius * Vec2{std::cos(angle), std::sin(angle)});
  }
  return out;
}

std::int32_t nearest(const std::vector<Vec2>& ring, const Vec2& x) {
  std::size_t best = 0;
  for (std::size_t k = 1; k < ring.size(); ++k)
    if (norm(ring[k] - x) < norm(ring[best] - x)) best = k;
  return static_cast<std::int32_t>(best);
}

}  // namespace

void check_cells(Cells cells, int dimensions) {
  if (dimensions == 3 && cells == Cells::outlines)
    throw input_error("particles in three dimensions have no outlines",
                      "these are of polygons with the discs on their vertices",
                      "take --cells triangles, which are those of the surfaces");
}

VtkCells<2> vtk_cells(const BodyScene<2>& scene, const std::vector<Vec2>& shift, Cells cells) {
  VtkCells<2> out;
  PolygonWriter polygon(out);
  for (std::int32_t b = 0; b < scene.bodies(); ++b) {
    const auto [first, last] = scene.boundary_of(b);
    std::vector<Vec2> ring;
    std::vector<double> radius;
    for (std::int32_t i = first; i < last; ++i) {
      ring.push_back(scene.position[i] + shift[b]);
      radius.push_back(scene.radius[i]);
    }
    if (cells == Cells::polygons && ring.size() > 1) {
      for (std::int32_t i = first; i < last; ++i) polygon.add(i, ring[i - first]);
      polygon.close(b);
      continue;
    }
    const std::vector<Vec2> outline =
        ring.size() == 1 ? circle(ring[0], radius[0]) : outer_ring(ring, radius);
    const auto add_point = [&, first = first](const Vec2& x) { polygon.add(first + nearest(ring, x), x); };
    if (cells != Cells::triangles) {
      for (const Vec2& x : outline) add_point(x);
      polygon.close(b);
      continue;
    }
    for (const auto& triangle : triangulate(outline)) {
      for (const std::size_t k : triangle) add_point(outline[k]);
      polygon.close(b);
    }
  }
  return out;
}

VtkCells<3> vtk_cells(const BodyScene<3>& scene, const std::vector<Vec3>& shift, Cells cells) {
  check_cells(cells, 3);
  VtkCells<3> out;
  const std::vector<std::int32_t> body = body_of_sites(scene);
  for (std::int32_t i = 0; i < scene.sites(); ++i) {
    out.point.push_back(scene.position[i] + shift[body[i]]);
    out.site.push_back(i);
    if (!scene.is_disc(body[i])) continue;
    out.vertex.push_back(i);
    out.body.push_back(body[i]);
  }
  for (const auto& facet : scene.facet) {
    out.connectivity.insert(out.connectivity.end(), facet.begin(), facet.end());
    out.offset.push_back(static_cast<std::int64_t>(out.connectivity.size()));
    out.body.push_back(body[facet[0]]);
  }
  return out;
}

}  // namespace supple
