/// Which parts of a line particles hide.
#pragma once
#include <utility>
#include <vector>

#include "supple/draw/solid/solid_image.hpp"
#include "supple/draw/solid/solid_scene.hpp"
#include "supple/draw/solid/view.hpp"

namespace supple {

/// The parts of the line from a to b [length] that no triangle or sphere lies in front of, in order, as
/// shares in [0, 1] of the line. Computed, not sampled: the line is cut where it leaves the shadow of a
/// shape.
std::vector<std::pair<double, double>> visible_parts(const SolidScene& scene, const ViewAxes& axes,
                                                     const Vec3& a, const Vec3& b);

/// The parts of a line between two points of an image [pixel] where more than half of its pixels is white, to
/// half a pixel. Parts shorter than two pixels are left out: the ends of lines at the rim of what is covered.
std::vector<std::pair<double, double>> uncovered_parts(const SolidImage& image, const Vec2& a, const Vec2& b);

}  // namespace supple
