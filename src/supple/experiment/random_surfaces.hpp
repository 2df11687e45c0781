/// Samples of particles in 3D at random places.
#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "supple/build/solid_bodies.hpp"
#include "supple/build/surfaces.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// Whether the vertices of a surface move by themselves, or all as one piece (make_rigid).
enum class SurfaceMotion { deforming, rigid };

/// Particles of one kind in 3D.
struct SurfaceKind {
  int count = 1;
  int vertices = 42;          ///< 12, 42, 162 ... (geodesic_icosahedron); 1: smooth spheres; see solid_mesh
  double diameter = 1;        ///< of the sphere of its volume, over that of volume 1
  double diameter_ratio = 1;  ///< of vertices, over the mean edge; for smooth spheres it means nothing
  ShapeSpec shape = {};       ///< relative stiffnesses mean the same for every size
  SurfaceMotion motion = SurfaceMotion::deforming;
  std::optional<SolidSpec> solid = {};  ///< what fills it; nothing: a surface with the energy `shape`
};

/// The radius of the sphere round each particle of these kinds, one kind after the other [length].
std::vector<double> enclosing_radii(const std::vector<SurfaceKind>& kinds);

/// These particles about these centres in a cell, turned at random, each by the seed and its number. A shape
/// parameter above that of the geodesic sphere leaves triangles compressed: vertices are pushed a little, so
/// that they buckle. Throws an input error on numbers of vertices that no geodesic sphere has.
System<3> surfaces_about(const std::vector<SurfaceKind>& kinds, const std::vector<Vec3>& centre,
                         const Box<3>& box, std::int64_t seed);

/// Geodesic spheres, or smooth spheres, of two sizes. Small ones have the volume 1.
struct SurfaceSample {
  int count = 16;
  int vertices = 42;  ///< 12, 42, 162 ... (geodesic_icosahedron); 1: smooth spheres
  double size_ratio = 1.4, large_fraction = 0.5;
  double diameter_ratio = 1;  ///< of vertices, over the mean edge; for smooth spheres it means nothing
  SurfaceMotion motion = SurfaceMotion::deforming;  ///< for smooth spheres it means nothing
  ShapeSpec shape = {};           ///< of those that deform; relative stiffnesses mean the same for both sizes
  double packing_fraction = 0.1;  ///< of the spheres that enclose the particles
  std::int64_t seed = 1;
};

/// These particles in a cubic periodic cell (surfaces_about), apart as far as there is room. Throws an input
/// error on numbers that cannot be, and `interrupted` where asked to stop.
System<3> random_surfaces(const SurfaceSample& sample, const std::function<bool()>& stop_requested = {});

}  // namespace supple
