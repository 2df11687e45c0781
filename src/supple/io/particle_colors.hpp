/// Which colour each crosslinked particle gets.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "supple/experiment/recorder.hpp"
#include "supple/io/cell_scene.hpp"
#include "supple/io/color.hpp"

namespace supple {

/// Colour of each disc. Particles of one disc are grey; particles that touch differ while the palette allows it, and
/// colours are used evenly. The same for every frame in which the same particles touch.
std::vector<Color> disc_colors(std::span<const std::int32_t> particle, const CellScene& scene);

}  // namespace supple
