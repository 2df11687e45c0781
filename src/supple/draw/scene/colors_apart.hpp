/// Which colour each body gets where no number chooses it.
#pragma once
#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <vector>

#include "supple/draw/canvas/color.hpp"
#include "supple/draw/scene/scene.hpp"

namespace supple {

/// The colour of each body in scenes of the same bodies. Bodies that crosslinks join share a colour; a disc
/// that could be joined to others but is not is grey. Colours are used evenly. Particles that touch in one of
/// the scenes get different colours while the palette allows it, and as different ones as it allows. Other
/// scenes may give other colours, so pictures that shall agree must take those of the same scenes.
std::vector<Color> colors_apart(std::span<const Scene> scenes);
inline std::vector<Color> colors_apart(const Scene& scene) { return colors_apart(std::span(&scene, 1)); }

/// The place in area_palette of each of these particles, chosen in their order as colors_apart() does;
/// `touching`: which particles shall differ from each, either way.
std::map<std::int32_t, int> palette_apart(std::span<const std::int32_t> particles,
                                          const std::map<std::int32_t, std::set<std::int32_t>>& touching);

}  // namespace supple
