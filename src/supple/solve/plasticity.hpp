/// Plastic shapes: preferred sizes of facets and bodies, and angles, follow the present ones beyond a yield
/// strain.
#pragma once
#include <limits>

#include "supple/model/system.hpp"

namespace supple {

/// How preferred shapes flow. The preferred size x0 of a facet (length of an edge; 3D: area of a triangle) or
/// of a body (area; 3D: volume) stays while |x/x0 - 1| <= yield, x being the present size. Beyond that it
/// follows
///     dx0/dt = (x - x0 (1 + s yield)) / time,   s = sign(x/x0 - 1),
/// toward x/(1 + s yield), where x is just at the yield strain. Preferred angles theta0 flow by differences,
///     d(theta0)/dt = (delta - s yield) / time,   s = sign(delta),
/// where |delta| > yield, with delta = theta - theta0. In 2D delta is less the mean of theta - theta0 over
/// the body, as the angles of a ring sum to 2 pi and a uniform change of the preferred ones has no effect. In
/// 3D every preferred angle has one: only a change in proportion to the lengths of the edges makes no force,
/// by the identity sum l_e d(theta_e) = 0 [Schlaefli 1858], and that at this one shape alone. Preferred
/// values without a stiffness stay, and so does a preferred area or volume while the present one is negative.
/// A yield of infinity means no flow, a yield of 0 a Maxwell solid.
struct PlasticLaw {
  static constexpr double none = std::numeric_limits<double>::infinity();
  double time = 1;                                 ///< tau [time]
  double facet_yield = none, volume_yield = none;  ///< strains, below 1
  double angle_yield = none;                       ///< [radian]
};

/// Throws an input error where the time is not positive, a yield is negative, or a yield strain is 1 or more
/// but not infinite, as nothing can be compressed that far.
void check(const PlasticLaw& law);

/// Moves System::shape on by dt [time] while bodies stay as they are. The solution is exact (for angles in
/// 2D, with the mean of theta - theta0 at the beginning), so that any dt is stable. To be called after each
/// accepted step; forces change with the preferred shape.
template <int Dim>
void advance(System<Dim>& system, const PlasticLaw& law, double dt);

}  // namespace supple
