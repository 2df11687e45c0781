/// Which images of bodies and contacts a picture of the cell shows.
#pragma once
#include <vector>

#include "supple/draw/scene/drawn_cell.hpp"
#include "supple/draw/scene/polygon_scene.hpp"

namespace supple {

/// A body or a periodic image of it: its sites are at position + shift.
struct DrawnBody {
  std::int32_t body;
  Vec2 shift;
  Lies lies;
};

/// A contact between the images that touch.
struct ContactImage {
  std::size_t contact;  ///< index into PolygonScene::contacts
  Vec2 from, to;
  Lies lies;
};

/// The bodies that come within `margin` of the leaning cell: each body once where it lies in the cell, in
/// their order, then the images.
std::vector<DrawnBody> lay_out_bodies(const PolygonScene& scene, double margin);

/// The contacts that come within `margin` of it, the shortest way between what touches.
std::vector<ContactImage> lay_out_contacts(const PolygonScene& scene, double margin);

}  // namespace supple
