/// Pressure against packing fraction over ensembles of packings [MacKeith 2025, figure 9.13].
/// jamming_onset CASES OUT reads CASES/*.toml, writes OUT/jamming_onset.png and prints the tables of the
/// README; each packing is kept in OUT/packings, and what is there is not made again. jamming_onset CASES OUT
/// --collect makes no packings. jamming_onset CASES --check looks at smooth discs alone, and fails if they
/// jam where or as they should not.
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <string>
#include <thread>

#include "pressure_curve.hpp"
#include "supple/draw/chart/pressure_plot.hpp"
#include "supple/io/text/case_file.hpp"

namespace {

using namespace supple;

constexpr int disc_packings = 100, rough_packings = 32, shell_packings = 32, scan_packings = 9;
constexpr double lowest_excess = 0.9e-4, highest_excess = 0.03;
/// Excesses of a fit, with room for rounding.
struct Range {
  double low, high;
};
constexpr Range near{2.4e-4, 4.1e-3}, middle{0.9e-3, 0.0105}, far{2.9e-3, 0.0305};
constexpr const char* heading =
    "| | N | packings | first jam | mean onset | zero of the line | slope | exponent, 0.0003-0.004 | "
    "0.001-0.01 | "
    "0.003-0.03 | "
    "unconverged |\n|---|---|---|---|---|---|---|---|---|---|---|\n";

struct Estimate {
  double value = 0, error = 0;
};

Estimate mean_of(const std::vector<double>& x) {
  double sum = 0, squares = 0;
  for (const double v : x) sum += v;
  const double n = static_cast<double>(x.size()), mean = sum / n;
  for (const double v : x) squares += (v - mean) * (v - mean);
  return {mean, std::sqrt(squares / (n * (n - 1)))};
}

struct Line {
  double slope = 0, constant = 0;
};

Line fit_line(const std::vector<double>& x, const std::vector<double>& y) {
  const Estimate mx = mean_of(x), my = mean_of(y);
  double xx = 0, xy = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    xx += (x[k] - mx.value) * (x[k] - mx.value);
    xy += (x[k] - mx.value) * (y[k] - my.value);
  }
  return {xy / xx, my.value - xy / xx * mx.value};
}

/// Curves of many seeds and what follows from their mean.
class Ensemble {
 public:
  /// One thread for each processor: packings are independent.
  Ensemble(std::string name, const Store& store, const Case& c, int seeds, double highest, Area area,
           Protocol protocol)
      : name_(std::move(name)), curves_(static_cast<std::size_t>(seeds)) {
    std::atomic<int> next{0};
    {
      std::vector<std::jthread> workers;
      for (unsigned w = 0; w < std::max(1u, std::thread::hardware_concurrency()); ++w)
        workers.emplace_back([&] {
          for (int k = next++; k < seeds; k = next++)
            curves_[static_cast<std::size_t>(k)] = store.get(name_, c, k + 1, highest, area, protocol);
        });
    }
    std::erase_if(curves_, [&](const PressureCurve& curve) {
      if (!curve.failure.empty()) fmt::print(stderr, "{}: {}\n", name_, curve.failure);
      return !curve.failure.empty();
    });
    extrapolate_onsets();
  }

  std::size_t size() const { return curves_.size(); }
  const std::string& name() const { return name_; }
  Estimate onset() const { return mean(&PressureCurve::onset); }
  Estimate first() const { return mean(&PressureCurve::first); }
  long unconverged() const {
    long sum = 0;
    for (const PressureCurve& c : curves_) sum += c.unconverged;
    return sum;
  }

  /// Zero of the straight line through the mean pressure over packing fractions at which every packing is
  /// jammed.
  double zero_over_fraction() const {
    double low = 0, high = 1;
    for (const PressureCurve& c : curves_) {
      low = std::max(low, c.onset);
      high = std::min(high, c.phi.back());
    }
    std::vector<double> x, y;
    for (int k = 0; k <= 20; ++k) {
      x.push_back(low + (high - low) * 0.999 * k / 20);
      y.push_back(0);
      for (const PressureCurve& c : curves_) y.back() += c.at(x.back()) / static_cast<double>(size());
    }
    const Line line = fit_line(x, y);
    return -line.constant / line.slope;
  }
  /// Zero of the straight line through the mean pressure against mean excess near the onset, as a packing
  /// fraction.
  Estimate zero() const {
    return jackknife([this](std::size_t without) {
      const auto [x, y] = scaled(near, without);
      const Line line = fit_line(x, y);
      return mean_onset(without) - line.constant / line.slope;
    });
  }
  Estimate slope() const {
    return jackknife([this](std::size_t without) {
      const auto [x, y] = scaled(near, without);
      return fit_line(x, y).slope;
    });
  }
  /// Slope of log (mean P) against log (mean excess over the onset of the same packing).
  Estimate exponent(const Range& range) const {
    return jackknife([&](std::size_t without) {
      auto [x, y] = scaled(range, without);
      for (double& v : x) v = std::log(v);
      for (double& v : y) v = std::log(v);
      return fit_line(x, y).slope;
    });
  }
  /// Mean excess over the own onset and mean pressure, for excesses in a range.
  std::pair<std::vector<double>, std::vector<double>> scaled(const Range& range,
                                                             std::size_t without = SIZE_MAX) const {
    std::vector<double> x, y;
    for (std::size_t k = 1; k < curves_.front().phi.size(); ++k) {
      double excess = 0, pressure = 0;
      for (std::size_t i = 0; i < size(); ++i) {
        if (i == without) continue;
        excess += (curves_[i].phi[k] - curves_[i].onset) / count(without);
        pressure += curves_[i].pressure[k] / count(without);
      }
      if (excess < range.low || excess > range.high) continue;
      x.push_back(excess);
      y.push_back(pressure);
    }
    return {x, y};
  }

