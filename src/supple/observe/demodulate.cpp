#include "supple/observe/demodulate.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "supple/core/error.hpp"
#include "supple/core/whole_number.hpp"
#include "supple/observe/cycles.hpp"

namespace supple {
namespace {

/// Functions of the fit: sin and cos of each harmonic, a constant, and a ramp from -1 to 1 over the window.
struct Model {
  std::vector<int> harmonics;  ///< the first, the third, and others
  bool ramp;
  std::size_t size() const { return 2 * harmonics.size() + 1 + ramp; }
};

constexpr std::size_t in_phase = 0, out_of_phase = 1, third_sin = 2, third_cos = 3;

/// Harmonics that this many samples in a cycle can tell apart: (samples - 1)/2, and five at most.
std::vector<int> harmonics_of(double samples, int cycles) {
  if (cycles == 1) return {1, 3};
  std::vector<int> all{1, 3, 2};
  for (int m = 4; m <= 5 && 2 * m < samples; ++m) all.push_back(m);
  return all;
}

struct Window {
  double begin, end;
  double middle() const { return 0.5 * (begin + end); }
  double half() const { return 0.5 * (end - begin); }
};

/// sin and cos of the harmonics at each sample of a series, one sample after the other: the fits of the whole
/// and of each cycle share them.
std::vector<double> waves_of(const Series& series, const Protocol& p, const std::vector<int>& harmonics) {
  std::vector<double> waves;
  waves.reserve(2 * harmonics.size() * series.size());
  for (const StressSample& s : series) {
    const double phase = phase_of(p, s.time);
    for (const int m : harmonics) {
      waves.push_back(std::sin(m * phase));
      waves.push_back(std::cos(m * phase));
    }
  }
  return waves;
}

/// Solves the symmetric positive definite system m x = b by elimination.
std::vector<double> solve(std::vector<std::vector<double>> m, std::vector<double> b) {
  const std::size_t n = b.size();
  for (std::size_t k = 0; k < n; ++k) {
    if (!(m[k][k] > 1e-9 * m[0][0])) throw too_few_samples();
    for (std::size_t i = k + 1; i < n; ++i) {
      const double factor = m[i][k] / m[k][k];
      for (std::size_t j = k; j < n; ++j) m[i][j] -= factor * m[k][j];
      b[i] -= factor * b[k];
    }
  }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t j = k + 1; j < n; ++j) b[k] -= m[k][j] * b[j];
    b[k] /= m[k][k];
  }
  return b;
}

/// Samples with begin <= t < end.
std::span<const StressSample> samples_in(const Series& series, const Protocol& p, const Window& w) {
  const double tolerance = 1e-6 / p.frequency;  // of times that were summed up
  const auto at = [&](double time) {
    return std::lower_bound(series.begin(), series.end(), time - tolerance,
                            [](const StressSample& s, double t) { return s.time < t; });
  };
  return {at(w.begin), at(w.end)};
}

/// Least squares over a window of whole cycles. A sample weighs half the time between its neighbours; after
/// the last sample comes the first one again, a window later. Even sampling has even weights.
std::vector<double> fit(const Series& series, const std::vector<double>& waves, const Protocol& p,
                        const Window& w, const Model& model) {
  const std::span<const StressSample> samples = samples_in(series, p, w);
  const std::size_t n = model.size(), count = samples.size();
  if (count < n) throw too_few_samples();
  std::vector<std::vector<double>> m(n, std::vector<double>(n));
  std::vector<double> b(n), f(n);
  const std::size_t width = 2 * model.harmonics.size();
  auto wave = waves.begin() + static_cast<std::ptrdiff_t>(width) * (samples.data() - series.data());
  for (std::size_t s = 0; s < count; ++s, wave += static_cast<std::ptrdiff_t>(width)) {
    const double previous = s == 0 ? samples.back().time - 2 * w.half() : samples[s - 1].time;
    const double next = s + 1 == count ? samples.front().time + 2 * w.half() : samples[s + 1].time;
    std::copy_n(wave, width, f.begin());
    f[width] = 1;
    if (model.ramp) f[width + 1] = (samples[s].time - w.middle()) / w.half();
    for (std::size_t i = 0; i < n; ++i) {
      const double weighted = 0.5 * (next - previous) * f[i];
      for (std::size_t j = 0; j < n; ++j) m[i][j] += weighted * f[j];
      b[i] += weighted * samples[s].stress;
    }
  }
  return solve(std::move(m), std::move(b));
}

