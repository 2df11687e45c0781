/// What is wrong with polygons: each alone, and two of them together.
#pragma once
#include <vector>

#include "supple/observe/body_images.hpp"
#include "supple/observe/soundness_tally.hpp"

namespace supple {

class PolygonLook {
 public:
  /// At this many bodies, and at these shapes for those that are to be looked at together.
  PolygonLook(std::size_t bodies, const std::vector<BodyShape>& shapes, Outline outline);

  /// Body b alone. `narrowest` is the diameter of the smallest vertex of all.
  void alone(int b, const BodyShape& shape, double narrowest);
  /// Body a, and the copy of another one, or of itself.
  void together(int a, const BodyImage& image);
  Soundness result() { return tally_.result(); }

 private:
  /// An edge of a ring, displaced, with its bounds.
  struct Edge {
    Vec2 from, to;
    Bounds bounds;
  };

  static void edges_in(const BodyShape& shape, const Vec2& shift, const Bounds& region,
                       std::vector<Edge>& edges);
  bool boundaries_cross(const BodyShape& first, const BodyShape& second, const Vec2& shift,
                        const Bounds& region);

  const std::vector<BodyShape>& shapes_;
  Outline outline_;
  std::vector<Bounds> rings_;  ///< without the discs at vertices
  std::vector<Edge> first_, second_;
  SoundnessTally tally_;
};

}  // namespace supple
