/// Demodulation of signals whose moduli are known, and of those that the published package was given.
#include "supple/observe/demodulate.hpp"
#include "supple/compat/particleshear/demodulate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <vector>

#include "supple/core/error.hpp"
#include "supple/core/random.hpp"
#include "tests/paths.hpp"

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
    const Demodulation d = demodulate(s.time, s.stress, p, demodulate_as_published);
    const std::vector<double> expected = c["result"];
    EXPECT_NEAR(d.in_phase, expected[0], 1e-12 * expected[0]);
    EXPECT_NEAR(d.out_of_phase, expected[1], 1e-12 * expected[0]);
    EXPECT_NEAR(d.storage.value, expected[2], 1e-12 * expected[2]);
    EXPECT_NEAR(d.loss.value, expected[3], 1e-12 * expected[2]);
  }
}

TEST(Demodulate, PublishedSumsAreClosedAtBothEnds) {
  const Protocol p{1, 0.2, 1, 1, 1};
  const std::vector<double> times = even_times(p, 1.0 / 64);
  std::vector<double> stress(times.size(), 100);
  // The cosines of 65 samples sum up to 1, their squares to 33.
  EXPECT_NEAR(demodulate(times, stress, p, demodulate_as_published).loss.value, 100 / 33.0 / 0.2, 1e-9);
  stress[64] += 50;  // the start of shear is no part of the rest before it
  EXPECT_EQ(demodulate(times, stress, p, demodulate_as_published).drift, 0);
}

TEST(Demodulate, FindsEverythingThatASignalHolds) {
  const Protocol p{2, 0.2, 2, 3, 1};
  const Signal signal{1000, 200, 100, 10, 7, 0.6};
  for (const double step : {1 / (2 * 2240.0), 1 / (2 * 333.3), 1 / (2 * 40.0)}) {
    const Demodulation d = demodulated(sampled(signal, p, even_times(p, step)), p);
    EXPECT_NEAR(d.storage.value, 1000, 1e-9);
    EXPECT_NEAR(d.loss.value, 200, 1e-9);
    EXPECT_NEAR(d.in_phase, 200, 1e-9);
    EXPECT_NEAR(d.out_of_phase, 40, 1e-9);
    EXPECT_NEAR(d.third_amplitude, 7, 1e-10);
    EXPECT_NEAR(d.third_phase, 0.6, 1e-10);
    EXPECT_NEAR(d.drift, 10, 1e-9);
    EXPECT_NEAR(d.offset, 110, 1e-9);
    EXPECT_EQ(d.storage.error, -1);  // two cycles do not say how far they scatter
    EXPECT_EQ(d.loss.error, -1);
  }
}

TEST(Demodulate, AcceptsUnevenSamples) {
  const Protocol p{2, 0.2, 2, 3, 1};
  const Signal signal{1000, 200, 100, 10, 7, 0.6};
  RandomStream draw(1, Purpose::test);
  std::vector<double> times;
  for (double t = 0; t < 3; t += 0.004 * draw.uniform(0.1, 1)) times.push_back(t);
  const Demodulation d = demodulated(sampled(signal, p, times), p);
  EXPECT_NEAR(d.storage.value, 1000, 1e-8);
  EXPECT_NEAR(d.loss.value, 200, 1e-8);
  EXPECT_NEAR(d.third_amplitude, 7, 1e-9);
}

TEST(Demodulate, HigherHarmonicsOfUnevenSamplesFadeWithTheirNumber) {
  // A seventh harmonic is not in the fit: even samples are blind to it, uneven ones to second order.
  const Protocol p{1, 0.2, 0, 3, 0};
  const auto error = [&](int n) {
    Series s;
    RandomStream draw(1, Purpose::test);
    for (int i = 0; i < 3 * n; ++i) {
      const double t = (i + draw.uniform(0, 0.8)) / n;
      s.time.push_back(t);
      s.stress.push_back(stress_of({}, p, t) + 10 * std::sin(7 * two_pi * t));
    }
    return std::abs(demodulated(s, p).storage.value - 1000);
  };
  EXPECT_LT(error(100), 0.5);
  EXPECT_LT(error(1000), 0.03 * error(100));
  EXPECT_LT(error(10000), 0.5 * 0.03 * 0.03);
}