 private:
  double count(std::size_t without) const { return static_cast<double>(size() - (without < size())); }
  double mean_onset(std::size_t without) const {
    double sum = 0;
    for (std::size_t i = 0; i < size(); ++i)
      if (i != without) sum += curves_[i].onset;
    return sum / count(without);
  }
  Estimate mean(double PressureCurve::*member) const {
    std::vector<double> all;
    for (const PressureCurve& c : curves_) all.push_back(c.*member);
    return mean_of(all);
  }
  /// A value of all packings, and its error from the values of all but one.
  template <class Statistic>
  Estimate jackknife(const Statistic& statistic) const {
    std::vector<double> values;
    for (std::size_t i = 0; i < size(); ++i) values.push_back(statistic(i));
    return {statistic(SIZE_MAX), mean_of(values).error * static_cast<double>(size() - 1)};
  }

  /// A curve begins at a small pressure, which is taken back along the mean slope.
  void extrapolate_onsets() {
    double rise = 0, run = 0;
    for (const PressureCurve& c : curves_) {
      if (c.phi.size() < 2) return;
      rise += c.pressure[1] - c.pressure[0];
      run += c.phi[1] - c.phi[0];
    }
    for (PressureCurve& c : curves_) c.onset -= c.pressure[0] * run / rise;
  }

  std::string name_;
  std::vector<PressureCurve> curves_;
};

std::string show(const Estimate& e, int digits) {
  return fmt::format("{:.{}f} ± {:.{}f}", e.value, digits, e.error, digits);
}

void print_row(const Ensemble& e, int bodies) {
  fmt::print("| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", e.name(), bodies, e.size(),
             show(e.first(), 4), show(e.onset(), 4), show(e.zero(), 4), show(e.slope(), 3),
             show(e.exponent(near), 3), show(e.exponent(middle), 3), show(e.exponent(far), 3),
             e.unconverged());
  std::fflush(stdout);
}

/// The mean pressure over the mean excess of each packing over its own onset, added to the mean onset.
PressureSeries mean_curve(const Ensemble& e, const std::string& label, const PressureFit& line) {
  auto [excess, pressure] = e.scaled({0, 1});
  for (double& x : excess) x += e.onset().value;
  return {label, std::move(excess), std::move(pressure), line};
}

/// Mean onsets over diameter ratios, ascending.
struct Scan {
  std::vector<double> ratio;
  std::vector<Estimate> onset;

  /// The ratio at which the mean onset is `wanted`, between the two neighbours that enclose it; the error
  /// comes from theirs.
  Estimate ratio_at(double wanted) const {
    for (std::size_t k = 1; k < ratio.size(); ++k) {
      const Estimate &low = onset[k - 1], &high = onset[k];
      if ((low.value - wanted) * (high.value - wanted) > 0) continue;
      const double slope = (high.value - low.value) / (ratio[k] - ratio[k - 1]),
                   share = (wanted - low.value) / (high.value - low.value);
      return {ratio[k - 1] + share * (ratio[k] - ratio[k - 1]),
              std::hypot((1 - share) * low.error, share * high.error) / std::abs(slope)};
    }
    return {NAN, NAN};
  }
};

/// Ensembles of other diameter ratios, and at which of them the published onset lies.
void scan(const Store& store, Case c, const Ensemble& main, double published) {
  Scan all;
  fmt::print("\n| | σ/edge | packings | first jam | mean onset |\n|---|---|---|---|---|\n");
  const auto add = [&](const Ensemble& e) {
    if (e.size() < 2) return;
    all.ratio.push_back(c.bodies.diameter_ratio);
    all.onset.push_back(e.onset());
    fmt::print("| {} | {} | {} | {} | {} |\n", main.name(), c.bodies.diameter_ratio, e.size(),
               show(e.first(), 4), show(e.onset(), 4));
    std::fflush(stdout);
  };
  for (const double ratio : {0.9, 1.0, 1.1, 1.25, 1.5, 2.0}) {
    c.bodies.diameter_ratio = ratio;
    if (ratio == 1) add(main);
    else
      add({fmt::format("{}-{}", main.name(), ratio), store, c, scan_packings, 0.01, Area::covered,
           Protocol::steps});
  }
  fmt::print("\n{} jam at the published {} at σ/edge = {}\n\n", main.name(), published,
             show(all.ratio_at(published), 2));
}

