/// Maps of a contact potential in a part of a plane, and how far a function jumps, for the pictures of
/// studies.
#pragma once
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "supple/draw/canvas/canvas.hpp"
#include "supple/draw/canvas/color_scale.hpp"
#include "supple/draw/canvas/ticks.hpp"

namespace supple::study {

constexpr int map_cells = 180;  ///< along each side

/// What a map shows: a square of the plane.
struct MapWindow {
  Vec2 middle;
  double half_width;

  /// The middle of a cell; rows go down.
  Vec2 at(int row, int column) const {
    const auto offset = [&](int k) { return half_width * (2 * (k + 0.5) / map_cells - 1); };
    return middle + Vec2{offset(column), -offset(row)};
  }
};

/// value(p) in each cell, row by row from the top.
template <class Value>
std::vector<double> sample_map(const MapWindow& window, const Value& value) {
  std::vector<double> values;
  for (int row = 0; row < map_cells; ++row)
    for (int column = 0; column < map_cells; ++column) values.push_back(value(window.at(row, column)));
  return values;
}

/// The largest change on the way from a to b that does not vanish with its length: the part with the largest
/// change is divided again and again, down to 1e-12.
template <int Dim, class Change>
double jump_between(Vec<Dim> a, Vec<Dim> b, const Change& change) {
  while (norm(b - a) > 1e-12) {
    const Vec<Dim> half = 0.5 * (a + b);
    if (change(a, half) > change(half, b)) b = half;
    else a = half;
  }
  return change(a, b);
}

/// A map on the page.
struct DrawnMap {
  Canvas& canvas;
  MapWindow window;
  Point corner;  ///< on the page, upper left
  double size;

  Point place(const Vec2& p) const {
    return corner + Point{0.5 * size * (1 + (p[0] - window.middle[0]) / window.half_width),
                          0.5 * size * (1 - (p[1] - window.middle[1]) / window.half_width)};
  }

  void draw_values(const std::vector<double>& values, const ColorScale& scale) const {
    const double cell = size / map_cells;
    for (int row = 0; row < map_cells; ++row)
      for (int column = 0; column < map_cells; ++column) {
        const double value = values[static_cast<std::size_t>(row) * map_cells + column];
        if (!(value > 0)) continue;
        const Point low = corner + Point{column * cell, row * cell};
        canvas.rectangle(low, low + Point{1.05 * cell, 1.05 * cell}, {.fill = scale.color(value)});
      }
    draw_contours(values, scale.high);
  }

  /// Coordinates in units of `unit` from `origin` on.
  void draw_frame(const std::string& title, const Vec2& origin, double unit, const char* across,
                  const char* up) const {
    canvas.rectangle(corner, corner + Point{size, size}, {.pen = Pen{}});
    canvas.text(corner + Point{0, -4}, title);
    for (int axis : {0, 1}) {
      const double from = (window.middle[axis] - window.half_width - origin[axis]) / unit;
      const double to = from + 2 * window.half_width / unit;
      const double step = to - from > 4 ? 2 : 0.5;
      for (double tick = step * std::ceil(from / step); tick <= to; tick += step) {
        const double along = size * (tick - from) / (to - from);
        const std::string label = tick_label(tick, step < 1 ? 0.1 : 1);
        if (axis == 0) {
          canvas.line(corner + Point{along, size}, corner + Point{along, size + 3}, {});
          canvas.text(corner + Point{along, size + 5}, label,
                      {.size = 7, .across = Across::centre, .down = Down::top});
        } else {
          canvas.line(corner + Point{0, size - along}, corner + Point{-3, size - along}, {});
          canvas.text(corner + Point{-5, size - along}, label,
                      {.size = 7, .across = Across::right, .down = Down::middle});
        }
      }
    }
    canvas.text(corner + Point{0.5 * size, size + 22}, across, {.across = Across::centre});
    canvas.text(corner + Point{-20, 0.5 * size}, up, {.across = Across::centre, .turn = Turn::left});
  }

 private:
  /// Lines of equal energy, cell by cell [marching squares]: where the gradient is discontinuous they have a
  /// corner.
  void draw_contours(const std::vector<double>& values, double highest) const {
    constexpr int lines = 10;
    const double cell = size / map_cells;
    const auto value = [&](int row, int column) {
      return values[static_cast<std::size_t>(row) * map_cells + column];
    };
    for (int line = 1; line < lines; ++line) {
      const double level = highest * line / lines;
      for (int row = 0; row + 1 < map_cells; ++row)
        for (int column = 0; column + 1 < map_cells; ++column) {
          const int at[4][2] = {{row, column}, {row, column + 1}, {row + 1, column + 1}, {row + 1, column}};
          std::vector<Point> cuts;
          for (int k = 0; k < 4; ++k) {
            const int* a = at[k];
            const int* b = at[(k + 1) % 4];
            const double va = value(a[0], a[1]), vb = value(b[0], b[1]);
            if (!std::isfinite(va) || !std::isfinite(vb) || (va < level) == (vb < level)) continue;
            const double share = (level - va) / (vb - va);
            cuts.push_back(corner + cell * Point{a[1] + 0.5 + share * (b[1] - a[1]),
                                                 a[0] + 0.5 + share * (b[0] - a[0])});
          }
          if (cuts.size() == 2) canvas.line(cuts[0], cuts[1], {.width = 0.5});
        }
    }
  }
};

}  // namespace supple::study
