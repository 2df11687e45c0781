/// The page of every picture of a cell: title, sheared cell with its faded surroundings, scale bar, legend.
#pragma once
#include <array>
#include <functional>
#include <string>
#include <vector>

#include "supple/draw/canvas/canvas.hpp"
#include "supple/draw/scene/drawn_cell.hpp"

namespace supple {

/// What becomes of matter beyond a side that is not periodic, where another direction is.
enum class Beyond { hidden, shown };

class CellPage {
 public:
  static constexpr double edge = 10, title_height = 20, foot_height = 26, legend_width = 112;  ///< [pt]
  static constexpr double legend_row = 15, legend_sample = 24;                                 ///< [pt]

  /// cell_size: longer side of the unsheared cell [pt]; strain_room: strain of a leaning cell that finds
  /// room; room: lengths of a cell that does, and whose longer side then is cell_size.
  CellPage(const std::string& path, const Box<2>& box, double cell_size, double strain_room,
           double dots_per_inch, const Vec2& room = {});

  Canvas& canvas() { return canvas_; }
  const Box<2>& box() const { return box_; }
  bool periodic() const { return box_.periodic[0] || box_.periodic[1]; }
  double scale() const { return scale_; }  ///< points for a length of 1
  double rim() const { return rim_; }      ///< width of the surroundings [pt]
  const std::array<Point, 4>& corner() const { return corner_; }
  double top() const { return title_height + rim_; }  ///< of the cell [pt]
  double legend_left() const { return canvas_.width() - legend_width + 2; }

  Point on_page(const Vec2& x) const;
  std::vector<Point> on_page(const std::vector<Vec2>& points) const;

  /// Calls draw(share of white, what need not be drawn) for the faded surroundings and for the cell itself,
  /// each clipped to where it shows. Without a periodic direction everything shows, wherever it lies.
  void draw_matter(const std::function<void(double whiteness, Lies skipped)>& draw,
                   Beyond beyond = Beyond::hidden);

  void draw_title(const std::string& title);
  /// length: in the units of the box.
  void draw_scale_bar(double length, const std::string& label);

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
