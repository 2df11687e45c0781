/// Whether a state can be one of real particles: none inside another one, no boundary across itself or
/// another one.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "supple/observe/body_shapes.hpp"

namespace supple {

/// What is wrong with a state, in numbers of bodies. One body may count in several of them.
struct Soundness {
  int turned_over = 0;    ///< bodies whose boundary is inside out, or encloses nothing
  int self_crossing = 0;  ///< bodies whose boundary crosses itself
  int inverted = 0;  ///< solids with a triangle (3D: tetrahedron) turned inside out, which costs no energy
  int inside = 0;    ///< bodies with a site inside another one, and discs or spheres that lie in a larger one
  int crossing = 0;  ///< bodies whose boundary crosses that of another one
  /// Rough: bodies with an edge (2D) so long, a triangle (3D) so large that the smallest vertex passes
  /// between its ends or corners and touches none. A triangle is closed if the spheres about its corners, of
  /// the sum of both radii, hold all of it; an equilateral one up to edges of sqrt(3) such sums.
  int open = 0;
  /// 3D: bodies with an edge longer than its vertices cover (contact/edge_cover), which an edge of another
  /// body may pass unseen. No fault by itself: what has passed is `crossing`.
  int uncovered = 0;
  int not_finite = 0;       ///< bodies with a position that is not finite
  double longest_edge = 0;  ///< rough: over the distance of its ends at which their discs or spheres touch, 1
                            ///< where they just do
  std::vector<std::uint8_t> unsound;  ///< of each body: 1 if anything is wrong with it

  int bodies() const;  ///< number of unsound bodies
  bool sound() const { return bodies() == 0; }
  /// Whether each boundary encloses an area or a volume; else packing fractions, and pressures, which are per
  /// area or volume, mean nothing.
  bool has_areas() const { return turned_over == 0 && self_crossing == 0 && not_finite == 0; }
  /// All of it in words: "2 particles have vertices inside another one, 1 crosses itself".
  std::string what() const;
};

/// Looks at all bodies and all of their images. In 2D it takes as long as two or three force evaluations for
/// a few bodies, and as some ten for hundreds; in 3D about 0.1 us for each vertex of sound surfaces, thirty
/// times as long where all of them cross.
Soundness look_at(const System<2>& system, Outline outline);
Soundness look_at(const System<3>& system, Outline outline);

/// The same of bodies that are known to be far apart, faster: each alone.
Soundness look_at_each(const System<2>& system, Outline outline);
Soundness look_at_each(const System<3>& system, Outline outline);

}  // namespace supple
