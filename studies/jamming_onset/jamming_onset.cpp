/// Pressure against packing fraction over ensembles of packings [MacKeith 2025, figure 9.13].
/// jamming_onset CASES OUT reads CASES/*.toml, writes OUT/jamming_onset.png and prints the tables of the README; each packing
/// is kept in OUT/packings, and what is there is not made again. jamming_onset CASES OUT --collect makes no packings.
/// jamming_onset CASES --check looks at smooth discs alone, and fails if they jam where or as they should not.
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include "supple/core/error.hpp"
#include "supple/experiment/jam.hpp"
#include "supple/io/case_file.hpp"
#include "supple/io/pressure_plot.hpp"
#include "supple/model/bodies.hpp"

namespace {

using namespace supple;

constexpr int disc_packings = 100, rough_packings = 16, shell_packings = 16, scan_packings = 4;
constexpr double lowest_excess = 0.9e-4, highest_excess = 0.03;
constexpr const char* heading =
    "| | packings | mean onset | zero of the line | line over | slope | exponent, excess < 0.01 | excess > 0.001 | unconverged |\n"
    "|---|---|---|---|---|---|---|---|---|\n";

/// Which packing fraction counts: the sum of all areas, as is usual for discs, or what is covered.
enum class Area { sum, covered };

/// One packing from its onset upward.
struct Curve {
  double onset = 0;  ///< packing fraction at P = 1e-7
  std::vector<double> phi, pressure;
  long unconverged = 0;
  std::string failure;

  /// Pressure at a packing fraction: 0 below the onset, straight between two measured points.
  double at(double x) const {
    const auto above = std::upper_bound(phi.begin(), phi.end(), x);
    if (above == phi.begin()) return 0;
    if (above == phi.end()) return NAN;
    const auto k = static_cast<std::size_t>(above - phi.begin());
    const double share = (x - phi[k - 1]) / (phi[k] - phi[k - 1]);
    return pressure[k - 1] + share * (pressure[k] - pressure[k - 1]);
  }
};

double fraction(const Packing& packing, Area area) {
  return area == Area::sum ? packing.covered_area / packing.system.box.volume()
                           : packing_fraction(packing.system, packing.outline).total;
}

/// Packing fractions above the onset: logarithmic, then by steps that the packing follows.
std::vector<double> excesses(double highest) {
  std::vector<double> list;
  for (int k = 0; k < 5; ++k) list.push_back(1e-4 * std::pow(10, k / 4.0));
  for (double x = 2e-3; x < highest + 1e-6; x += 2e-3) list.push_back(x);
  return list;
}

Curve measure(Case c, int seed, double highest, Area area) {
  Curve curve;
  c.general.seed = seed;
  try {
    Packing packing = make_packing(c, nullptr, c.jamming.packing_fraction);
    curve.unconverged = jam(packing, jam_spec(c)).unconverged;
    const double onset = observe(packing).packing_fraction;
    curve.onset = fraction(packing, area);
    curve.phi.push_back(curve.onset);
    curve.pressure.push_back(observe(packing).pressure);
    for (const double excess : highest > 0 ? excesses(highest) : std::vector<double>{}) {
      const double factor = std::sqrt(observe(packing).packing_fraction / (onset + excess));
      scale_cell(packing.system, {factor, factor});
      packing.field->invalidate();
      curve.unconverged += !relax(packing).converged;
      curve.phi.push_back(fraction(packing, area));
      curve.pressure.push_back(observe(packing).pressure);
    }
  } catch (const Error& error) {
    curve.failure = error.what();
  }
  return curve;
}

/// Curves in files, so that a study that was interrupted goes on.
class Store {
 public:
  enum class Missing { make, leave_out };
  /// Nothing is kept where there is no folder.
  Store(std::string folder, Missing missing) : folder_(std::move(folder)), missing_(missing) {
    if (!folder_.empty()) std::filesystem::create_directories(folder_);
  }
  Curve get(const std::string& name, const Case& c, int seed, double highest, Area area) const {
    const std::string path = fmt::format("{}/{}-{}.txt", folder_, name, seed);
    if (std::ifstream in(path); !folder_.empty() && in) return read(in);
    if (missing_ == Missing::leave_out) return {0, {}, {}, 0, fmt::format("packing {} was not made", seed)};
    const Curve curve = measure(c, seed, highest, area);
    if (folder_.empty() || !curve.failure.empty()) return curve;
    std::string text = fmt::format("{}\n", curve.unconverged);
    for (std::size_t k = 0; k < curve.phi.size(); ++k) text += fmt::format("{} {}\n", curve.phi[k], curve.pressure[k]);
    std::ofstream(path) << text;
    return curve;
  }

