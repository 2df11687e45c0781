/// Particles in 3D at one instant, as pictures take them: triangles and spheres, independent of the run that
/// they come from.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "supple/draw/canvas/color.hpp"
#include "supple/geometry/bounds.hpp"
#include "supple/model/box.hpp"
#include "supple/model/system.hpp"
#include "supple/model/units.hpp"

namespace supple {

/// A sphere, or the part of a particle that a vertex covers.
struct SolidSphere {
  Vec3 centre;    ///< [length]
  double radius;  ///< [length]
  std::int32_t body;
};

/// Three vertices, counter-clockwise as seen from outside.
struct SolidTriangle {
  std::array<std::int32_t, 3> vertex;
  std::int32_t body;
};

/// How particles that reach through the sides of a periodic cell are shown. `whole`: each once, where its
/// middle lies in the cell, and sticking out of it. `cut`: all of its images that reach into the cell, cut at
/// the sides: what the cell holds, and the cell looks as full as it is.
/// Of few particles `whole` leaves holes at the sides even where they are jammed.
enum class Images { whole, cut };

/// What a picture shows, where it is shown: nothing is wrapped or repeated any more. Triangles and spheres
/// make up bodies, each an image of a particle; the surface of a body is closed.
struct SolidScene {
  Units units = reduced_units();
  Box<3> box;  ///< at its strain
  double time = 0;
  std::int32_t particles = 0;
  std::vector<std::int32_t> particle;  ///< of each body
  Images images = Images::whole;  ///< cut: only what lies between the sides in periodic directions is drawn
  std::vector<Vec3> vertex;       ///< [length]
  std::vector<SolidTriangle> triangle;
  std::vector<SolidSphere> sphere;
};

/// What is drawn of a triangulated particle whose vertices have radii sigma/2. `inflated`: its surface moved
/// outward, each vertex by its radius along its normal, so that particles that touch are seen to touch.
/// `vertices`: the triangles where they are and the spheres on their vertices, which is what rough contacts
/// feel. `bare`: the triangles alone; there are gaps of sigma between particles that touch.
enum class Skin { inflated, vertices, bare };

/// The particles of a system, moved by lattice vectors until the mean of the sites of each lies in the
/// leaning cell (drawn_cell.hpp).
SolidScene solid_scene_of(const System<3>& system, Images images = Images::cut, Skin skin = Skin::inflated);

/// The same from arrays over sites, which belong to bodies and triangles as in Topology. Throws an input
/// error where they do not fit together.
SolidScene solid_scene_of(const Box<3>& box, const Topology<3>& topology, std::span<const Vec3> position,
                          std::span<const double> radius, Images images = Images::cut,
                          Skin skin = Skin::inflated);

/// Throws an input error ("cannot draw 'PATH'") where there is nothing to draw, indices lead nowhere, a
/// number is not finite or a length not positive.
void check_scene(const SolidScene& scene, const std::string& path);

/// A colour for each particle; those that are close to each other in one of the scenes, as spheres about them
/// meet, get different ones as far as there are enough.
std::vector<Color> colors_apart(std::span<const SolidScene> scenes);

}  // namespace supple
