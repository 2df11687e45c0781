#include "supple/draw/scene/layout.hpp"

#include <algorithm>

namespace supple {

namespace {

/// The next site of the ring of site i.
std::int32_t next_of(const Scene& scene, const std::vector<std::int32_t>& body, std::int32_t i) {
  const auto [first, last] = scene.boundary_of(body[i]);
  return i + 1 < last ? i + 1 : first;
}

/// The vector to an image of a site: to the one in the direction `way`, or to the nearest, `nearest`, where
/// `way` is zero or no other image fits it better.
Vec2 shortest_along(const Vec2& nearest, const Vec2& way, const std::vector<Vec2>& cells) {
  constexpr double rounding = 1e-6;
  if (way == Vec2{}) return nearest;
  const auto off = [&](const Vec2& arm) { return norm((1 / norm(arm)) * arm - (1 / norm(way)) * way); };
  Vec2 best = nearest;
  for (const Vec2& shift : cells) {
    const Vec2 arm = nearest + shift;
    const double gain = off(best) - off(arm);
    if (gain > rounding || (gain > -rounding && norm(arm) < norm(best))) best = arm;
  }
  return best;
}

}  // namespace

std::vector<DrawnBody> lay_out_bodies(const Scene& scene, double margin) {
  const std::array<Vec2, 4> corner = cell_corners(scene.box);
  const std::vector<Vec2> home = placement_shifts(scene, Placement::in_cell);
  std::vector<DrawnBody> images;
  const std::vector<Vec2> cells = neighbour_cells(scene.box);
  for (std::size_t c = 0; c < cells.size(); ++c)
    for (std::int32_t b = 0; b < scene.bodies(); ++b) {
      const auto sites = scene.positions_of(b);
      const auto radii = scene.radii_of(b);
      const Vec2 shift = home[b] + cells[c];
      if (c == 0 || lies_in(corner, sites, radii, shift, margin) != Lies::outside)
        images.push_back({b, shift, lies_in(corner, sites, radii, shift)});
    }
  return images;
}

std::vector<ContactImage> lay_out_contacts(const Scene& scene, double margin) {
  const std::array<Vec2, 4> corner = cell_corners(scene.box);
  const std::vector<Vec2> cells = neighbour_cells(scene.box);
  const std::vector<std::int32_t> body = body_of_sites(scene);
  std::vector<ContactImage> images;
  for (std::size_t c = 0; c < scene.contacts.size(); ++c) {
    const SceneContact& contact = scene.contacts[c];
    const Vec2 from = into_cell(scene.box, scene.position[contact.first]);
    Vec2 arm =
        shortest_along(scene.box.displacement(from, scene.position[contact.second]), contact.towards, cells);
    if (contact.along > 0)
      arm += contact.along *
             (scene.position[next_of(scene, body, contact.second)] - scene.position[contact.second]);
    for (const Vec2& shift : cells) {
      const std::array<Vec2, 2> ends{from + shift, from + shift + arm};
      if (lies_in(corner, ends, {}, {}, margin) != Lies::outside)
        images.push_back({c, ends[0], ends[1], lies_in(corner, ends)});
    }
  }
  return images;
}

}  // namespace supple
