/// Pictures of polygons and discs in their cell.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "supple/draw/scene/polygon_scene.hpp"

namespace supple {

/// A number of each body, shown as its colour. What is not finite is grey.
struct BodyScalar {
  std::string label, unit;                              ///< at the colour bar; unit empty: dimensionless
  std::vector<double> value;                            ///< of each body
  std::optional<std::pair<double, double>> range = {};  ///< of the colours; empty: that of the values
};

/// Sides of the cell that are solid, drawn as bands beside it.
struct Walls {
  bool left = false, right = false, bottom = false, top = false;
};

/// How far a polygon reaches: the discs on its vertices, or everywhere their radius.
enum class Boundary { rough, smooth };

struct PolygonSnapshotOptions {
  std::optional<BodyScalar> color = {};  ///< empty: bodies that touch differ in colour
  std::optional<Walls> walls = {};       ///< empty: every side that is not periodic
  Boundary boundary = Boundary::rough;
  std::string title = {};        ///< empty: time and strain, where they are not 0
  std::string length_unit = {};  ///< of the scale bar, as "m" (SI prefixes are added); empty: dimensionless
  std::string force_unit = {};
  double full_force = 0;       ///< force of the widest line; 0: that of the strongest contacts
  double cell_size = 340;      ///< longer side of the unsheared cell [pt]
  double dots_per_inch = 200;  ///< png and jpg
  double strain_room = 0;      ///< leave room for a cell leaning by this strain: equal pages for a film
  Vec2 room = {};              ///< leave room for a cell of these lengths, and take its scale: likewise
};

/// Draws one instant: bodies as the union of their polygon and the discs on its vertices, with the images
/// that reach into the sheared cell and its faded surroundings; contacts as wide as their force; walls; scale
/// bar; colour bar and legend. The ending of `path` chooses png, jpg, svg, pdf or ps. Throws input and file
/// errors.
void draw_polygon_snapshot(const std::string& path, const PolygonScene& scene,
                           const PolygonSnapshotOptions& options = {});

/// Force of the widest line: the 99th percentile over the contacts; 0 without contacts.
double strongest_force(const PolygonScene& scene);

}  // namespace supple
