/// What is wrong with closed surfaces: each alone, and two of them together.
#pragma once
#include <vector>

#include "supple/geometry/bands.hpp"
#include "supple/observe/body_images.hpp"
#include "supple/observe/soundness_tally.hpp"

namespace supple {

class SurfaceLook {
 public:
  /// At this many bodies, and at these shapes for those that are to be looked at together.
  SurfaceLook(std::size_t bodies, const std::vector<BodySurface>& shapes, Outline outline);

  /// Body b alone. `narrowest` is the diameter of the smallest vertex of all.
  void alone(int b, const BodySurface& shape, double narrowest);
  /// Body a, and the copy of another one, or of itself.
  void together(int a, const ImageOf<3>& image);
  Soundness result() { return tally_.result(); }

 private:
  /// A displaced surface, and the heights of its vertices along a direction.
  struct Side {
    const BodySurface* shape;
    Vec3 shift;
    std::vector<double> height;
  };
  /// Where two surfaces may meet: a box, and what lies between two heights.
  struct Common {
    BoundsOf<3> box;
    Interval heights;
  };
  /// A triangle of a surface, displaced, with its bounds.
  struct Triangle {
    Vec3 corner[3];
    BoundsOf<3> bounds;
  };

  void look_at_holes(int b, const BodySurface& shape, double narrowest);
  static void measure_heights(const Vec3& direction, Side& side);
  static bool has_site_inside(const Side& one, const Side& other, const Common& common);
  static void triangles_in(const Side& side, const Common& common, std::vector<Triangle>& triangles);
  bool boundaries_cross(const Common& common);

  const std::vector<BodySurface>& shapes_;
  Outline outline_;
  std::vector<BoundsOf<3>> surfaces_;  ///< without the spheres at vertices
  std::vector<Vec3> middle_;           ///< of the vertices
  Side sides_[2];
  std::vector<Triangle> first_, second_;
  SoundnessTally tally_;
};

}  // namespace supple
