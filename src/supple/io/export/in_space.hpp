/// What formats of three dimensions hold of a scene in the plane, which lies in z = 0, or in space.
#pragma once
#include <array>
#include <vector>

#include "supple/draw/scene/body_scene.hpp"

namespace supple {

inline Vec3 in_space(const Vec2& x) { return {x[0], x[1], 0}; }
inline Vec3 in_space(const Vec3& x) { return x; }

/// The leaning cell that pictures draw (drawn_cell.hpp). In the plane, the third edge is as long as the
/// thickest site, or 1, not periodic, and z = 0 is half-way up.
struct SpaceCell {
  std::array<Vec3, 3> edge;  ///< [length]
  Vec3 origin;               ///< the corner where the edges begin [length]
  std::array<bool, 3> periodic;
};
template <int Dim>
SpaceCell space_cell(const BodyScene<Dim>& scene);

}  // namespace supple
