/// Attraction of short range: surfaces that touch stick together until they are pulled apart.
#pragma once

namespace supple {

/// With w the constructor's `range`, a share of d0 [Lois, Blawzdziewicz & O'Hern 2008; Irani, Chaudhuri &
/// Heussinger 2014, whose u is w/2]:
///     F = k (d0 - d),              U = (k/2) (d0 - d)^2 - k (w d0)^2/4   for d up to d0 (1 + w/2),
///     F = -k (d0 (1 + w) - d),     U = -(k/2) (d0 (1 + w) - d)^2         from there to d0 (1 + w),
/// and nothing beyond. The law is conservative and continuous. Its energy is -k (w d0)^2/4 at contact, and
/// the largest pull is k w d0/2.
class Adhesive {
 public:
  explicit Adhesive(double range) : w_(range) {}

  double range() const { return 1 + w_; }
  double force(double d, double d0, double k) const {
    return pulls_less(d, d0) ? (d < range() * d0 ? -k * (range() * d0 - d) : 0) : k * (d0 - d);
  }
  double energy(double d, double d0, double k) const {
    const double left = range() * d0 - d, depth = 0.5 * w_ * d0;
    if (pulls_less(d, d0)) return left > 0 ? -0.5 * k * left * left : 0;
    return 0.5 * k * (d0 - d) * (d0 - d) - k * depth * depth;
  }
  double stiffness(double d, double d0, double k) const {
    return pulls_less(d, d0) ? (d < range() * d0 ? -k : 0) : k;
  }

 private:
  /// Whether d is beyond the largest pull.
  bool pulls_less(double d, double d0) const { return d > (1 + 0.5 * w_) * d0; }
  double w_;
};

}  // namespace supple
