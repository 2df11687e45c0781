/// The periodic copies of bodies, and which of them a body may meet.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "supple/model/box.hpp"
#include "supple/observe/body_shapes.hpp"

namespace supple {

/// The copy of a body displaced by `shift`.
template <int Dim>
struct ImageOf {
  int body;
  Vec<Dim> shift;
  BoundsOf<Dim> bounds;
};
using BodyImage = ImageOf<2>;

/// All periodic copies of bodies whose bounds meet `region`. Throws an input error where there would be
/// thousands of each body.
template <int Dim>
std::vector<ImageOf<Dim>> images_in(const BoundsOf<Dim>& region, std::span<const ShapeOf<Dim>> bodies,
                                    const Box<Dim>& box);

/// What holds all of them.
Bounds bounds_of(std::span<const BodyShape> bodies);
BoundsOf<3> bounds_of(std::span<const BodySurface> bodies);

/// The cell; in a direction without periods, as far as bodies reach there, images included.
template <int Dim>
BoundsOf<Dim> region_of(std::span<const ShapeOf<Dim>> bodies, const Box<Dim>& box);

/// Finds the copies of bodies that may meet a given body, by their bounds.
template <int Dim>
class ImageSearch {
 public:
  /// Every copy that may meet one of `bodies`, which must outlive this.
  ImageSearch(std::span<const ShapeOf<Dim>> bodies, const Box<Dim>& box);

  /// Replaces `found` by the copies whose bounds meet those of `body`, except `body` itself.
  void find(int body, std::vector<ImageOf<Dim>>& found) const;

 private:
  std::span<const ShapeOf<Dim>> bodies_;
  int row_of(double height) const;

  std::vector<ImageOf<Dim>> images_;  ///< in the order of their left ends
  double widest_ = 0, tallest_ = 0, lowest_ = 0;
  std::vector<std::vector<std::int32_t>>
      rows_;  ///< indices of images, in rows of equal height by their lower ends
};

}  // namespace supple