 private:
  static Curve read(std::istream& in) {
    Curve curve;
    in >> curve.unconverged;
    for (double phi, pressure; in >> phi >> pressure;) {
      curve.phi.push_back(phi);
      curve.pressure.push_back(pressure);
    }
    curve.onset = curve.phi.at(0);
    return curve;
  }

  std::string folder_;
  Missing missing_;
};

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
  Ensemble(std::string name, const Store& store, const Case& c, int seeds, double highest, Area area)
      : name_(std::move(name)), curves_(static_cast<std::size_t>(seeds)) {
    std::atomic<int> next{0};
    {
      std::vector<std::jthread> workers;
      for (unsigned w = 0; w < std::max(1u, std::thread::hardware_concurrency()); ++w)
        workers.emplace_back([&] {
          for (int k = next++; k < seeds; k = next++)
            curves_[static_cast<std::size_t>(k)] = store.get(name_, c, k + 1, highest, area);
        });
    }
    std::erase_if(curves_, [&](const Curve& curve) {
      if (!curve.failure.empty()) fmt::print(stderr, "{}: {}\n", name_, curve.failure);
      return !curve.failure.empty();
    });
  }

  Estimate onset() const {
    std::vector<double> all;
    for (const Curve& c : curves_) all.push_back(c.onset);
    return mean_of(all);
  }
  std::size_t size() const { return curves_.size(); }
  const std::string& name() const { return name_; }
  long unconverged() const {
    long sum = 0;
    for (const Curve& c : curves_) sum += c.unconverged;
    return sum;
  }

  /// Packing fractions at which every packing is jammed and was measured; the last 0.01 where a few packings leave less than that.
  std::vector<double> grid() const {
    double low = 0, high = 1;
    for (const Curve& c : curves_) {
      low = std::max(low, c.onset);
      high = std::min(high, c.phi.back());
    }
    low = std::min(low, high - 0.01);
    std::vector<double> list;
    for (int k = 0; k <= 20; ++k) list.push_back(low + (high - low) * 0.999 * k / 20);
    return list;
  }
  /// Mean pressure at one packing fraction, without the packing `left_out`.
  double mean_pressure(double phi, std::size_t left_out = SIZE_MAX) const {
    double sum = 0;
    for (std::size_t k = 0; k < curves_.size(); ++k)
      if (k != left_out) sum += curves_[k].at(phi);
    return sum / static_cast<double>(curves_.size() - (left_out < curves_.size()));
  }
  /// The straight line through the mean pressure over the grid, and its zero with the jackknife's error over packings.
  PressureFit line() const { return line_without(SIZE_MAX); }
  double zero_error() const {
    std::vector<double> zeros;
    for (std::size_t k = 0; k < curves_.size(); ++k) zeros.push_back(line_without(k).onset);
    return mean_of(zeros).error * static_cast<double>(zeros.size() - 1);
  }
  /// Mean excess over the own onset and mean pressure, for excesses in a range.
  std::pair<std::vector<double>, std::vector<double>> scaled(double low, double high) const {
    std::vector<double> x, y;
    for (std::size_t k = 1; k < curves_.front().phi.size(); ++k) {
      double excess = 0, pressure = 0;
      for (const Curve& c : curves_) {
        excess += (c.phi[k] - c.onset) / static_cast<double>(size());
        pressure += c.pressure[k] / static_cast<double>(size());
      }
      if (excess < low || excess > high) continue;
      x.push_back(excess);
      y.push_back(pressure);
    }
    return {x, y};
  }
  /// Slope of log P against log (phi - onset of the same packing).
  double exponent(double low, double high) const {
    auto [x, y] = scaled(low, high);
    for (double& v : x) v = std::log(v);
    for (double& v : y) v = std::log(v);
    return fit_line(x, y).slope;
  }

 private:
  PressureFit line_without(std::size_t left_out) const {
    const std::vector<double> x = grid();
    std::vector<double> y;
    for (const double phi : x) y.push_back(mean_pressure(phi, left_out));
    const Line line = fit_line(x, y);
    return {-line.constant / line.slope, line.slope};
  }

  std::string name_;
  std::vector<Curve> curves_;
};

void print_row(const Ensemble& e) {
  const Estimate onset = e.onset();
  const PressureFit line = e.line();
  fmt::print("| {} | {} | {:.4f} ± {:.4f} | {:.4f} ± {:.4f} | {:.4f}-{:.4f} | {:.3f} | {:.3f} | {:.3f} | {} |\n", e.name(), e.size(),
             onset.value, onset.error, line.onset, e.zero_error(), e.grid().front(), e.grid().back(), line.slope,
             e.exponent(lowest_excess, 0.01), e.exponent(1e-3, highest_excess), e.unconverged());
  std::fflush(stdout);
}

