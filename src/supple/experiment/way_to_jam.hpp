/// How much of the work of a search for the jammed state is done.
#pragma once
#include <algorithm>
#include <cmath>

#include "supple/experiment/jam.hpp"

namespace supple {

/// Estimates the share of the work that is done: as the search knows it, else by measurements of evaluations
/// with 16 to 64 discs and shells: a tenth when particles meet at a packing fraction of 0.5; half when the
/// pressure is first exceeded, near 0.8, as more and more particles must get out of each other's way; then it
/// grows as the logarithm of the pressure falls to the one wanted. The share never falls.
class WayToJam {
 public:
  explicit WayToJam(double pressure) : pressure_(pressure) {}

  template <int Dim>
  double share(const JamProgress<Dim>& p) {
    if (p.share) return share_ = std::clamp(*p.share, share_, 1.0);
    const double phi = p.state.packing_fraction, above = p.state.pressure / pressure_;
    if (above > 1) {
      first_above_ = std::max(first_above_, above);
      share_ = std::max(share_,
                        0.5 + 0.5 * std::log(first_above_ / above) / std::log(std::max(first_above_, 10.0)));
    } else if (first_above_ == 0) {
      const double met = std::clamp((phi - 0.5) / 0.3, 0.0, 1.0);
      share_ = std::max(share_, 0.2 * std::min(phi, 0.5) + 0.4 * met * met);
    }
    return share_ = std::min(share_, 1.0);
  }

 private:
  double pressure_, share_ = 0;
  double first_above_ = 0;  ///< highest pressure seen, over the one wanted; 0: none above it yet
};

}  // namespace supple
