/// Which colour each body gets where no number chooses it.
#pragma once
#include <span>
#include <vector>

#include "supple/draw/canvas/color.hpp"
#include "supple/draw/scene/scene.hpp"

namespace supple {

/// Colour of each body of scenes that hold the same bodies. Bodies that crosslinks join share a colour; a
/// disc that could be joined to others and is not is grey. Colours are used evenly; those that touch in one
/// of the scenes differ while the palette allows it, and by as much as it allows. Other scenes may give other
/// colours: pictures of one run that shall agree take those of the same scenes.
std::vector<Color> colors_apart(std::span<const Scene> scenes);
inline std::vector<Color> colors_apart(const Scene& scene) { return colors_apart(std::span(&scene, 1)); }

}  // namespace supple
