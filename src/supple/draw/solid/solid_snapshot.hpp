/// Pictures of particles in 3D.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "supple/draw/page/snapshot.hpp"
#include "supple/draw/solid/solid_image.hpp"
#include "supple/draw/solid/solid_scene.hpp"
#include "supple/draw/solid/view.hpp"

namespace supple {

/// Lines on the edges of triangles.
enum class TriangleEdges { hidden, drawn };
/// The edges of the cell.
enum class CellFrame { hidden, drawn };

/// As SnapshotOptions, for particles in 3D.
struct SolidSnapshotOptions {
  std::optional<BodyScalar> scalar = {};  ///< of each particle; chooses the colours where it is given
  std::vector<Color> color = {};          ///< of each particle; empty: neighbours apart
  std::string title = {};                 ///< empty: time and strain, where time passes
  View view = {};
  Shading shading = Shading::smooth;
  TriangleEdges edges = TriangleEdges::hidden;
  CellFrame cell = CellFrame::drawn;
  double cell_size = 340;      ///< longest side of the unsheared cell, seen from its front [pt]
  double dots_per_inch = 200;  ///< png and jpg
  double image_dots_per_inch =
      300;  ///< of the particles in svg, pdf and ps; all else there is lines and text
  /// Leaves room for this (extent_of), too, and takes `scale_length` for the longest side of the cell: equal
  /// pages for a film.
  std::optional<Bounds> room = {};
  double scale_length = 0;  ///< [length]; 0: that of the scene
};

/// What cell and particles cover in the picture, along right and up from the middle of the cell [length].
Bounds extent_of(const SolidScene& scene, const View& view);

/// Draws one instant: particles in the light from the viewer's upper left, each with an outline, hidden
/// behind others as they are; the edges of the sheared cell where no particle hides them; the directions;
/// scale bar; legend. The ending of `path` chooses png, jpg, svg, pdf or ps; in the last three particles are
/// an image among lines and text. Throws input and file errors.
void draw_solid_snapshot(const std::string& path, const SolidScene& scene,
                         const SolidSnapshotOptions& options = {});

}  // namespace supple
