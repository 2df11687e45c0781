/// The case that everything is timed on: dense bidisperse frictional discs in gentle motion.
#pragma once
#include "supple/solve/mover.hpp"

namespace supple::bench {

/// Units: a small disc has diameter 1 and mass 1, a contact stiffness 1, so the contact time sqrt(m/k) is 1.
struct DenseSpec {
  int discs = 10000;
  double packing_fraction = 0.84, size_ratio = 1.4;
  double aspect_ratio = 1;  ///< height of the cell over its width
  double speed = 0.005;     ///< root mean square of each velocity component at the start
};

inline constexpr double time_step = 0.02;

/// Linear repulsion with tangential springs as stiff, light damping (so that motion lasts), friction
/// coefficient 0.5.
DiscLaw dense_law();
Mover<2> dense_dynamics(double relative_skin = default_skin);

/// Random discs numbered along a space-filling curve, relaxed without friction, then set in motion.
System<2> dense_discs(const DenseSpec& spec);

/// Pairs that touch, per disc and counted from both: the coordination number.
double contacts_per_disc(const System<2>& system);
/// Root mean square of a velocity component, weighted by mass.
double rms_speed(const System<2>& system);

}  // namespace supple::bench
