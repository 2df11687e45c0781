/// Demodulation of signals whose moduli are known, and of those that the published package was given.
#include "supple/observe/demodulate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <vector>

#include "supple/core/error.hpp"
#include "supple/core/random.hpp"

namespace supple {
namespace {

constexpr double two_pi = 6.283185307179586;

struct Signal {
  double storage = 1000, loss = 200, offset = 0, drift = 0, third = 0, third_phase = 0;
};
struct Series {
  std::vector<double> time, stress;
};

bool shears(const Protocol& p, double t) {
  return p.pre / p.frequency <= t && t <= (p.pre + p.periods) / p.frequency;
}
double stress_of(const Signal& s, const Protocol& p, double t) {
  const double phase = two_pi * (t * p.frequency - p.pre);
  const double shear = p.amplitude * (s.storage * std::sin(phase) + s.loss * std::cos(phase)) +
                       s.third * std::sin(3 * phase + s.third_phase);
  return s.offset + s.drift * t + (shears(p, t) ? shear : 0);
}
Series sampled(const Signal& s, const Protocol& p, const std::vector<double>& times) {
  Series series{times, {}};
  for (const double t : times) series.stress.push_back(stress_of(s, p, t));
  return series;
}
std::vector<double> even_times(const Protocol& p, double step) {
  std::vector<double> times;
  for (double t = 0; t < (p.pre + p.periods + p.post) / p.frequency; t += step) times.push_back(t);
  return times;
}
Demodulation demodulated(const Series& s, const Protocol& p) { return demodulate(s.time, s.stress, p); }

TEST(Demodulate, FollowsThePublishedPackage) {
  const auto table = nlohmann::json::parse(std::ifstream(SUPPLE_TEST_DATA "/demodulation.json"));
  ASSERT_EQ(table.size(), 5u);
  for (const auto& c : table) {
    const Protocol p{c["f"], c["amplitude"], c["pre"], c["periods"], c["post"]};
    const double drift = c["drift_per_period"].get<double>() * p.frequency;
    const Signal signal{c["true_Gp"], c["true_Gpp"], c["offset"], drift};
    std::vector<double> times(c["samples"].get<std::size_t>());
    for (std::size_t i = 1; i < times.size(); ++i) times[i] = times[i - 1] + c["dt"].get<double>();
    const Series s = sampled(signal, p, times);
    const Demodulation d = demodulate(s.time, s.stress, p, DriftCorrection::published);
    const std::vector<double> expected = c["result"];
    EXPECT_NEAR(d.in_phase, expected[0], 1e-12 * expected[0]);
    EXPECT_NEAR(d.out_of_phase, expected[1], 1e-12 * expected[0]);
    EXPECT_NEAR(d.storage, expected[2], 1e-12 * expected[2]);
    EXPECT_NEAR(d.loss, expected[3], 1e-12 * expected[2]);
  }
}

TEST(Demodulate, PublishedSumsAreClosedAtBothEnds) {
  const Protocol p{1, 0.2, 1, 1, 1};
  const std::vector<double> times = even_times(p, 1.0 / 64);
  std::vector<double> stress(times.size(), 100);
  // The cosines of 65 samples sum up to 1, their squares to 33.
  EXPECT_NEAR(demodulate(times, stress, p, DriftCorrection::published).loss, 100 / 33.0 / 0.2, 1e-9);
  stress[64] += 50;  // the start of shear is no part of the rest before it
  EXPECT_EQ(demodulate(times, stress, p, DriftCorrection::published).drift, 0);
}

TEST(Demodulate, FindsEverythingThatASignalHolds) {
  const Protocol p{2, 0.2, 2, 3, 1};
  const Signal signal{1000, 200, 100, 10, 7, 0.6};
  for (const double step : {1 / (2 * 2240.0), 1 / (2 * 333.3), 1 / (2 * 40.0)}) {
    const Demodulation d = demodulated(sampled(signal, p, even_times(p, step)), p);
    EXPECT_NEAR(d.storage, 1000, 1e-9);
    EXPECT_NEAR(d.loss, 200, 1e-9);
    EXPECT_NEAR(d.in_phase, 200, 1e-9);
    EXPECT_NEAR(d.out_of_phase, 40, 1e-9);
    EXPECT_NEAR(d.third_amplitude, 7, 1e-10);
    EXPECT_NEAR(d.third_phase, 0.6, 1e-10);
    EXPECT_NEAR(d.drift, 10, 1e-9);
    EXPECT_NEAR(d.offset, 110, 1e-9);
    EXPECT_NEAR(d.storage_error, 0, 1e-8);
    EXPECT_NEAR(d.loss_error, 0, 1e-8);
  }
}

TEST(Demodulate, AcceptsUnevenSamples) {
  const Protocol p{2, 0.2, 2, 3, 1};
  const Signal signal{1000, 200, 100, 10, 7, 0.6};
  RandomStream draw(1, Purpose::test);
  std::vector<double> times;
  for (double t = 0; t < 3; t += 0.004 * draw.uniform(0.1, 1)) times.push_back(t);
  const Demodulation d = demodulated(sampled(signal, p, times), p);
  EXPECT_NEAR(d.storage, 1000, 1e-8);
  EXPECT_NEAR(d.loss, 200, 1e-8);
  EXPECT_NEAR(d.third_amplitude, 7, 1e-9);
}

TEST(Demodulate, HigherHarmonicsOfUnevenSamplesFadeWithTheirNumber) {
  // A fifth harmonic is not in the fit: even samples are blind to it, uneven ones to second order.
  const Protocol p{1, 0.2, 0, 3, 0};
  const auto error = [&](int n) {
    Series s;
    RandomStream draw(1, Purpose::test);
    for (int i = 0; i < 3 * n; ++i) {
      const double t = (i + draw.uniform(0, 0.8)) / n;
      s.time.push_back(t);
      s.stress.push_back(stress_of({}, p, t) + 10 * std::sin(5 * two_pi * t));
    }
    return std::abs(demodulated(s, p).storage - 1000);
  };
  EXPECT_LT(error(100), 0.5);
  EXPECT_LT(error(1000), 0.03 * error(100));
  EXPECT_LT(error(10000), 0.03 * error(1000));
}

TEST(Demodulate, ConstantStressGivesNothing) {
  for (const double pre : {0.0, 2.0}) {
    const Protocol p{3963.3, 0.2, pre, 3, pre};
    std::vector<double> times = even_times(p, 1 / (3963.3 * 2240));
    const std::vector<double> stress(times.size(), 1170);
    const Demodulation d = demodulate(times, stress, p);
    EXPECT_NEAR(d.storage, 0, 1e-9);
    EXPECT_NEAR(d.loss, 0, 1e-9);
    EXPECT_NEAR(d.third_amplitude, 0, 1e-9);
  }
}

TEST(Demodulate, ErrorIsTheScatterOfTheCycles) {
  const Protocol p{1, 0.2, 1, 4, 1};
  Series s = sampled({}, p, even_times(p, 1e-3));
  // The three measured cycles have G' = 1000, 1030, 1060: standard error 30/sqrt(3).
  for (std::size_t i = 0; i < s.time.size(); ++i)
    if (s.time[i] > 1.9999 && s.time[i] < 4.9999)
      s.stress[i] += 30 * std::floor(s.time[i] - 2 + 1e-9) * p.amplitude * std::sin(two_pi * s.time[i]);
  const Demodulation d = demodulated(s, p);
  EXPECT_NEAR(d.storage, 1030, 1e-9);
  EXPECT_NEAR(d.storage_error, 30 / std::sqrt(3.0), 1e-9);
  EXPECT_NEAR(d.loss_error, 0, 1e-9);
}

TEST(Demodulate, FewPeriodsAndMissingRests) {
  for (const Protocol p : {Protocol{2, 0.2, 2, 1, 1}, Protocol{2, 0.2, 0, 3, 0}, Protocol{2, 0.2, 0, 1, 0},
                           Protocol{2, 0.2, 1, 2.5, 0}, Protocol{2, 0.2, 0, 2, 1}, Protocol{2, 0.2, 0, 0.5, 0}}) {
    const Demodulation d = demodulated(sampled({}, p, even_times(p, 1e-3)), p);
    EXPECT_NEAR(d.storage, 1000, 1e-9) << p.pre << " " << p.periods << " " << p.post;
    EXPECT_NEAR(d.loss, 200, 1e-9);
    EXPECT_EQ(d.storage_error < 0, p.periods < 3);
    EXPECT_NEAR(d.drift, 0, 1e-9);
  }
}

TEST(Demodulate, RejectsWhatIsNoSeries) {
  const Protocol p{1, 0.2, 0, 1, 0};
  const std::vector<double> times{0, 0.1, 0.2, 0.3}, stress{1, 2, 3, 4}, twice{0, 0.1, 0.1, 0.3};
  EXPECT_THROW(demodulate(times, std::span(stress).first(3), p), Error);
  EXPECT_THROW(demodulate(twice, stress, p), Error);
  EXPECT_THROW(demodulate(times, stress, p), Error);  // four samples, five unknowns
  EXPECT_THROW(demodulate(times, stress, Protocol{0, 0.2, 0, 1, 0}), Error);
  EXPECT_THROW(demodulate({}, {}, p), Error);
}

}  // namespace
}  // namespace supple
