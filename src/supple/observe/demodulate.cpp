#include "supple/observe/demodulate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "supple/core/error.hpp"

namespace supple {
namespace {

constexpr double two_pi = 6.283185307179586;

struct Sample {
  double time, stress;
};
using Series = std::vector<Sample>;

/// Coefficients of the functions of basis().
enum { in_phase, out_of_phase, constant, third_sin, third_cos, terms };
using Coefficients = std::array<double, terms>;

Coefficients basis(const Protocol& p, double time) {
  const double phase = two_pi * (time * p.frequency - p.pre);
  return {std::sin(phase), std::cos(phase), 1, std::sin(3 * phase), std::cos(3 * phase)};
}

/// Mean of the samples for which `in` holds; `otherwise` where there are none.
template <class In>
Sample mean_where(const Series& series, const Sample& otherwise, In in) {
  Sample sum{0, 0};
  int count = 0;
  for (const Sample& s : series)
    if (in(s.time)) {
      sum.time += s.time;
      sum.stress += s.stress;
      ++count;
    }
  return count ? Sample{sum.time / count, sum.stress / count} : otherwise;
}

/// Stress before and after the shear: means of the thirds of the rests that are next to it.
struct Rests {
  Sample before, after;
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

/// Solves the symmetric positive definite system of the first n unknowns by elimination.
Coefficients solve(std::array<Coefficients, terms> m, Coefficients b, int n) {
  for (int k = 0; k < n; ++k) {
    if (!(m[k][k] > 1e-9 * m[0][0]))
      throw input_error("the stress cannot be demodulated", "too few samples in a cycle", "record more often");
    for (int i = k + 1; i < n; ++i) {
      const double factor = m[i][k] / m[k][k];
      for (int j = k; j < n; ++j) m[i][j] -= factor * m[k][j];
      b[i] -= factor * b[k];
    }
  }
  Coefficients x{};
  for (int k = n - 1; k >= 0; --k) {
    x[k] = b[k];
    for (int j = k + 1; j < n; ++j) x[k] -= m[k][j] * x[j];
    x[k] /= m[k][k];
  }
  return x;
}

/// Least squares over begin <= t < end, a whole number of cycles for n = terms. A sample weighs half the time between
/// its neighbours, the last one's next being the first, a window later: even sampling gets even weights.
Coefficients fit(const Series& series, const Protocol& p, double begin, double end, int n) {
  const double tolerance = 1e-6 / p.frequency;  // of times that were summed up
  const auto at = [&](double time) {
    return std::lower_bound(series.begin(), series.end(), time - tolerance,
                            [](const Sample& s, double t) { return s.time < t; });
  };
  const auto first = at(begin), last = at(end);
  if (last - first < n)
    throw input_error("the stress cannot be demodulated", "too few samples in a cycle", "record more often");
  std::array<Coefficients, terms> m{};
  Coefficients b{};
  for (auto s = first; s != last; ++s) {
    const double previous = s == first ? (last - 1)->time - (end - begin) : (s - 1)->time;
    const double next = s + 1 == last ? first->time + (end - begin) : (s + 1)->time;
    const Coefficients f = basis(p, s->time);
    for (int i = 0; i < n; ++i) {
      const double weighted = 0.5 * (next - previous) * f[i];
      for (int j = 0; j < n; ++j) m[i][j] += weighted * f[j];
      b[i] += weighted * s->stress;
    }
  }
  return solve(m, b, n);
}

/// The package's sums, sum tau f / sum f^2 for each function by itself, over begin <= t <= end.
Coefficients project(const Series& series, const Protocol& p, double begin, double end) {
  Coefficients sum{}, square{};
  for (const Sample& s : series) {
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

void check(std::span<const double> time, std::span<const double> stress, const Protocol& p) {
  if (time.size() != stress.size() || time.empty())
    throw input_error("the stress cannot be demodulated",
                      std::to_string(time.size()) + " times, " + std::to_string(stress.size()) + " stresses");
  if (std::adjacent_find(time.begin(), time.end(), std::greater_equal<>{}) != time.end())
    throw input_error("the stress cannot be demodulated", "its times do not ascend");
  if (!(p.frequency > 0 && p.amplitude > 0 && p.periods > 0 && p.pre >= 0 && p.post >= 0))
    throw input_error("the stress cannot be demodulated",
                      "frequency, amplitude and periods must be positive, the rests not negative");
}

/// Standard error of the mean of one coefficient over cycles.
double standard_error(const std::vector<Coefficients>& cycles, int which) {
  const double n = static_cast<double>(cycles.size());
  if (n < 2) return -1;
  double mean = 0, square = 0;
  for (const Coefficients& c : cycles) mean += c[which] / n;
  for (const Coefficients& c : cycles) square += (c[which] - mean) * (c[which] - mean);
  return std::sqrt(square / (n * (n - 1)));
}

}  // namespace

Demodulation demodulate(std::span<const double> time, std::span<const double> stress, const Protocol& p,
                        DriftCorrection correction) {
  check(time, stress, p);
  Series series;
  series.reserve(time.size());
  for (std::size_t i = 0; i < time.size(); ++i) series.push_back({time[i], stress[i]});

  const Rests rests = find_rests(series, p);
  const double start = p.pre / p.frequency, end = (p.pre + p.periods) / p.frequency;
  const bool published = correction == DriftCorrection::published;
  Demodulation result;
  if (published || (p.pre > 0 && p.post > 0)) result.drift = rests.drift();
  result.offset = rests.before.stress + result.drift * (start - rests.before.time);
  const double removed = published ? -result.drift : result.drift;
  for (Sample& s : series) s.stress -= (s.time - start) * removed;

  const double skipped = p.periods >= 2 ? 1 : 0, measured = p.periods - skipped;
  const int whole = static_cast<int>(std::floor(measured + 1e-9));
  const auto estimate = [&](double from, double to, int n) {
    return published ? project(series, p, from, to) : fit(series, p, from, to, n);
  };
  const double begin = published ? (p.pre + skipped) / p.frequency
                                 : end - (whole > 0 ? whole : measured) / p.frequency;
  const Coefficients c = estimate(begin, end, whole > 0 ? int(terms) : 2);

  std::vector<Coefficients> cycles;
  for (int k = 0; k < whole && whole > 1; ++k)
    cycles.push_back(estimate(end - (whole - k) / p.frequency, end - (whole - k - 1) / p.frequency, terms));
  result.in_phase = c[in_phase];
  result.out_of_phase = c[out_of_phase];
  result.storage = c[in_phase] / p.amplitude;
  result.loss = c[out_of_phase] / p.amplitude;
  result.third_amplitude = std::hypot(c[third_sin], c[third_cos]);
  result.third_phase = std::atan2(c[third_cos], c[third_sin]);
  if (cycles.size() > 1) {
    result.storage_error = standard_error(cycles, in_phase) / p.amplitude;
    result.loss_error = standard_error(cycles, out_of_phase) / p.amplitude;
  }
  return result;
}

}  // namespace supple
