/// Whether particles are where particles can be: none in another one, no boundary across itself or another
/// one.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "supple/observe/body_shapes.hpp"

namespace supple {

/// What is wrong with a state, in numbers of bodies. A body may be wrong in several ways.
struct Soundness {
  int turned_over = 0;    ///< whose ring runs clockwise, or encloses nothing
  int self_crossing = 0;  ///< whose boundary crosses itself
  int inside = 0;         ///< with a site inside another body, or discs that lie in a larger one
  int crossing = 0;       ///< whose boundary crosses that of another one
  int open = 0;           ///< rough: with an edge so long that the smallest vertex passes between its ends
  int not_finite = 0;     ///< with a position that is no number
  double longest_edge =
      0;  ///< rough: over the distance of its ends at which their discs touch, 1 where they just do
  std::vector<std::uint8_t> unsound;  ///< of each body: 1 if one of these is so

  int bodies() const;  ///< that are unsound
  bool sound() const { return bodies() == 0; }
  /// Whether each ring encloses an area, so that packing fractions and pressures per area mean something.
  bool has_areas() const { return turned_over == 0 && self_crossing == 0 && not_finite == 0; }
  /// "2 particles have vertices inside another one, 1 crosses itself".
  std::string what() const;
};

/// Looks at all bodies, with all of their images. Costs two or three force evaluations for a few bodies and
/// some ten for hundreds: bodies are found by their bounds, edges by theirs.
Soundness look_at(const System<2>& system, Outline outline);

}  // namespace supple