TEST(Demodulate, ConstantStressGivesNothing) {
  for (const double pre : {0.0, 2.0}) {
    const Protocol p{3963.3, 0.2, pre, 3, pre};
    std::vector<double> times = even_times(p, 1 / (3963.3 * 2240));
    const std::vector<double> stress(times.size(), 1170);
    const Demodulation d = demodulate(times, stress, p);
    EXPECT_NEAR(d.storage.value, 0, 1e-9);
    EXPECT_NEAR(d.loss.value, 0, 1e-9);
    EXPECT_NEAR(d.third_amplitude, 0, 1e-9);
  }
}

/// Adds `extra[k]` Pa to G' of the k-th of the cycles from the second on.
void change_storage(Series& s, const Protocol& p, const std::vector<double>& extra) {
  for (std::size_t i = 0; i < s.time.size(); ++i) {
    const double cycle = std::floor(s.time[i] * p.frequency - p.pre - 1 + 1e-9);
    if (cycle >= 0 && cycle < static_cast<double>(extra.size()))
      s.stress[i] += extra[static_cast<std::size_t>(cycle)] * p.amplitude *
                     std::sin(two_pi * (s.time[i] * p.frequency - p.pre));
  }
}

TEST(Demodulate, ErrorIsTheScatterOfTheCyclesWithStudentsFactor) {
  const Protocol p{1, 0.2, 1, 5, 1};
  Series s = sampled({}, p, even_times(p, 1e-3));
  change_storage(s, p, {5, -5, 5, -5});
  // Standard error sqrt(100/(4*3)), times t/2 for 0.9545 and three degrees of freedom; the line falls by 2
  // per cycle.
  const Demodulation d = demodulated(s, p);
  EXPECT_EQ(d.cycles, 4);
  EXPECT_NEAR(d.storage.value, 1000, 1e-9);
  EXPECT_NEAR(d.storage.change, -2, 1e-9);
  EXPECT_NEAR(d.storage.error, std::hypot(0.5 * 3.306822 * std::sqrt(100 / 12.0), 8), 1e-5);
  EXPECT_FALSE(d.storage.drifts());
  EXPECT_NEAR(d.loss.error, 0, 1e-9);
}

TEST(Demodulate, DriftOfAModulusFromCycleToCycleIsTold) {
  const Protocol p{1, 0.2, 1, 5, 1};
  Series s = sampled({}, p, even_times(p, 1e-3));
  change_storage(s, p, {0, 31, 60, 90});
  const Demodulation d = demodulated(s, p);
  EXPECT_NEAR(d.storage.change, (3 * 90 + 60 - 31) / 10.0, 1e-8);
  EXPECT_TRUE(d.storage.drifts());
  EXPECT_FALSE(d.loss.drifts());
  EXPECT_GT(d.storage.error, 4 * d.storage.change);  // what many more cycles give may lie that far off
}

TEST(Demodulate, NoErrorFromFewerThanThreeCycles) {
  for (const double periods : {1.0, 2.0, 3.0, 3.9, 4.0}) {
    const Protocol p{1, 0.2, 1, periods, 1};
    for (const Demodulator c : {fit_harmonics, demodulate_as_published}) {
      const Series s = sampled({}, p, even_times(p, 1e-3));
      const Demodulation d = demodulate(s.time, s.stress, p, c);
      EXPECT_EQ(d.storage.error >= 0, periods == 4) << periods;
      EXPECT_EQ(d.loss.error >= 0, periods == 4) << periods;
      EXPECT_EQ(d.storage.change_error >= 0, periods == 4) << periods;
    }
  }
}

