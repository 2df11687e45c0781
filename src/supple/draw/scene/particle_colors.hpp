/// Which colour each crosslinked particle gets.
#pragma once
#include <cstdint>
#include <set>
#include <span>
#include <vector>

#include "supple/draw/canvas/color.hpp"
#include "supple/draw/scene/cell_scene.hpp"
#include "supple/experiment/recorder.hpp"

namespace supple {

/// Colour of each disc. Particles of one disc are grey; colours are used evenly; particles that touch differ
/// while the palette allows it, and by as much as it allows. Another frame, in which others touch, may give
/// other colours.
std::vector<Color> disc_colors(std::span<const std::int32_t> particle, const CellScene& scene);
/// The same for a frame: pictures of one run that shall agree take the colours of one frame.
std::vector<Color> disc_colors(const RunInfo& info, const Frame& frame);

/// Colours of area_palette for things of which some touch: used evenly, and neighbours differ while the
/// palette allows it, by as much as it allows. Things that are not `wanted` stay grey.
std::vector<Color> neighbour_colors(const std::vector<std::set<std::int32_t>>& touching,
                                    const std::vector<bool>& wanted);

}  // namespace supple
