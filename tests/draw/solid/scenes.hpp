/// Small scenes in 3D and what their pictures hold.
#pragma once
#include <vector>

#include "supple/build/surfaces.hpp"
#include "supple/draw/solid/solid_image.hpp"

namespace supple::testing {

/// A cubic cell of side 10 with nothing in it.
inline SolidScene empty_cell() {
  SolidScene scene;
  scene.box.length = {10, 10, 10};
  return scene;
}
/// Adds a particle of one body.
inline std::int32_t add_particle(SolidScene& scene) {
  scene.particle.push_back(scene.particles);
  return scene.particles++;
}
inline void add_ball(SolidScene& scene, const Vec3& centre, double radius) {
  scene.sphere.push_back({centre, radius, add_particle(scene)});
}
inline void add_mesh(SolidScene& scene, const TriangleMesh& mesh, const Vec3& shift = {}) {
  const std::int32_t body = add_particle(scene), first = static_cast<std::int32_t>(scene.vertex.size());
  for (const Vec3& x : mesh.vertex) scene.vertex.push_back(x + shift);
  for (const auto& f : mesh.face)
    scene.triangle.push_back({{first + f[0], first + f[1], first + f[2]}, body});
}

/// A window of `pixels` by `pixels` on the cell of side 10, its middle in the middle, 12 lengths wide.
inline SolidWindow window_on(const SolidScene& scene, const View& view, int pixels) {
  SolidWindow window;
  window.axes = axes_of(view);
  const Vec3 middle = window.axes.of(scene.box.centre());
  window.left = middle[0] - 6;
  window.top = middle[1] + 6;
  window.pixels_per_length = pixels / 12.0;
  window.width = window.height = pixels;
  return window;
}

/// The pixel in which a place lies.
inline std::uint32_t pixel_at(const SolidImage& image, const SolidWindow& window, const Vec3& x) {
  const Vec3 at = window.axes.of(x);
  const int i = static_cast<int>((at[0] - window.left) * window.pixels_per_length);
  const int j = static_cast<int>((window.top - at[1]) * window.pixels_per_length);
  return image.pixel[static_cast<std::size_t>(j) * image.width + i];
}

/// Sum of the channels: brightness of one colour.
inline int level(std::uint32_t pixel) {
  return static_cast<int>((pixel >> 16 & 255) + (pixel >> 8 & 255) + (pixel & 255));
}
/// Pixels that particles cover, parts counted as such.
inline double covered_pixels(const SolidImage& image) {
  double sum = 0;
  for (const std::uint8_t c : image.covered) sum += c / 16.0;
  return sum;
}

inline constexpr Color red{1, 0, 0}, green{0, 1, 0}, blue{0, 0, 1};
inline bool is_red(std::uint32_t p) {
  return (p >> 16 & 255) > (p >> 8 & 255) && (p >> 16 & 255) > (p & 255);
}
inline bool is_green(std::uint32_t p) {
  return (p >> 8 & 255) > (p >> 16 & 255) && (p >> 8 & 255) > (p & 255);
}
inline bool is_blue(std::uint32_t p) { return (p & 255) > (p >> 16 & 255) && (p & 255) > (p >> 8 & 255); }

}  // namespace supple::testing
