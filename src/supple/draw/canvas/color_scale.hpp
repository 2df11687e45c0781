/// Numbers as colours, and the bar that explains them.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "supple/draw/canvas/canvas.hpp"

namespace supple {

/// The colour of a share in [0, 1], from light to dark; other shares are clamped. Dark lines stay visible on
/// all of them, and they can be told apart without colour vision and in print [Paul Tol, SRON/EPS/TN/09-002,
/// 2021: "iridescent" without its darkest end].
Color sequential_color(double share);

/// The numbers at the two ends of the colours.
struct ColorScale {
  double low = 0, high = 1;

  /// The colour of a number; grey where it is not finite.
  Color color(double value) const;
};

/// A scale from the least to the largest of the finite values; a short range around them where all are the
/// same.
ColorScale scale_over(std::span<const double> values);

/// Draws a vertical bar with ticks to its right and its label above; powers of ten and SI prefixes stand in
/// the label. Returns the y below the bar [pt].
double draw_color_bar(Canvas& canvas, Point upper_left, double height, const ColorScale& scale,
                      const std::string& label, const std::string& unit);

}  // namespace supple
