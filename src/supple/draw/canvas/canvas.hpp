/// One drawing surface for every picture format.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "supple/core/vec.hpp"
#include "supple/draw/canvas/color.hpp"
#include "supple/draw/canvas/pixel_rows.hpp"

namespace supple {

enum class PictureFormat { png, jpg, svg, pdf, ps };

/// The format that the ending of `path` names; png for standard output. Throws an input error that lists the
/// valid endings.
PictureFormat picture_format(const std::string& path);

/// A place on the page in points (1/72 inch) from its upper left corner, y downward.
using Point = Vec2;

/// How a line is drawn.
struct Pen {
  Color color = ink;
  double width = 0.75;            ///< [pt]
  std::vector<double> dash = {};  ///< lengths of dashes and gaps [pt]; empty: solid
};

/// How a shape is painted: filled, stroked, or both.
struct Paint {
  std::optional<Color> fill = {};
  std::optional<Pen> pen = {};
};

enum class Across { left, centre, right };
enum class Down { top, middle, baseline, bottom };
enum class Weight { normal, bold };
enum class Turn { none, left };  ///< left: read from bottom to top

struct TextStyle {
  double size = 8;  ///< [pt]
  Color color = ink;
  Across across = Across::left;
  Down down = Down::baseline;
  Weight weight = Weight::normal;
  Turn turn = Turn::none;
};

enum class ClipTo { inside, outside };

/// A white page. Nothing is on disk before finish().
class Canvas {
 public:
  /// width and height are in points; dots_per_inch matters for png and jpg only. Throws as picture_format()
  /// does.
  Canvas(const std::string& path, double width, double height, double dots_per_inch = 300);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  double width() const { return width_; }
  double height() const { return height_; }

  void line(Point from, Point to, const Pen& pen);
  /// Draws an open line; a point that is not finite leaves a gap.
  void polyline(std::span<const Point> points, const Pen& pen);
  void polygon(std::span<const Point> points, const Paint& paint);
  void rectangle(Point low, Point high, const Paint& paint);
  void circle(Point centre, double radius, const Paint& paint);
  void text(Point at, const std::string& text, const TextStyle& style = {});
  /// Width of a line of text [pt].
  double text_width(const std::string& text, const TextStyle& style = {}) const;

  /// Puts these pixels on the page, that many to an inch, without change: in png and jpg the upper left
  /// corner is moved to the nearest pixel, which makes them pixels of the picture where it has as many to an
  /// inch.
  void image(Point upper_left, const PixelRows& pixels, double dots_per_inch);

  /// Runs `draw`; only what it draws inside (or outside) the polygon shows.
  void clipped(std::span<const Point> polygon, ClipTo side, const std::function<void()>& draw);

  /// Writes the file, completely or not at all. Throws file errors.
  void finish();

 private:
  struct Surface;
  void paint_path(const Paint& paint);
  void stroke_path(const Pen& pen);

  std::string path_;
  double width_, height_;
  std::unique_ptr<Surface> surface_;
};

}  // namespace supple
