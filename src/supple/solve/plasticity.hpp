/// Plastic shapes: preferred lengths, areas and angles follow the present ones beyond a yield strain.
#pragma once
#include <limits>

#include "supple/model/system.hpp"

namespace supple {

/// How preferred shapes flow. A preferred length or area x0 stays while |x/x0 - 1| <= yield, x being the
/// present length or area. Beyond that it follows
///     dx0/dt = (x - x0 (1 + s yield)) / time,   s = sign(x/x0 - 1),
/// toward x/(1 + s yield), where x is just at the yield strain. Preferred angles theta0 flow by differences,
///     d(theta0)/dt = (delta - s yield) / time,   s = sign(delta),
/// with delta = theta - theta0, less the mean of theta - theta0 over the body,
/// where |delta| > yield, as the angles of a ring sum to 2 pi and a uniform change of the preferred ones has
/// no effect. Preferred values without a stiffness stay, and so does a preferred area while the present one
/// is negative. A yield of infinity means no flow, a yield of 0 a Maxwell solid.
struct PlasticLaw {
  static constexpr double none = std::numeric_limits<double>::infinity();
  double time = 1;                                ///< tau [time]
  double length_yield = none, area_yield = none;  ///< strains, below 1
  double angle_yield = none;                      ///< [radian]
};

/// Throws an input error where the time is not positive, a yield is negative, or a yield strain is 1 or more
/// but not infinite, as nothing can be compressed that far.
void check(const PlasticLaw& law);

/// Moves System::shape on by dt [time] while bodies stay as they are. The solution is exact (for angles, with
/// the mean of theta - theta0 at the beginning), so that any dt is stable. To be called after each accepted
/// step; forces change with the preferred shape.
void advance(System<2>& system, const PlasticLaw& law, double dt);

}  // namespace supple
