/// Plastic shapes: what a body prefers follows what it is, beyond a yield strain.
#pragma once
#include <limits>

#include "supple/model/system.hpp"

namespace supple {

/// How preferred shapes flow. A preferred length or area x0 stays as it is while |x/x0 - 1| <= yield, x being
/// the present one, and beyond it follows
///     dx0/dt = (x - x0 (1 + s yield)) / time,   s = sign(x/x0 - 1),
/// toward x/(1 + s yield), where it would just not flow. A preferred angle does the same by a difference,
///     d(theta0)/dt = (delta - s yield) / time,   delta = theta - theta0, less its mean over the body, s =
///     sign(delta),
/// as angles of a ring sum to 2 pi and a uniform change of the preferred ones has no effect. Preferred values
/// of no stiffness stay, and that of a negative area. A yield of infinity: no flow; of 0: a Maxwell solid.
struct PlasticLaw {
  static constexpr double none = std::numeric_limits<double>::infinity();
  double time = 1;                                ///< tau [time]
  double length_yield = none, area_yield = none;  ///< strains, below 1
  double angle_yield = none;                      ///< [radian]
};

/// Input error where the time is not positive, a yield is negative, or a yield strain is 1 or more but not
/// infinite: nothing can be compressed that far.
void check(const PlasticLaw& law);

/// Moves System::shape on by dt while bodies stay as they are, exactly (of angles: with the mean at the
/// beginning), so that any dt is stable. After each accepted step; bodies prefer another shape then, and
/// forces change.
void advance(System<2>& system, const PlasticLaw& law, double dt);

}  // namespace supple
