/// The friction of two particles against the place of the upper one, over pictures of them.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "supple/core/vec.hpp"
#include "supple/observe/body_shapes.hpp"

namespace supple {

/// One particle of a picture.
struct PicturedRing {
  std::vector<Vec2> vertices;
  double radius = 0;           ///< of its vertices
  std::vector<int> held = {};  ///< vertices that springs hold
};
/// The pair at one place: `lower` and `upper`, in any units of length that all pictures share.
struct SlidingPicture {
  double x = 0, friction = 0;  ///< friction: not finite where the two are apart
  PicturedRing lower, upper;
};

/// A way of the upper particle over the lower one; values that are not finite leave a gap.
struct SlidingCurve {
  std::string label;  ///< in the legend; empty: not there
  std::vector<double> x, friction;
};

struct SlidingPlot {
  std::vector<SlidingCurve> curves;
  std::optional<double> bound = {};           ///< of the friction, marked on both sides of 0
  std::vector<SlidingPicture> pictures = {};  ///< numbered from left to right, marked on the curve
  Outline outline = Outline::rough;
  double width = 420, height = 300;  ///< [pt]
};

/// Draws and writes the plot; the ending of `path` chooses png, jpg, svg, pdf or ps. Throws input and file
/// errors.
void draw_sliding_plot(const std::string& path, const SlidingPlot& plot);

}  // namespace supple