TEST(Demodulate, AnyRestsAndAnyLengthGiveTheSame) {
  // The rest after is at the strain where the shear stopped: its stress is no drift.
  const Signal signal{1000, 200, 100, 10, 7, 0.6};
  for (const double pre : {0.0, 0.1, 0.5, 1.7, 2.0})
    for (const double periods : {1.0, 1.25, 2.0, 2.25, 2.5, 2.75, 3.0, 3.25, 4.5})
      for (const double post : {0.0, 0.3, 1.0}) {
        const Protocol p{2, 0.2, pre, periods, post};
        Series s = sampled(signal, p, even_times(p, 1 / (2 * 1315.0)));
        const double held =
            stress_of({1000, 200}, p, (pre + periods) / 2) - stress_of({0, 0}, p, (pre + periods) / 2);
        for (std::size_t i = 0; i < s.time.size(); ++i) {
          if (s.time[i] > (pre + periods) / 2) s.stress[i] += held;
          if (std::abs(s.time[i] - pre / 2) < 1e-9)
            s.stress[i] = stress_of(signal, p, pre / 2);  // times are sums
        }
        const Demodulation d = demodulated(s, p);
        EXPECT_NEAR(d.storage.value, 1000, 1e-8) << pre << " " << periods << " " << post;
        EXPECT_NEAR(d.loss.value, 200, 1e-8) << pre << " " << periods << " " << post;
        EXPECT_NEAR(d.drift, 10, 1e-8);
        EXPECT_NEAR(d.offset, 100 + 10 * pre / 2, 1e-8);
      }
}

TEST(Demodulate, DriftLeavesHysteresisAlone) {
  // Friction holds a stress of 11 Pa after the shear, and higher harmonics of both signs: neither is drift.
  const Protocol p{2, 0.2, 2, 4, 1};
  Series s = sampled({1000, 200}, p, even_times(p, 1 / (2 * 1315.0)));
  for (std::size_t i = 0; i < s.time.size(); ++i) {
    const double phase = two_pi * (s.time[i] * p.frequency - p.pre);
    if (s.time[i] > 3) s.stress[i] += 11;
    else if (s.time[i] >= 1)
      s.stress[i] += 20 * std::sin(2 * phase + 0.3) + 10 * std::cos(4 * phase) + 6 * std::sin(5 * phase);
  }
  const Demodulation d = demodulated(s, p);
  EXPECT_NEAR(d.storage.value, 1000, 1e-8);
  EXPECT_NEAR(d.loss.value, 200, 1e-8);
  EXPECT_NEAR(d.drift, 0, 1e-8);
}

TEST(Demodulate, EightSamplesInACycleAreEnough) {
  const Signal signal{1000, 200, 100, 10, 7, 0.6};
  for (const double periods : {1.0, 3.0}) {
    const Protocol p{2, 0.2, 1, periods, 0};
    const Demodulation d = demodulated(sampled(signal, p, even_times(p, 1 / 16.0)), p);
    EXPECT_NEAR(d.storage.value, 1000, 1e-8);
    EXPECT_NEAR(d.loss.value, 200, 1e-8);
    EXPECT_THROW(demodulated(sampled(signal, p, even_times(p, 1 / 14.0)), p), Error);
  }
}

TEST(Demodulate, FewPeriodsAndMissingRests) {
  for (const Protocol p : {Protocol{2, 0.2, 2, 1, 1}, Protocol{2, 0.2, 0, 3, 0}, Protocol{2, 0.2, 0, 1, 0},
                           Protocol{2, 0.2, 1, 2.5, 0}, Protocol{2, 0.2, 0, 2, 1}}) {
    const Demodulation d = demodulated(sampled({}, p, even_times(p, 1e-3)), p);
    EXPECT_NEAR(d.storage.value, 1000, 1e-9) << p.pre << " " << p.periods << " " << p.post;
    EXPECT_NEAR(d.loss.value, 200, 1e-9);
    EXPECT_NEAR(d.drift, 0, 1e-9);
  }
  const Protocol half{2, 0.2, 0, 0.5, 0};
  EXPECT_THROW(demodulated(sampled({}, half, even_times(half, 1e-3)), half), Error);
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
