/// Pictures of the cell.
#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "supple/draw/canvas/color.hpp"
#include "supple/draw/canvas/color_scale.hpp"
#include "supple/draw/scene/scene.hpp"

namespace supple {

/// A number of each body, shown as its colour. Numbers that are not finite are grey.
struct BodyScalar {
  std::string label, unit;                              ///< at the colour bar; unit empty: dimensionless
  std::vector<double> value;                            ///< of each body
  std::optional<std::pair<double, double>> range = {};  ///< of the colours; empty: that of the values
};

/// The numbers at the ends of its colours.
ColorScale scale_of(const BodyScalar& scalar);

/// Throws an input error ("cannot draw 'PATH'") where there are not as many numbers, or colours, as bodies,
/// or the range of colours is empty.
void check_colors(const std::string& path, std::size_t bodies, const std::optional<BodyScalar>& scalar,
                  const std::vector<Color>& color);

struct SnapshotOptions {
  std::optional<BodyScalar> scalar = {};  ///< chooses the colours where it is given
  std::vector<Color> color = {};          ///< of each body; empty: neighbours apart
  std::string title = {};                 ///< empty: time and strain, where time passes
  double full_force = 0;                  ///< of the widest line [as strongest_force]; 0: that of the scene
  double cell_size = 340;                 ///< longer side of the unsheared cell [pt]
  double dots_per_inch = 200;             ///< png and jpg
  double strain_room = 0;  ///< leave room for a cell leaning by this strain: equal pages for a film
  Vec2 room = {};          ///< leave room for a cell of these lengths, and take its scale: likewise
  std::vector<std::int32_t> marked = {};  ///< sites with a red disc
};

inline constexpr Color mark_color = hex(0xCC3311);

/// Draws one instant: discs, flattened where they overlap, and polygons, with the discs on their vertices or
/// a smooth boundary, in the sheared cell with its faded surroundings; contacts coloured by state and as wide
/// as their force; hatches on bodies that are held; marked sites; walls and plates; scale bar; legend. The
/// ending of `path` chooses png, jpg, svg, pdf or ps. Throws input and file errors.
void draw_snapshot(const std::string& path, const Scene& scene, const SnapshotOptions& options = {});

}  // namespace supple
