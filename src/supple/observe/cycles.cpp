#include "supple/observe/cycles.hpp"

#include "supple/core/student.hpp"

namespace supple {

Modulus modulus_of_cycles(const std::vector<double>& cycles) {
  Modulus m;
  const int n = static_cast<int>(cycles.size());
  if (n < 3) return m;
  double mean = 0, moment = 0;  // moment: sum of k^2, k from the middle cycle
  for (int i = 0; i < n; ++i) {
    const double k = i - 0.5 * (n - 1);
    mean += cycles[i] / n;
    moment += k * k;
    m.change += k * cycles[i];
  }
  m.change /= moment;
  double square = 0, beside_line = 0;
  for (int i = 0; i < n; ++i) {
    const double off = cycles[i] - mean, beside = off - m.change * (i - 0.5 * (n - 1));
    square += off * off;
    beside_line += beside * beside;
  }
  m.error = std::hypot(student_factor(n - 1) * std::sqrt(square / (n * (n - 1.0))), n * m.change);
  m.change_error = student_factor(n - 2) * std::sqrt(beside_line / ((n - 2) * moment));
  return m;
}

}  // namespace supple