/// The mean pressure from where the first packing jams to where the last was measured, and the line through its upper part.
PressureSeries over_fraction(const Ensemble& e) {
  PressureSeries s{e.name(), {}, {}, e.line()};
  const double low = e.onset().value - 0.012, high = e.grid().back();
  for (int k = 0; k <= 30; ++k) {
    s.packing_fraction.push_back(low + (high - low) * k / 30);
    s.pressure.push_back(e.mean_pressure(s.packing_fraction.back()));
  }
  return s;
}

/// The same against the excess over the onset of each packing.
PressureSeries over_excess(const Ensemble& e) {
  auto [excess, pressure] = e.scaled(0, 1);
  const double slope = pressure[excess.size() / 4] / excess[excess.size() / 4];
  return {e.name(), std::move(excess), std::move(pressure), PressureFit{0, slope}};
}

/// The diameter ratio at which the mean onset is `wanted`, between the two neighbours in the scan that enclose it.
double ratio_at(const std::vector<double>& ratio, const std::vector<double>& onset, double wanted) {
  for (std::size_t k = 1; k < ratio.size(); ++k)
    if ((onset[k - 1] - wanted) * (onset[k] - wanted) <= 0)
      return ratio[k - 1] + (wanted - onset[k - 1]) / (onset[k] - onset[k - 1]) * (ratio[k] - ratio[k - 1]);
  return NAN;
}

void scan(const std::string& name, const Store& store, Case c, double published) {
  std::vector<double> ratios, onsets;
  for (const double ratio : {0.25, 0.5, 0.75, 1.0, 1.25, 1.5}) {
    c.bodies.diameter_ratio = ratio;
    const Ensemble e(fmt::format("{}-{}", name, ratio), store, c, scan_packings, 0, Area::covered);
    if (e.size() < 2) continue;
    ratios.push_back(ratio);
    onsets.push_back(e.onset().value);
    fmt::print("| {} | {} | {} | {} | {:.4f} ± {:.4f} |\n", name, c.bodies.count, ratio, e.size(), e.onset().value, e.onset().error);
    std::fflush(stdout);
  }
  fmt::print("| {}, as published | {} | {:.2f} | | {} |\n", name, c.bodies.count, ratio_at(ratios, onsets, published), published);
}

void draw(const std::vector<Ensemble>& all, const std::string& out) {
  std::vector<PressureSeries> fractions, scaled;
  for (const Ensemble& e : all) {
    fractions.push_back(over_fraction(e));
    scaled.push_back(over_excess(e));
  }
  draw_pressure_plot(out + "/jamming_onset.png", fractions);
  draw_pressure_plot(out + "/scaling.png", scaled, {.axes = PressureAxes::log_excess});
}

int run(const std::string& cases, const std::string& out, Store::Missing missing) {
  const Store store(out + "/packings", missing);
  const auto read = [&](const char* name) { return read_case(fmt::format("{}/{}.toml", cases, name)); };
  const Case discs = read("discs"), rough = read("rough_discs"), shells = read("shells");
  fmt::print("{}", heading);
  std::vector<Ensemble> all;
  const auto add = [&](const char* name, const Case& c, int seeds, Area area) {
    all.emplace_back(name, store, c, seeds, highest_excess, area);
    if (all.back().size() < 2) all.pop_back();
    else print_row(all.back());
  };
  add("discs", discs, disc_packings, Area::sum);
  add("rough_discs", rough, rough_packings, Area::covered);
  add("shells", shells, shell_packings, Area::covered);
  draw(all, out);
  fmt::print("\n| | N | σ/edge | packings | mean onset |\n|---|---|---|---|---|\n");
  scan("rough_discs", store, rough, 0.79);
  scan("shells", store, shells, 0.783);
  return 0;
}

/// Smooth discs jam where they jam in every program, and their pressure grows in proportion.
int check(const std::string& cases) {
  const Ensemble e("discs", Store("", Store::Missing::make), read_case(cases + "/discs.toml"), disc_packings, highest_excess, Area::sum);
  if (e.size() < 2) return 1;
  fmt::print("{}", heading);
  print_row(e);
  const double exponent = e.exponent(lowest_excess, highest_excess);
  const bool right = e.size() == disc_packings && std::abs(e.line().onset - 0.836) < 0.004 && std::abs(exponent - 1) < 0.05;
  fmt::print("exponent {:.3f}; {}\n", exponent, right ? "as published" : "NOT as published: onset 0.836 +- 0.004, exponent 1 +- 0.05");
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
