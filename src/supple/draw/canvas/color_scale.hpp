/// Numbers as colours, and the bar that explains them.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "supple/draw/canvas/canvas.hpp"

namespace supple {

/// A share in [0, 1] as a colour, light to dark, on which dark lines stay visible; shares beyond are clamped.
/// It can be read without colour vision and in print [Paul Tol, SRON/EPS/TN/09-002, 2021: "iridescent"
/// without its darkest end].
Color sequential_color(double share);

/// From which number to which the colours go.
struct ColorScale {
  double low = 0, high = 1;

  /// Grey for a number that is not finite.
  Color color(double value) const;
};

/// From the least to the largest of the finite values; a little around them where they are all the same.
ColorScale scale_over(std::span<const double> values);

/// A vertical bar with its ticks to the right and its label above; powers of ten and SI prefixes stand in the
/// label. Returns the y below it.
double draw_color_bar(Canvas& canvas, Point upper_left, double height, const ColorScale& scale,
                      const std::string& label, const std::string& unit);

}  // namespace supple
