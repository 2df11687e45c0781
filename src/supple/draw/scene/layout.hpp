/// Which images of bodies and contacts a picture of the cell shows.
#pragma once
#include <vector>

#include "supple/draw/scene/drawn_cell.hpp"
#include "supple/draw/scene/scene.hpp"

namespace supple {

/// A body or a periodic image of it: its sites are drawn at position + shift.
struct DrawnBody {
  std::int32_t body;
  Vec2 shift;
  Lies lies;
};

/// A contact between the images that touch.
struct ContactImage {
  std::size_t contact;  ///< index into Scene::contacts
  Vec2 from, to;
  Lies lies;
};

/// The bodies that come within `margin` [length] of the leaning cell: first each body once, where it lies in
/// the cell, in the order of bodies; then the images.
std::vector<DrawnBody> lay_out_bodies(const Scene& scene, double margin);

/// The contacts that come within `margin` of the leaning cell, drawn the shortest way. A link longer than
/// half the cell keeps its own image: that in the direction of SceneContact::towards.
std::vector<ContactImage> lay_out_contacts(const Scene& scene, double margin);

}  // namespace supple
