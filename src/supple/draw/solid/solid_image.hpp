/// Particles in 3D as pixels, without a display.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "supple/draw/canvas/pixel_rows.hpp"
#include "supple/draw/solid/solid_scene.hpp"
#include "supple/draw/solid/view.hpp"

namespace supple {

/// The part of the plane of a picture that its pixels cover.
struct SolidWindow {
  ViewAxes axes = axes_of({});
  double left = 0, top = 0;      ///< of the upper left corner, along axes.right and axes.up [length]
  double pixels_per_length = 1;  ///< [1/length]
  int width = 0, height = 0;     ///< [pixel]
};

/// How triangles take the light: each as the plane that it is, or as if the surface were round, by normals
/// that change from corner to corner. Where a triangle and its neighbours make a sharp angle it stays flat.
enum class Shading { flat, smooth };

/// What is drawn on particles. Widths are in pixels; 0: none.
struct SolidStyle {
  Shading shading = Shading::smooth;
  double edge_width = 0;     ///< of lines on the edges of triangles
  double outline_width = 1;  ///< of lines round what shows of each particle
};

/// Opaque pixels 0x00RRGGBB in rows.
struct SolidImage {
  std::vector<std::uint32_t> pixel;
  std::vector<std::uint8_t> covered;  ///< of the 16 points of each pixel, those at which a particle shows
  int width = 0, height = 0;

  PixelRows rows() const {
    const auto w = static_cast<std::size_t>(width);
    return {pixel.data(), w, static_cast<std::size_t>(height), w};
  }
};

/// Draws the scene, with a colour for each particle, on white. Of all that lies behind a point of the picture
/// the nearest shows, at 16 points of each pixel: exact for spheres and for triangles, which may go through
/// each other. Triangles are seen from both sides. The light comes from the viewer's upper left and a share
/// of it from everywhere. Bits do not depend on the number of threads. Input error for a window without
/// pixels or with more than 2^28 of them.
SolidImage draw_solid(const SolidScene& scene, std::span<const Color> color, const SolidWindow& window,
                      const SolidStyle& style);

}  // namespace supple
