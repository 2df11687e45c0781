/// Triangles and spheres as they lie before the samples of a picture.
#pragma once
#include <array>
#include <vector>

#include "supple/draw/solid/solid_image.hpp"

namespace supple {

/// A triangle on the screen. Lengths are in samples: x to the right, y down, depth to the viewer.
struct ScreenTriangle {
  std::array<Vec3, 3> corner{};
  Vec2 slope{};                           ///< of the depth, along x and y
  double farthest = 0, nearest = 0;       ///< depths
  Vec3 normal{}, normal_x{}, normal_y{};  ///< at corner 0, and how it changes; along right, up, towards
  bool is_seen = false;                   ///< false: the viewer looks along it
  bool is_outside = false;                ///< whether the viewer sees its outside

  double depth(double x, double y) const {
    return corner[0][2] + slope[0] * (x - corner[0][0]) + slope[1] * (y - corner[0][1]);
  }
  /// Towards the viewer's side, of any length.
  Vec3 normal_at(double x, double y) const {
    return normal + (x - corner[0][0]) * normal_x + (y - corner[0][1]) * normal_y;
  }
  /// Distance from the nearest of its sides; of a point in the triangle.
  double from_side(double x, double y) const;
};

struct ScreenSphere {
  Vec3 centre;
  double radius;
};

/// A side of the cell on the screen, at which particles are cut. A sample is within it where beyond(x, y) is
/// 0 or less for a side that the viewer looks along, and where it is in front of (a far side) or behind (a
/// near side) the depth beyond(x, y) for the others.
struct ScreenCut {
  enum class Lies { near, far, along } lies;
  double at_0;
  Vec2 slope;
  double light;  ///< how bright what is cut there is: half as shaded as other surfaces

  double beyond(double x, double y) const { return at_0 + slope[0] * x + slope[1] * y; }
};

/// The scene on the screen. Shapes have numbers: first the triangles, then the spheres, then for each body
/// where it is cut.
class OnScreen {
 public:
  OnScreen(const SolidScene& scene, const SolidWindow& window, int samples, Shading shading);

  int triangles() const { return static_cast<int>(scene_.triangle.size()); }
  int shapes() const { return triangles() + static_cast<int>(sphere_.size()); }
  /// The shapes of each body together.
  const std::vector<std::int32_t>& in_order() const { return order_; }
  bool is_triangle(int shape) const { return shape < triangles(); }
  ScreenTriangle triangle(int shape) const;
  const ScreenSphere& sphere(int shape) const { return sphere_[shape - triangles()]; }
  std::int32_t body(int shape) const { return shape < shapes() ? body_[shape] : shape - shapes(); }
  std::int32_t particle(int shape) const { return scene_.particle[body(shape)]; }
  bool is_cut(int shape) const { return shape >= shapes(); }
  std::int32_t cut_of(std::int32_t body) const { return shapes() + body; }
  /// Empty where particles are whole.
  const std::vector<ScreenCut>& cuts() const { return cuts_; }
  /// What holds the shape [samples].
  Bounds bounds(int shape) const;

 private:
  const SolidScene& scene_;
  Shading shading_;
  std::vector<Vec3> vertex_, normal_;
  std::vector<ScreenSphere> sphere_;
  std::vector<std::int32_t> body_, order_;
  std::vector<ScreenCut> cuts_;
};

}  // namespace supple
