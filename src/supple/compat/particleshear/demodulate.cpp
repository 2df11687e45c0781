/// Demodulation as particleShear 1.0.2 does it.
#include "supple/compat/particleshear/demodulate.hpp"

#include <array>

#include "supple/core/whole_number.hpp"
#include "supple/observe/cycles.hpp"

namespace supple {
namespace {

enum { in_phase, out_of_phase, constant, third_sin, third_cos, terms };
using Coefficients = std::array<double, terms>;

Coefficients basis(const Protocol& p, double time) {
  const double phase = phase_of(p, time);
  return {std::sin(phase), std::cos(phase), 1, std::sin(3 * phase), std::cos(3 * phase)};
}

/// Mean of the samples for which `in` holds; `otherwise` where there are none.
template <class In>
StressSample mean_where(const Series& series, const StressSample& otherwise, In in) {
  StressSample sum{0, 0};
  int count = 0;
  for (const StressSample& s : series)
    if (in(s.time)) {
      sum.time += s.time;
      sum.stress += s.stress;
      ++count;
    }
  return count ? StressSample{sum.time / count, sum.stress / count} : otherwise;
}

/// Stress before and after the shear: means of the thirds of the rests that are next to it.
struct Rests {
  StressSample before, after;
  double drift() const {
    return after.time > before.time ? (after.stress - before.stress) / (after.time - before.time) : 0;
  }
};

Rests find_rests(const Series& series, const Protocol& p) {
  const double f = p.frequency, start = p.pre / f, end = (p.pre + p.periods) / f;
  return {mean_where(series, series.front(), [&](double t) { return 2 * p.pre / 3 / f <= t && t < start; }),
          mean_where(series, series.back(),
                     [&](double t) { return end < t && t <= (p.pre + p.periods + p.post / 3) / f; })};
}

/// The package's sums, sum tau f / sum f^2 for each function by itself, over begin <= t <= end.
Coefficients project(const Series& series, const Protocol& p, double begin, double end) {
  Coefficients sum{}, square{};
  for (const StressSample& s : series) {
    if (s.time < begin || s.time > end) continue;
    const Coefficients f = basis(p, s.time);
    for (int i = 0; i < terms; ++i) {
      sum[i] += s.stress * f[i];
      square[i] += f[i] * f[i];
    }
  }
  for (int i = 0; i < terms; ++i) sum[i] /= square[i];
  return sum;
}

}  // namespace

Demodulation demodulate_as_published(std::vector<StressSample> series, const Protocol& p) {
  const Rests rests = find_rests(series, p);
  const double start = p.pre / p.frequency, end = (p.pre + p.periods) / p.frequency;
  Demodulation result;
  result.drift = rests.drift();
  result.offset = rests.before.stress + result.drift * (start - rests.before.time);
  for (StressSample& s : series) s.stress -= (s.time - start) * -result.drift;

  const double skipped = first_measured(p);
  const Coefficients c = project(series, p, (p.pre + skipped) / p.frequency, end);
  result.in_phase = c[in_phase];
  result.out_of_phase = c[out_of_phase];
  result.third_amplitude = std::hypot(c[third_sin], c[third_cos]);
  result.third_phase = std::atan2(c[third_cos], c[third_sin]);

  result.cycles =
      whole_number<int>(std::floor(p.periods - skipped + 1e-9), "cycles of the shear", "lower shear.periods");
  std::vector<double> storage, loss;
  for (int k = result.cycles; k > 0; --k) {
    const Coefficients cycle = project(series, p, end - k / p.frequency, end - (k - 1) / p.frequency);
    storage.push_back(cycle[in_phase] / p.amplitude);
    loss.push_back(cycle[out_of_phase] / p.amplitude);
  }
  result.storage = modulus_of_cycles(storage);
  result.loss = modulus_of_cycles(loss);
  return result;
}

}  // namespace supple
