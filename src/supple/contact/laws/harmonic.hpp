/// The springs of vertices, edges and walls.
#pragma once

namespace supple {

/// U = (k/2)(sigma - r)^2 for r < sigma [MacKeith 2025, eq. 9.3], r the distance and sigma that at which the
/// surfaces meet [length]; k = stiffness [energy/length^2]. relative: U = (stiffness/2)(1 - r/sigma)^2,
/// stiffness [energy]. To be called only with r < sigma.
struct Harmonic {
  double stiffness = 1;
  bool relative = false;

  double spring(double sigma) const { return relative ? stiffness / (sigma * sigma) : stiffness; }
  double energy(double r, double sigma) const { return 0.5 * spring(sigma) * (sigma - r) * (sigma - r); }
  /// -dU/dr [force]; positive: repulsion.
  double force(double r, double sigma) const { return spring(sigma) * (sigma - r); }
};

}  // namespace supple
