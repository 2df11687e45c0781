/// Two particles, one above the other, and the way of the upper one over the lower [MacKeith 2025,
/// section 9.3.3].
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "supple/experiment/derived.hpp"
#include "supple/experiment/packing.hpp"
#include "supple/force/external.hpp"

namespace supple {

/// The places of the upper particle, in steps: from the first place to the last, back again, and so on.
struct SlidingPath {
  double step = 0;          ///< between two places [length]
  double first = 0;         ///< x of the leftmost place [steps]
  std::int64_t length = 0;  ///< of the way from the leftmost to the rightmost place [steps]
  bool starts_right = false;
  std::int64_t legs = 1;  ///< ways from one end to the other

  /// Number of places: each is followed by a relaxation.
  std::int64_t places() const { return legs * length + 1; }
  /// The way, from 0, that leads to this place.
  std::int64_t leg(std::int64_t place) const { return place > 0 ? (place - 1) / length : 0; }
  bool goes_left(std::int64_t place) const { return (leg(place) % 2 == 1) != starts_right; }
  /// x_bm [length]: how far to the right the upper particle is held.
  double x(std::int64_t place) const {
    const std::int64_t gone = place - leg(place) * length,
                       from_left = goes_left(place) ? length - gone : gone;
    return step * (first + static_cast<double>(from_left));
  }
};

/// The particles are bodies 0, below, with an edge up, and 1, above, with a vertex down, each in the shape
/// that it takes alone. Springs hold the two lowest vertices of the lower one and the three highest of the
/// upper one where they are in these shapes; of a particle with an odd number of vertices, where an edge and
/// a vertex change places, three and two. x_bm is the x of the middle spring of three less the mean x of two
/// (in general the middle one of an odd number, the mean of an even one).
struct SlidingPair {
  Packing<2> packing;
  std::vector<Tether<2>> held, moved;  ///< springs of the lower and, with x_bm = 0, of the upper particle
  SlidingPath path;
  double width = 0;        ///< D, of the lower one at the start: widest distance of vertices along x + sigma
  double radius = 0;       ///< R: of the circle through the vertices of the lower, regular particle
  double sigma = 0;        ///< mean diameter of vertices
  double spring = 0;       ///< k_c of their contact [energy/length^2]
  double touch = 0;        ///< vertical distance of centres at which they first touch at x_bm = 0
  double least_force = 0;  ///< below which the two count as apart in results [force]
  double rise = 0;         ///< vertical distance of centres at the start
  std::optional<double> bound;  ///< of mu_eff by (9.13), of rough particles

  /// The springs, with the upper particle held at this place of the path.
  std::vector<Tether<2>> tethers(std::int64_t place) const;
  /// Of a number of energy, in units of k_c sigma^2.
  double in_contact_energies(double energy) const { return energy / (spring * sigma * sigma); }
};

/// The pair at the first place of its path, at rest and not yet relaxed there. Input errors where the two
/// never touch, or have too far to go; numerics errors where they find no shapes to start with.
SlidingPair make_sliding_pair(const Case& c);

/// Numbers of the pair that are known before it moves.
std::vector<Derived> derived_pair(const SlidingPair& pair);

}  // namespace supple
