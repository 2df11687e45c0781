/// G' and G'' of crosslinked, frictional, deformable particles against the strain amplitude.
/// deformable_gel CASE OUT [SEEDS] writes OUT/deformable_gel.png and prints the table of the README.
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <iterator>

#include "supple/draw/chart/chart.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/io/text/case_file.hpp"

namespace {

using namespace supple;

constexpr double amplitudes[] = {0.005, 0.02, 0.05, 0.1, 0.2};

struct Condition {
  const char* name;
  double edges;  ///< k_l of the shells, times that of the case
  bool links;
  Color color;
};
constexpr Condition conditions[] = {{"stiff, linked", 1, true, hex(0x1B4F82)},
                                    {"stiff, free", 1, false, hex(0x6BA3D6)},
                                    {"soft, linked", 0.1, true, hex(0xAA3311)},
                                    {"soft, free", 0.1, false, hex(0xE59A77)}};

/// Mean over seeds and its standard error.
struct Mean {
  double value = 0, error = 0;
};
Mean mean(const std::vector<double>& x) {
  Mean m;
  const auto n = static_cast<double>(x.size());
  for (const double v : x) m.value += v / n;
  for (const double v : x) m.error += (v - m.value) * (v - m.value) / (n * (n - 1));
  m.error = std::sqrt(m.error);
  return m;
}

struct Point {
  Mean storage, loss, residual;
};

/// All seeds of one condition at one amplitude.
Point measure(Case c, const Condition& condition, double amplitude, int seeds) {
  c.bodies.k_l *= condition.edges;
  c.given.insert("bodies.k_l");
  c.particles.permanent_links = condition.links;
  c.shear.amplitude = amplitude;
  std::vector<double> storage, loss, residual;
  for (int seed = 1; seed <= seeds; ++seed) {
    c.general.seed = seed;
    MemoryRecorder r;
    supple::run(c, nullptr, r);
    for (const std::string& warning : r.warnings) fmt::print(stderr, "{}: {}\n", condition.name, warning);
    storage.push_back(r.get("results", "storage_modulus_total"));
    loss.push_back(r.get("results", "loss_modulus_total"));
    residual.push_back(r.get("results", "energy_residual"));
  }
  return {mean(storage), mean(loss), mean(residual)};
}

ChartSeries series_of(const Condition& condition, const std::vector<Point>& points, Mean Point::*which) {
  ChartSeries s;
  s.label = condition.name;
  s.color = condition.color;
  for (std::size_t k = 0; k < points.size(); ++k) {
    s.x.push_back(amplitudes[k]);
    s.y.push_back((points[k].*which).value);
    s.error.push_back((points[k].*which).error);
  }
  return s;
}

int run(const std::string& path, const std::string& out, int seeds) {
  Case c = read_case(path);
  resolve_family(c);
  fmt::print("| particles | A | G' [k_a a0] | G'' [k_a a0] | energy residual |\n|---|---|---|---|---|\n");
  ChartPanel storage{{"Strain amplitude", ""}, {"G\u2032", "k_a a0"}, {}},
      loss{{"Strain amplitude", ""}, {"G\u2033", "k_a a0"}, {}};
  for (ChartPanel* panel : {&storage, &loss}) {
    panel->x.spacing = Spacing::logarithmic;
    panel->x.range = {0.8 * amplitudes[0], 1.25 * amplitudes[std::size(amplitudes) - 1]};
    panel->y.range = {0, 0.1};
  }
  for (const Condition& condition : conditions) {
    std::vector<Point> points;
    for (const double a : amplitudes) {
      const Point p = measure(c, condition, a, seeds);
      points.push_back(p);
      fmt::print("| {} | {} | {:.4f} ± {:.4f} | {:.4f} ± {:.4f} | {:.1e} |\n", condition.name, a,
                 p.storage.value, p.storage.error, p.loss.value, p.loss.error, p.residual.value);
      std::fflush(stdout);
    }
    storage.series.push_back(series_of(condition, points, &Point::storage));
    loss.series.push_back(series_of(condition, points, &Point::loss));
  }
  draw_chart(out + "/deformable_gel.png", {{{{storage}, 1}, {{loss}, 1}}});
  return 0;
}

}  // namespace

int main(int count, char** words) {
  try {
    if (count == 3 || count == 4) return run(words[1], words[2], count == 4 ? std::atoi(words[3]) : 5);
    fmt::print(stderr, "usage: deformable_gel CASE OUT [SEEDS]\n");
    return 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "deformable_gel: {}\n", error.what());
    return 1;
  }
}
