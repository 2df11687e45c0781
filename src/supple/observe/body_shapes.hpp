/// The bodies of a periodic cell laid out in the plane, with the images that they may meet.
#pragma once
#include <span>
#include <vector>

#include "supple/geometry/curve.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// How far a body reaches. Rough: the polygon and a disc of its radius at every site. Smooth: everything
/// within that radius of the polygon. A body of one site is a disc either way.
enum class Outline { rough, smooth };

/// A body near the cell: a disc (one site) or a polygon, counter-clockwise.
struct BodyShape {
  std::vector<Vec2> ring;
  std::vector<double> radius;  ///< of the disc at each vertex, or by which the polygon is offset
  Bounds bounds;               ///< with the discs

  bool is_disc() const { return ring.size() == 1; }
  int size() const { return static_cast<int>(ring.size()); }
  int next(int i) const { return i + 1 < size() ? i + 1 : 0; }
  int previous(int i) const { return i > 0 ? i - 1 : size() - 1; }
  double distance_to_edge(int k, const Vec2& x) const;
  /// Exterior angle at vertex i, positive where the ring turns left.
  double turn_at(int i) const;
};

/// The copy of a body displaced by `shift`.
struct BodyImage {
  int body;
  Vec2 shift;
  Bounds bounds;
};

/// One copy of every body, its middle brought into the cell, whatever its shape. Throws an input error on a
/// cell that has no size, and on a body without sites.
std::vector<BodyShape> lay_out_bodies(const System<2>& system);

/// The same for bodies that have an area. Throws an input error also on a body of two sites, on
/// a ring that is clockwise or has two neighbours in one place, a radius that is negative, a number that is
/// not finite, and for smooth outlines on a ring of unequal radii.
std::vector<BodyShape> body_shapes(const System<2>& system, Outline outline);

/// All copies whose bounds meet `region`.
std::vector<BodyImage> images_in(const Bounds& region, std::span<const BodyShape> bodies, const Box<2>& box);

/// A rectangle round all of them.
Bounds bounds_of(std::span<const BodyShape> bodies);

/// Finds copies by their bounds.
class ImageSearch {
 public:
  /// Every copy that may meet one of `bodies`.
  ImageSearch(std::span<const BodyShape> bodies, const Box<2>& box);

  /// Replaces `found` by the copies whose bounds meet those of `body`, except `body` itself.
  void find(int body, std::vector<BodyImage>& found) const;

 private:
  std::span<const BodyShape> bodies_;
  int row_of(double height) const;

  std::vector<BodyImage> images_;  ///< by their left end
  double widest_ = 0, tallest_ = 0, lowest_ = 0;
  std::vector<std::vector<std::int32_t>>
      rows_;  ///< indices of images by their lower end, as many heights apart
};

}  // namespace supple
