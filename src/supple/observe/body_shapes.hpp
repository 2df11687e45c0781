/// The bodies of a periodic cell laid out in the plane, with the images of others that they may meet.
#pragma once
#include <span>
#include <vector>

#include "supple/geometry/curve.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// What a body covers. Rough: the polygon and a disc at every site, of the site's radius. Smooth: everything
/// within that radius of the polygon. A body of one site is a disc either way.
enum class Outline { rough, smooth };

/// A body near the cell: a disc (one site) or a polygon, counter-clockwise.
struct BodyShape {
  std::vector<Vec2> ring;
  std::vector<double> radius;  ///< of the disc at each vertex; smooth: reach beyond the polygon
  Bounds bounds;               ///< of all that the body covers

  bool is_disc() const { return ring.size() == 1; }
  int size() const { return static_cast<int>(ring.size()); }
  int next(int i) const { return i + 1 < size() ? i + 1 : 0; }
  int previous(int i) const { return i > 0 ? i - 1 : size() - 1; }
  double distance_to_edge(int k, const Vec2& x) const;
  /// Exterior angle at vertex i [radian], positive where the ring turns left.
  double turn_at(int i) const;
};

/// The copy of a body displaced by `shift`.
struct BodyImage {
  int body;
  Vec2 shift;
  Bounds bounds;
};

/// One copy of every body of any shape, the middle of its bounds brought into the cell. Throws an input error
/// on a cell without size and on a body without sites.
std::vector<BodyShape> lay_out_bodies(const System<2>& system);

/// The same for bodies that must have an area. Throws an input error also on a body of two sites, a ring that
/// is clockwise or has two neighbours in one place, a negative radius, a number that is not finite, and for
/// smooth outlines a ring of unequal radii.
std::vector<BodyShape> body_shapes(const System<2>& system, Outline outline);

/// All periodic copies of bodies whose bounds meet `region`.
std::vector<BodyImage> images_in(const Bounds& region, std::span<const BodyShape> bodies, const Box<2>& box);

/// A rectangle that holds all of them.
Bounds bounds_of(std::span<const BodyShape> bodies);

/// Finds the copies of bodies that may meet a given body, by their bounds.
class ImageSearch {
 public:
  /// Every copy that may meet one of `bodies`.
  ImageSearch(std::span<const BodyShape> bodies, const Box<2>& box);

  /// Replaces `found` by the copies whose bounds meet those of `body`, except `body` itself.
  void find(int body, std::vector<BodyImage>& found) const;

 private:
  std::span<const BodyShape> bodies_;
  int row_of(double height) const;

  std::vector<BodyImage> images_;  ///< in the order of their left ends
  double widest_ = 0, tallest_ = 0, lowest_ = 0;
  std::vector<std::vector<std::int32_t>>
      rows_;  ///< indices of images, in rows of equal height by their lower ends
};

}  // namespace supple