/// The same ensemble by the search along the packing fraction, which never comes far above the onset.
void compare_searches(const Store& store, Case c, const Ensemble& main) {
  c.jamming.search = "root";
  const Ensemble root(main.name() + "-root", store, c, disc_packings, highest_excess, Area::sum,
                      Protocol::search);
  if (root.size() >= 2) print_row(root, c.bodies.count);
  fmt::print("\n");
}

/// One thing changed in a case.
struct Variation {
  const char *family, *name;
  int packings;
  void (*change)(Case&);
};
constexpr Variation variations[] = {
    {"rough_discs", "rough_discs, N = 64", 10, [](Case& c) { c.bodies.count = 64; }},
    {"rough_discs", "rough_discs, from 0.6 by the chapter's steps of 0.001", 10,
     [](Case& c) {
       c.jamming.packing_fraction = 0.6;
       c.jamming.step = 0.001;
     }},
    {"shells", "shells, N = 128", 9, [](Case& c) { c.bodies.count = 128; }},
    {"shells", "shells, k_c = 0.003: nearly rigid", 9, [](Case& c) { c.contact.k_c = 0.003; }}};

void vary(const Store& store, const std::string& cases) {
  fmt::print("| | packings | first jam | mean onset |\n|---|---|---|---|\n");
  int number = 0;
  for (const Variation& v : variations) {
    Case c = read_case(fmt::format("{}/{}.toml", cases, v.family));
    v.change(c);
    const Ensemble e(fmt::format("{}-varied-{}", v.family, ++number), store, c, v.packings, 0.01,
                     Area::covered, Protocol::steps);
    if (e.size() < 2) continue;
    fmt::print("| {} | {} | {} | {} |\n", v.name, e.size(), show(e.first(), 4), show(e.onset(), 4));
    std::fflush(stdout);
  }
}

int run(const std::string& cases, const std::string& out, Store::Missing missing) {
  const Store store(out + "/packings", missing);
  std::vector<PressureSeries> fractions, scaled;
  const auto study = [&](const std::string& name, const std::string& label, int seeds, Area area,
                         Protocol protocol, double published) {
    const Case c = read_case(fmt::format("{}/{}.toml", cases, name));
    const Ensemble e(name, store, c, seeds, highest_excess, area, protocol);
    if (e.size() < 2) return;
    fmt::print("{}", heading);
    print_row(e, c.bodies.count);
    fractions.push_back(mean_curve(e, label, {e.zero().value, e.slope().value}));
    scaled.push_back(mean_curve(e, label, {e.onset().value, e.slope().value}));
    if (protocol == Protocol::steps) scan(store, c, e, published);
    else compare_searches(store, c, e);
  };
  study("discs", "smooth discs, P σ²/k_c", disc_packings, Area::sum, Protocol::search, 0.836);
  study("rough_discs", "rough discs, P σ²/k_c", rough_packings, Area::covered, Protocol::steps, 0.79);
  study("shells", "shells, P/(k_a a0)", shell_packings, Area::covered, Protocol::steps, 0.783);
  vary(store, cases);
  draw_pressure_plot(out + "/jamming_onset.png", fractions);
  draw_pressure_plot(out + "/scaling.png", scaled, {.axes = PressureAxes::log_excess});
  return 0;
}

/// Smooth discs jam where they jam in every program, and their pressure grows in proportion.
int check(const std::string& cases) {
  const Case c = read_case(cases + "/discs.toml");
  const Ensemble e("discs", Store("", Store::Missing::make), c, disc_packings, highest_excess, Area::sum,
                   Protocol::search);
  if (e.size() < 2) return 1;
  fmt::print("{}", heading);
  print_row(e, c.bodies.count);
  const double exponent = e.exponent({lowest_excess, highest_excess}).value, zero = e.zero_over_fraction();
  const bool right =
      e.size() == disc_packings && std::abs(zero - 0.836) < 0.004 && std::abs(exponent - 1) < 0.05;
  fmt::print("line over packing fraction: zero {:.4f}; exponent {:.3f}; {}\n", zero, exponent,
             right ? "as published" : "NOT as published: onset 0.836 +- 0.004, exponent 1 +- 0.05");
  return right ? 0 : 1;
}

}  // namespace

int main(int count, char** words) {
  try {
    const std::vector<std::string> word(words + 1, words + count);
    if (word.size() == 2 && word[1] == "--check") return check(word[0]);
    if (word.size() == 2) return run(word[0], word[1], Store::Missing::make);
    if (word.size() == 3 && word[2] == "--collect") return run(word[0], word[1], Store::Missing::leave_out);
    fmt::print(stderr, "usage: jamming_onset CASES OUT [--collect] | CASES --check\n");
    return 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "jamming_onset: {}\n", error.what());
    return 1;
  }
}
