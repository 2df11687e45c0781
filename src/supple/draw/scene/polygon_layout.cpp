#include "supple/draw/scene/polygon_layout.hpp"

#include <algorithm>
#include <limits>

namespace supple {

namespace {

/// A rectangle that holds a body.
struct Extent {
  Vec2 low{std::numeric_limits<double>::max(), std::numeric_limits<double>::max()}, high = -1.0 * low;

  Vec2 centre() const { return 0.5 * (low + high); }
  double reach() const { return 0.5 * norm(high - low); }
  std::array<Vec2, 4> corners() const { return {{low, {high[0], low[1]}, high, {low[0], high[1]}}}; }
};

Extent extent_of(const PolygonScene& scene, std::int32_t body, const Vec2& shift) {
  Extent extent;
  const auto [first, last] = scene.body(body);
  for (std::int32_t i = first; i < last; ++i)
    for (int d = 0; d < 2; ++d) {
      const double x = scene.position[i][d] + shift[d];
      extent.low[d] = std::min(extent.low[d], x - scene.radius[i]);
      extent.high[d] = std::max(extent.high[d], x + scene.radius[i]);
    }
  return extent;
}

/// The next site of the ring of site i.
std::int32_t next_of(const PolygonScene& scene, const std::vector<std::int32_t>& body, std::int32_t i) {
  const auto [first, last] = scene.body(body[i]);
  return i + 1 < last ? i + 1 : first;
}

}  // namespace

std::vector<DrawnBody> lay_out_bodies(const PolygonScene& scene, double margin) {
  const std::array<Vec2, 4> corner = cell_corners(scene.box);
  const std::vector<Vec2> home = placement_shifts(scene, Placement::in_cell);
  std::vector<DrawnBody> images;
  const std::vector<Vec2> cells = neighbour_cells(scene.box);
  for (std::size_t c = 0; c < cells.size(); ++c)
    for (std::int32_t b = 0; b < scene.bodies(); ++b) {
      const Vec2 shift = home[b] + cells[c];
      const Extent extent = extent_of(scene, b, shift);
      if (c == 0 || comes_near(corner, extent.centre(), margin + extent.reach()))
        images.push_back({b, shift, lies_in(corner, extent.corners())});
    }
  return images;
}

std::vector<ContactImage> lay_out_contacts(const PolygonScene& scene, double margin) {
  const std::array<Vec2, 4> corner = cell_corners(scene.box);
  const std::vector<Vec2> cells = neighbour_cells(scene.box);
  const std::vector<std::int32_t> body = body_of_sites(scene);
  std::vector<ContactImage> images;
  for (std::size_t c = 0; c < scene.contacts.size(); ++c) {
    const SceneContact& contact = scene.contacts[c];
    const Vec2 from = into_cell(scene.box, scene.position[contact.first]);
    Vec2 arm = scene.box.displacement(from, scene.position[contact.second]);
    if (contact.along > 0)
      arm += contact.along *
             (scene.position[next_of(scene, body, contact.second)] - scene.position[contact.second]);
    for (const Vec2& shift : cells) {
      const std::array<Vec2, 2> ends{from + shift, from + shift + arm};
      if (comes_near(corner, ends[0] + 0.5 * arm, margin + 0.5 * norm(arm)))
        images.push_back({c, ends[0], ends[1], lies_in(corner, ends)});
    }
  }
  return images;
}

}  // namespace supple
