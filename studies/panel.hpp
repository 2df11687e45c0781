/// Particles of a frame in a part of a page, for the pictures of studies.
#pragma once
#include <string>
#include <vector>

#include "supple/draw/canvas/canvas.hpp"
#include "supple/draw/scene/colors_apart.hpp"
#include "supple/draw/scene/frame_scene.hpp"
#include "supple/draw/scene/polygon_outline.hpp"
#include "supple/experiment/recorder.hpp"
#include "supple/observe/body_shapes.hpp"

namespace supple::study {

struct Panel {
  Canvas& canvas;
  const RunInfo<2>& info;
  const Frame<2>& frame;
  Outline outline;
  Point corner;  ///< of the box on the page, lower left
  double scale;  ///< points per length

  Point on_page(const Vec2& x) const { return corner + scale * Point{x[0], -x[1]}; }
  double width() const { return scale * frame.length[0]; }
  double height() const { return scale * frame.length[1]; }

  /// Fills first, then outlines, so that overlaps show.
  void draw_particles() const {
    const std::vector<Color> color = colors_apart(scene_of(info, frame));
    for (std::size_t b = 0; b < color.size(); ++b) fill(b, color[b]);
    for (std::size_t b = 0; b < color.size(); ++b) draw_outline(b);
  }

  enum class Side { left, right, bottom, top };
  /// A wall along a side of the box, from one corner to the other.
  void draw_wall(Side side, double thickness = 5) const {
    const Point a = corner, b = corner + Point{width(), -height()};
    const Color wall = hex(0x999999);
    if (side == Side::left) canvas.rectangle({a[0] - thickness, b[1]}, {a[0], a[1] + thickness}, {wall, {}});
    if (side == Side::right) canvas.rectangle({b[0], b[1]}, {b[0] + thickness, a[1] + thickness}, {wall, {}});
    if (side == Side::bottom) canvas.rectangle({a[0], a[1]}, {b[0], a[1] + thickness}, {wall, {}});
    if (side == Side::top)
      canvas.rectangle({a[0] - thickness, b[1] - thickness}, {b[0] + thickness, b[1]}, {wall, {}});
  }

 private:
  static constexpr double line = 0.35;

  std::vector<Point> ring(std::size_t b) const {
    std::vector<Point> out;
    for (auto i = info.body_begin[b]; i < info.body_begin[b + 1]; ++i)
      out.push_back(on_page(frame.position[i]));
    return out;
  }
  double radius(std::size_t b) const { return scale * info.radius[info.body_begin[b]]; }

  void fill(std::size_t b, Color color) const {
    const std::vector<Point> at = ring(b);
    const bool smooth = outline == Outline::smooth && at.size() > 1;
    if (smooth)
      canvas.polygon(
          at, {{}, Pen{ink, 2 * radius(b) + 2 * line}});  // all within sigma/2 of the polygon, and a rim
    if (at.size() > 1)
      canvas.polygon(at, {color, smooth ? std::optional(Pen{color, 2 * radius(b)}) : std::nullopt});
    if (!smooth)
      for (const Point& x : at) canvas.circle(x, radius(b), {color, {}});
  }
  void draw_outline(std::size_t b) const {
    const std::vector<Point> at = ring(b);
    if (outline == Outline::smooth && at.size() > 1) return;
    const std::vector<double> radii(at.size(), radius(b));
    for (const std::vector<Vec2>& piece : body_outline(at, radii, 0.5)) canvas.polyline(piece, {ink, line});
  }
};

}  // namespace supple::study
