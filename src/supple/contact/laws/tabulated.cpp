#include "supple/contact/laws/tabulated.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "supple/core/error.hpp"

namespace supple {

namespace {

constexpr double strongest = 1000;  ///< the cap of S1-6 [k d0]
constexpr double good_enough = 1e-8;
constexpr int most_bits = 10;  ///< 1024 cells an octave: 600 kB

double integral(double a, double b, double c, double d, double s) {
  return s * (a + s * (b / 2 + s * (c / 3 + s * d / 4)));
}

/// The checks of the constructor, at points dense enough to meet what a formula may do.
void check_law(const RepulsionFunction& law, double c, const std::string& what) {
  const auto fail = [&](const std::string& problem, const std::string& to_do) {
    throw input_error(what + " " + problem,
                      "a repulsion law F(d, d0, k, c) must be finite, not attractive and continuous "
                      "for 0 < d <= d0",
                      to_do);
  };
  if (const double at_contact = law(1, 1, 1, c); !(std::abs(at_contact) <= 1e-9))
    fail(fmt::format("is {:.4g} k d0 at contact, d = d0", at_contact),
         "make it zero there, e.g. a factor (d0 - d)");
  for (int i = 1; i <= 4000; ++i) {
    const double x = i <= 2000 ? std::exp2(-14.0 * (2000 - i) / 2000 - 1) : 0.5 + 0.5 * (i - 2000) / 2000.0;
    const double f = law(x, 1, 1, c);
    if (!std::isfinite(f))
      fail(fmt::format("is not finite at d = {:.4g} d0", x), "look for a division by zero or a root");
    if (f < -1e-12)
      fail(fmt::format("attracts at d = {:.4g} d0 (F = {:.4g} k d0)", x, f),
           "repulsion is positive: turn the sign");
    if (f > strongest * (1 + 1e-9))
      fail(fmt::format("diverges: {:.4g} k d0 at d = {:.4g} d0", f, x), "cap it, e.g. min(..., 1000*k*d0)");
    if (std::abs(law(x, 1, 3, c) - 3 * f) > 1e-9 * (1 + 3 * f))
      fail("is not proportional to k", "multiply a function of d/d0 by k*d0");
    if (std::abs(law(2.5 * x, 2.5, 1, c) - 2.5 * f) > 1e-9 * (1 + 2.5 * f))
      fail("has a length of its own: F(2.5 d, 2.5 d0) is not 2.5 F(d, d0)",
           "multiply a function of d/d0 by k*d0");
  }
}

}  // namespace

Tabulated::Tabulated(const RepulsionFunction& law, double c, const std::string& what) {
  check_law(law, c, what);
  const auto g = [&](double x) { return law(x, 1, 1, c); };
  for (int bits = 3; bits <= most_bits; ++bits) {
    build(g, bits);
    if (error_bound_ < good_enough) break;
  }
}

void Tabulated::build(const std::function<double(double)>& g, int bits) {
  shift_ = 52 - bits;
  base_ = std::bit_cast<std::int64_t>(least) >> shift_;
  const auto count = static_cast<std::size_t>(octaves) << bits;
  const auto node = [&](std::size_t i) {
    return i == count ? 1.0 : std::bit_cast<double>((base_ + static_cast<std::int64_t>(i)) << shift_);
  };
  // One-sided at the ends of the range, so that the law is not asked beyond contact.
  const auto slope = [&](double x, double h) {
    const double low = x - h, high = std::min(x + h, 1.0);
    return (g(high) - g(low)) / (high - low);
  };
  auto cells = std::make_shared<std::vector<Cell>>(count);
  double energy = 0;
  error_bound_ = 0;
  for (std::size_t i = count; i-- > 0;) {
    const double x0 = node(i), x1 = node(i + 1), w = x1 - x0, h = 1e-4 * w;
    const double g0 = g(x0), g1 = g(x1), b = slope(x0, h), m1 = slope(x1, h);
    const double chord = (g1 - g0) / w;
    const double c = (3 * chord - 2 * b - m1) / w, d = (b + m1 - 2 * chord) / (w * w);
    energy += integral(g0, b, c, d, w);
    (*cells)[i] = {x0, g0, b, c, d, energy};
    for (double s : {0.2, 0.4, 0.6, 0.8}) {
      const double t = s * w, exact = g(x0 + t);
      error_bound_ =
          std::max(error_bound_, std::abs(g0 + t * (b + t * (c + t * d)) - exact) / std::max(1.0, exact));
    }
  }
  cells_ = std::move(cells);
}

double Tabulated::energy(double d, double d0, double k) const {
  const double x = clamped(d / d0);
  const Cell& cell = cell_at(x);
  const double inside = cell.energy - integral(cell.a, cell.b, cell.c, cell.d, x - cell.start);
  const double core = (x - d / d0) * cell.a;  // constant force below the table; zero elsewhere
  return k * d0 * d0 * (inside + (d / d0 < least ? core : 0));
}

}  // namespace supple
