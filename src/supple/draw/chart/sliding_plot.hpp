/// The friction of two particles against the place of the upper one, over pictures of them.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "supple/core/vec.hpp"
#include "supple/model/frame.hpp"
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

/// Pictures under the curve, numbered from left to right; all of them have the same scale.
struct SlidingRow {
  std::vector<SlidingPicture> pictures;
  Outline outline = Outline::rough;
  std::string label = {};  ///< above the pictures; empty: none
};

struct SlidingPlot {
  std::vector<SlidingCurve> curves;
  std::vector<double> bounds = {};    ///< of the friction (9.13), marked on both sides of 0
  std::vector<SlidingRow> rows = {};  ///< the places of their pictures are marked, too
  std::optional<Vec2> star = {};      ///< a place that is marked: x and friction
  double width = 420, height = 300;   ///< [pt]
};

/// The pair of a frame of the experiment `friction`.
SlidingPicture sliding_picture(const RunInfo<2>& info, const Frame<2>& frame);

/// Seven of these, evenly spaced over the places where the two touch and a little beyond; none where they
/// never do.
std::vector<SlidingPicture> seven_of(const std::vector<SlidingPicture>& all);

/// Draws and writes the plot; the ending of `path` chooses png, jpg, svg, pdf or ps. Throws input and file
/// errors.
void draw_sliding_plot(const std::string& path, const SlidingPlot& plot);

}  // namespace supple
