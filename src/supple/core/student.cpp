#include "supple/core/student.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace supple {

double student_probability(double x, int freedom) {
  const double angle = std::atan(x / std::sqrt(freedom)), square = std::cos(angle) * std::cos(angle);
  const bool odd = freedom % 2 == 1;
  double term = odd ? std::cos(angle) : 1, sum = freedom > 1 ? term : 0;
  for (int k = odd ? 3 : 2; k < freedom; k += 2) {
    term *= square * (k - 1) / k;
    sum += term;
  }
  return odd ? 2 / std::numbers::pi * (angle + std::sin(angle) * sum) : std::sin(angle) * sum;
}

double student_factor(int freedom) {
  constexpr int most = 1000;  // with more degrees of freedom the factor is 1 to within 0.0013
  const double wanted = std::erf(std::sqrt(2.0));
  double low = 0, high = 100;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (student_probability(middle, std::min(freedom, most)) < wanted ? low : high) = middle;
  }
  return 0.25 * (low + high);
}

}  // namespace supple
