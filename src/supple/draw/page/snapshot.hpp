/// Pictures of the cell.
#pragma once
#include <string>
#include <vector>

#include "supple/draw/canvas/color.hpp"
#include "supple/experiment/recorder.hpp"

namespace supple {

enum class SpinMarks { hidden, shown };

struct SnapshotOptions {
  double cell_size = 340;      ///< longer side of the unsheared cell [pt]
  double dots_per_inch = 200;  ///< png and jpg
  SpinMarks spin = SpinMarks::hidden;
  double strain_room = 0;  ///< leave room for a cell leaning by this strain: equal pages for a film
  double full_force = 0;   ///< force of the widest line [N/m]; 0: that of the strongest contacts of the frame
  std::vector<Color> color = {};  ///< of each disc; empty: by particle, neighbours apart
  std::string title = {};         ///< empty: time and strain
};

/// Draws one frame: discs by crosslinked particle, flattened where they overlap, in the sheared cell with its
/// faded surroundings; contacts by state, as wide as their force; plate discs hatched; scale bar; legend. The
/// ending of `path` chooses png, jpg, svg, pdf or ps. Throws input and file errors.
void draw_snapshot(const std::string& path, const RunInfo& info, const Frame& frame,
                   const SnapshotOptions& options = {});

/// Force of the widest line [N/m]: the 99th percentile over the contacts of a frame; 0 without contacts.
double strongest_force(const RunInfo& info, const Frame& frame);

}  // namespace supple
