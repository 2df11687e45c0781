/// Normals of triangulated particles.
#pragma once
#include <vector>

#include "supple/draw/solid/solid_scene.hpp"

namespace supple {

/// The outward unit normal of each vertex: the mean of those of its triangles, weighted by their angles
/// there, so that it does not depend on how a plane is cut into triangles [Thuermer & Wuethrich 1998]; (0, 0,
/// 0) of a vertex without triangles, or where they cancel.
std::vector<Vec3> vertex_normals(const SolidScene& scene);

}  // namespace supple
