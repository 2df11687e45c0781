/// Elastic laws of two sites at a distance d, d0 being the distance at which their surfaces meet. Every law
/// has force(d, d0, k) [force, positive: repulsion], energy(d, d0, k) [energy] and stiffness(d, d0, k)
/// [force/length], with force = -d(energy)/dd, stiffness = -d(force)/dd, and a spring constant k
/// [force/length]. A law ends at d0, or at range() d0 if it has a range; force and energy are zero there.
/// Figure S1-3 of the package's documentation compares them.
#pragma once
#include <cmath>
#include <string_view>

namespace supple {

/// Distance at which a law ends, over that at which surfaces meet. A law with a range above 1 attracts.
template <class Law>
constexpr double range_of(const Law& law) {
  if constexpr (requires { law.range(); }) return law.range();
  else return 1;
}

/// F = k (d0 - d), at any overlap [MacKeith 2025, eq. 9.3].
class Linear {
 public:
  static constexpr std::string_view name = "linear";
  double force(double d, double d0, double k) const { return k * (d0 - d); }
  double energy(double d, double d0, double k) const { return 0.5 * k * (d0 - d) * (d0 - d); }
  double stiffness(double, double, double k) const { return k; }
};

/// Linear to divergent (S1-5a, S1-5b, S1-6): F = k [ (1-c) delta + c delta d0/d ], delta = d0 - d, at most
/// 1000 k d0. With c = 1 (default) F would diverge at d = 0; with c = 0 it is linear.
class Divergent {
 public:
  static constexpr std::string_view name = "divergent";
  static constexpr double cap = 1000;

  explicit Divergent(double c = 1) : c_(c), x_cap_(cap_distance(c)) {}

  double force(double d, double d0, double k) const {
    const double delta = d0 - d;
    if (d <= x_cap_ * d0) return capped_force(d, d0, k);
    return k * delta * ((1 - c_) + c_ * d0 / d);
  }
  double energy(double d, double d0, double k) const {
    const double x = x_cap_ * d0;
    if (d < x && c_ > 0) return energy(x, d0, k) + (x - d) * cap * k * d0;
    const double delta = d0 - d;
    return k * (0.5 * (1 - c_) * delta * delta + (c_ > 0 ? c_ * d0 * (d0 * std::log(d0 / d) - delta) : 0));
  }
  double stiffness(double d, double d0, double k) const {
    if (d <= x_cap_ * d0) return c_ > 0 ? 0 : k;
    return k * ((1 - c_) + c_ * (d0 / d) * (d0 / d));
  }

 private:
  /// d/d0 where the force reaches the cap: (1-c) x^2 + (cap - 1 + 2c) x - c = 0.
  static double cap_distance(double c) {
    const double b = cap - 1 + 2 * c;
    return 2 * c / (b + std::sqrt(b * b + 4 * (1 - c) * c));
  }
  double capped_force(double d, double d0, double k) const { return c_ > 0 ? cap * k * d0 : k * (d0 - d); }

  double c_, x_cap_;
};

/// Like Hertz (S1-13, an average over 3D packings with coordination Z = 10.7): F = Z sqrt(2)/(8 sqrt(3)) E
/// R^-1/2 delta^1.5 per metre of depth, with delta = d0 - d, R = d0/2 and E = 8 k/pi (S1-8).
class Hertz {
 public:
  static constexpr std::string_view name = "hertz";
  double force(double d, double d0, double k) const {
    const double delta = d0 - d;
    return prefactor(d0, k) * delta * std::sqrt(delta);
  }
  double energy(double d, double d0, double k) const {
    const double delta = d0 - d;
    return 0.4 * prefactor(d0, k) * delta * delta * std::sqrt(delta);
  }
  double stiffness(double d, double d0, double k) const { return 1.5 * prefactor(d0, k) * std::sqrt(d0 - d); }

 private:
  static double prefactor(double d0, double k) {
    constexpr double pi = 3.14159265358979323846, coordination = 10.7;
    static const double z = coordination * std::sqrt(2.0) / (8 * std::sqrt(3.0));
    return z * (8 * k / pi) / std::sqrt(0.5 * d0);
  }
};

/// Highly compressible, sponge-like discs: the law Divergent at a mapped distance d'(d). d' = d above `end`,
/// falls with the reduced `slope` from `end` down to `begin` (shares of d0), and then straight to zero at d =
/// 0.
class Plateau {
 public:
  static constexpr std::string_view name = "plateau";
  Plateau(double c, double begin, double end, double slope)
      : law_(c),
        begin_(begin),
        end_(end),
        slope_(slope),
        inner_slope_((end + (begin - end) * slope) / begin) {}

  double force(double d, double d0, double k) const { return law_.force(mapped(d, d0), d0, k); }
  /// The integral of the force over d, not over d': on each branch that over d' divided by the slope
  /// d(d')/dd.
  double energy(double d, double d0, double k) const {
    const auto u = [&](double at) { return law_.energy(mapped(at, d0), d0, k); };
    const double begin = begin_ * d0, end = end_ * d0;
    if (d >= end) return u(d);
    if (d >= begin) return u(end) + (u(d) - u(end)) / slope_;
    return u(end) + (u(begin) - u(end)) / slope_ + (u(d) - u(begin)) / inner_slope_;
  }
  double stiffness(double d, double d0, double k) const {
    const double slope = d >= end_ * d0 ? 1 : d >= begin_ * d0 ? slope_ : inner_slope_;
    return slope * law_.stiffness(mapped(d, d0), d0, k);
  }

 private:
  double mapped(double d, double d0) const {
    if (d >= end_ * d0) return d;
    if (d >= begin_ * d0) return end_ * d0 + (d - end_ * d0) * slope_;
    return d * inner_slope_;
  }
  Divergent law_;
  double begin_, end_, slope_, inner_slope_;
};

/// Attraction of a stretched link, d > d0; force() gives it as a negative repulsion. Linear: k (d - d0).
/// Exponential: k a d0 (exp((d - d0)/(a d0)) - 1), which stiffens. Saturating: k a d0 (1 - exp(-(d - d0)/(a
/// d0))), which the published package calls exponential. a is `range`; all have the slope k at d0.
class Tensile {
 public:
  enum class Kind { linear, exponential, saturating };
  explicit Tensile(Kind kind = Kind::linear, double range = 0.2) : kind_(kind), range_(range) {}

  double force(double d, double d0, double k) const {
    const double stretch = d - d0;
    if (kind_ == Kind::linear) return -k * stretch;
    const double sign = kind_ == Kind::exponential ? 1 : -1, length = range_ * d0;
    return -sign * k * length * std::expm1(sign * stretch / length);
  }
  double energy(double d, double d0, double k) const {
    const double stretch = d - d0;
    if (kind_ == Kind::linear) return 0.5 * k * stretch * stretch;
    const double sign = kind_ == Kind::exponential ? 1 : -1, length = range_ * d0;
    return k * length * (length * std::expm1(sign * stretch / length) - sign * stretch);
  }

 private:
  Kind kind_;
  double range_;
};

}  // namespace supple
