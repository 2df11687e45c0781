/// What a picture of the cell shows, and where, before anything is drawn. Lengths in the run's units, y
/// upward.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "supple/draw/scene/drawn_cell.hpp"
#include "supple/experiment/recorder.hpp"

namespace supple {

/// A disc or a periodic image of one. Overlapping discs are flattened where they meet: the outline is the
/// disc cut by the radical lines with its neighbours (its cell in the power diagram), so the discs tile what
/// they cover.
struct SceneDisc {
  std::int32_t site;
  Vec2 centre;
  std::vector<Vec2> outline;  ///< anticlockwise
  std::vector<std::int32_t>
      across;  ///< site beyond the edge that starts at each point of the outline; -1: none
  Lies lies = Lies::across;
};

/// A contact, from centre to centre of the images that touch.
struct SceneLine {
  Vec2 from, to;
  std::size_t contact;  ///< index into Frame::contacts
  Lies lies;
};

struct CellScene {
  std::array<Vec2, 4> corner;    ///< of the sheared cell, anticlockwise from the lower left
  std::vector<SceneDisc> discs;  ///< disc i of the cell at index i, then the images
  std::vector<SceneLine> lines;
};

/// The cell (box.strain is the strain) leaning about mid-height, with the images of discs and contacts that
/// show within `margin` of it. Arrays of the frame must have as many sites as `radius`.
CellScene lay_out_cell(const Box<2>& box, std::span<const double> radius, const Frame& frame, double margin);

}  // namespace supple
