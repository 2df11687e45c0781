/// The page of every picture of a cell: title, sheared cell with its faded surroundings, scale bar, legend.
#pragma once
#include <array>
#include <functional>
#include <string>
#include <vector>

#include "supple/draw/canvas/canvas.hpp"
#include "supple/draw/canvas/ticks.hpp"
#include "supple/draw/scene/drawn_cell.hpp"
#include "supple/model/units.hpp"

namespace supple {

/// A number with its unit and an SI prefix; in runs whose units have no names, the number alone.
std::string shown(const Units& units, double in_si, const char* unit, Digits digits = Digits::fewest);

/// Time, where it passes, and strain; `drawn`: the strain that the cell has in the picture (drawn_strain).
std::string instant_title(const Units& units, double time, double strain, double drawn, bool flows);

/// Draws a bar of a round length, at most `longest` [length], and this length right of it. `at`: its upper
/// left corner; `scale`: points for a length of 1.
void draw_scale_bar(Canvas& canvas, Point at, double scale, double longest, const Units& units);

/// What every page has around its picture [pt].
struct PageMargins {
  static constexpr double edge = 10, title_height = 20, foot_height = 26, legend_width = 112;
};

class CellPage : public PageMargins {
 public:
  /// cell_size: longer side of the unsheared cell [pt]. strain_room: leaves room for the cell at this strain.
  /// room: leaves room for a cell of these lengths, whose longer side then is cell_size.
  CellPage(const std::string& path, const Box<2>& box, double cell_size, double strain_room,
           double dots_per_inch, const Vec2& room = {});

  Canvas& canvas() { return canvas_; }
  double scale() const { return scale_; }  ///< points for a length of 1
  double rim() const { return rim_; }      ///< width of the surroundings [pt]
  const std::array<Point, 4>& corner() const { return corner_; }
  double top() const { return title_height + rim_; }  ///< of the cell [pt]
  double legend_left() const { return canvas_.width() - legend_width + 2; }

  Point on_page(const Vec2& x) const;

  /// Calls draw(whiteness, skipped) for the faded surroundings and for the cell itself, each clipped to where
  /// it shows. `whiteness` is the share of white in colours; what lies as `skipped` says need not be drawn.
  /// Along a direction that is not periodic everything shows, wherever it lies.
  void draw_matter(const std::function<void(double whiteness, Lies skipped)>& draw);

  void draw_title(const std::string& title);
  /// Draws a scale bar, about a quarter of the largest cell that the page has room for, so that it is the
  /// same on all pages of a film.
  void draw_scale_bar(const Units& units);

 private:
  std::array<Point, 4> moved_out(double along, double across) const;

  Box<2> box_;
  Vec2 room_;                  // lengths of the largest cell that the page holds
  double scale_, rim_, lean_;  // [pt per length], [pt], [pt]
  std::array<Vec2, 4> cell_;
  Canvas canvas_;
  std::array<Point, 4> corner_;
};

}  // namespace supple
