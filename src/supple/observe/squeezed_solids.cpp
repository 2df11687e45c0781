#include "supple/observe/squeezed_solids.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace supple {

using std::numbers::e;
using std::numbers::pi;

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
/// Where cylinder_compression has its largest value.
constexpr double largest_cylinder_force = 2 * pi / (e * e);

}  // namespace

double cylinder_compression(double force) {
  if (force == 0) return 0;
  if (!(force > 0) || force >= largest_cylinder_force) return none;
  return 2 / pi * force * (std::log(2 * pi / force) - 1);
}

double cylinder_force(double compression) {
  if (compression == 0) return 0;
  double low = 0, high = largest_cylinder_force;
  if (!(compression > 0) || compression >= 2 / pi * high) return none;
  for (int k = 0; k < 200; ++k) {  // the compression grows with the force all the way
    const double middle = 0.5 * (low + high);
    if (middle == low || middle == high) break;
    (cylinder_compression(middle) < compression ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double printed_cylinder_compression(double force) { return 4 / pi * force * (1 + std::log(pi / force)); }

double ball_force(double compression) { return std::pow(compression, 1.5) / 3; }

}  // namespace supple