/// Fits of each cycle by itself.
std::vector<std::vector<double>> fit_cycles(const Series& series, const std::vector<double>& waves,
                                            const Protocol& p, const Window& whole, int cycles,
                                            const Model& model) {
  std::vector<std::vector<double>> all;
  for (int k = cycles; k > 0; --k)
    all.push_back(
        fit(series, waves, p, {whole.end - k / p.frequency, whole.end - (k - 1) / p.frequency}, model));
  return all;
}

/// Slope of the straight line through the constants of the cycles [stress/cycle].
double slope_of_constants(const std::vector<std::vector<double>>& cycles) {
  double sum = 0, moment = 0;
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    const double k = static_cast<double>(i) - 0.5 * static_cast<double>(cycles.size() - 1);
    sum += k * cycles[i].back();
    moment += k * k;
  }
  return sum / moment;
}

void remove_ramp(Series& series, double slope, double from) {
  for (StressSample& s : series) s.stress -= slope * (s.time - from);
}

void check(std::span<const double> time, std::span<const double> stress, const Protocol& p) {
  constexpr const char* failed = "the stress cannot be demodulated";
  if (time.size() != stress.size() || time.empty())
    throw input_error(failed,
                      std::to_string(time.size()) + " times, " + std::to_string(stress.size()) + " stresses");
  if (std::adjacent_find(time.begin(), time.end(), std::greater_equal<>{}) != time.end())
    throw input_error(failed, "its times do not ascend");
  if (!(p.frequency > 0 && p.amplitude > 0 && p.periods > 0 && p.pre >= 0 && p.post >= 0))
    throw input_error(failed, "frequency, amplitude and periods must be positive, the rests not negative");
}

}  // namespace

/// A ramp that is fitted beside a few harmonics takes up some of those that are not fitted. What it is wrong
/// by shows from cycle to cycle, as harmonics of any order do not: two and more cycles correct it.
Demodulation fit_harmonics(std::vector<StressSample> series, const Protocol& p) {
  if (p.periods < 1 - 1e-9)
    throw input_error("the stress cannot be demodulated",
                      "less than one period of shear tells G', G'', offset and drift not apart",
                      "shear for at least one period");
  Demodulation result;
  const int cycles = result.cycles = whole_number<int>(std::floor(p.periods - first_measured(p) + 1e-9),
                                                       "cycles of the shear", "lower shear.periods");
  const double start = p.pre / p.frequency, end = (p.pre + p.periods) / p.frequency;
  const Window whole{end - cycles / p.frequency, end};
  const double samples = static_cast<double>(samples_in(series, p, whole).size()) / cycles;
  if (samples < least_samples_of_cycle - 0.5) throw too_few_samples();
  Model model{harmonics_of(samples, cycles), true};
  const std::vector<double> waves = waves_of(series, p, model.harmonics);
  std::vector<double> c = fit(series, waves, p, whole, model);
  result.drift = c.back() / whole.half();
  c.pop_back();
  remove_ramp(series, result.drift, start);
  model.ramp = false;
  if (cycles > 1) {
    const double rest = slope_of_constants(fit_cycles(series, waves, p, whole, cycles, model)) * p.frequency;
    remove_ramp(series, rest, start);
    result.drift += rest;
    c = fit(series, waves, p, whole, model);
    std::vector<double> storage, loss;
    for (const std::vector<double>& cycle : fit_cycles(series, waves, p, whole, cycles, model)) {
      storage.push_back(cycle[in_phase] / p.amplitude);
      loss.push_back(cycle[out_of_phase] / p.amplitude);
    }
    result.storage = modulus_of_cycles(storage);
    result.loss = modulus_of_cycles(loss);
    result.offset = c.back();
  } else {
    result.offset = c.back() + result.drift * (start - whole.middle());
  }
  result.in_phase = c[in_phase];
  result.out_of_phase = c[out_of_phase];
  result.third_amplitude = std::hypot(c[third_sin], c[third_cos]);
  result.third_phase = std::atan2(c[third_cos], c[third_sin]);
  return result;
}

Demodulation demodulate(std::span<const double> time, std::span<const double> stress, const Protocol& p,
                        Demodulator demodulator) {
  check(time, stress, p);
  Series series;
  series.reserve(time.size());
  for (std::size_t i = 0; i < time.size(); ++i) series.push_back({time[i], stress[i]});
  Demodulation result = demodulator(std::move(series), p);
  result.storage.value = result.in_phase / p.amplitude;
  result.loss.value = result.out_of_phase / p.amplitude;
  return result;
}

}  // namespace supple
