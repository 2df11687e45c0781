/// Figures 9.10 and 9.11 of MacKeith et al. (2025): force against compression of one particle between plates.
/// plate_compression OUT RUN.h5... writes OUT/plate_compression_2d.png and OUT/plate_compression_3d.png of
/// the runs in two and three dimensions and prints the table of the README.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "supple/core/error.hpp"
#include "supple/draw/chart/chart.hpp"
#include "supple/draw/chart/uncertainty.hpp"
#include "supple/io/run/run_file.hpp"
#include "supple/observe/power_law.hpp"
#include "supple/observe/squeezed_solids.hpp"

namespace {

using namespace supple;

/// The way down of a run.
struct Loading {
  std::string name, unit;
  int dimensions;
  std::vector<double> compression, force, nodes;

  explicit Loading(const RunFile& run)
      : name(std::filesystem::path(run.path()).stem()), dimensions(run.dimensions()) {
    for (const Column& c : run.columns("plates"))
      if (c.name == "force") unit = c.unit;
    const auto column = [&](const char* of) { return run.column("plates", of); };
    const std::vector<double> x = column("compression"), f = column("force"), upper = column("upper_nodes"),
                              lower = column("lower_nodes"), branch = column("branch");
    for (std::size_t k = 0; k < x.size(); ++k) {
      if (branch[k] < 0 || x[k] == 0) continue;
      compression.push_back(x[k]);
      force.push_back(f[k]);
      nodes.push_back(std::min(upper[k], lower[k]));
    }
  }
  /// The least compression from which on five nodes touch each plate; 0: never.
  double five_nodes_from() const {
    double from = 0;
    for (std::size_t k = nodes.size(); k-- > 0 && nodes[k] >= 5;) from = compression[k];
    return from;
  }
};

std::string exponent_from_five_nodes(const Loading& loading) {
  const double from = loading.five_nodes_from();
  if (from == 0)
    return fmt::format("never; {:g} at most", *std::max_element(loading.nodes.begin(), loading.nodes.end()));
  const auto law = fit_power_law(loading.compression, loading.force, from, loading.compression.back());
  return fmt::format("{:.3f}: {}", from,
                     law ? value_with_error(law->exponent, law->error) : "too few points");
}

void print_row(const RunFile& run, const Loading& loading) {
  const auto result = [&](const char* name) { return run.value("results", name); };
  double error = -1;
  std::string hysteresis = "no way back";
  for (const auto& value : run.values("results")) {
    if (value.name.name == "exponent") error = value.error;
    if (value.name.name == "hysteresis") hysteresis = fmt::format("{:.1e}", value.value);
  }
  fmt::print("| {} | {:.1e} to {:.1e} | {:g} | {} | {} | {:.3g} {} | {} | {:.2f} | {:.0f} |\n", loading.name,
             result("fit_from"), result("fit_to"), result("fit_nodes"),
             value_with_error(result("exponent"), error), exponent_from_five_nodes(loading),
             result("largest_force"), loading.unit, hysteresis, result("largest_rotation"),
             result("evaluations") / result("minimisations"));
}

ChartSeries guide(double slope, double x0, double x1, double y0, const std::vector<double>& dash) {
  return {fmt::format("slope {}", slope),
          {x0, x1},
          {y0, y0 * std::pow(x1 / x0, slope)},
          {},
          gray,
          Marks::line,
          0.5,
          dash};
}

/// The law of the theory of elasticity, for particles whose forces are in units of their own modulus.
ChartSeries theory(int dimensions) {
  ChartSeries line{dimensions == 2 ? "cylinder" : "ball", {}, {}, {}, ink, Marks::line, 0.9};
  constexpr double nu = 1.0 / 3;  // of a triangular network; the unit has 1 - nu^2, which a sheet has not
  for (int k = 0; k <= 60; ++k) {
    const double x = std::pow(10, -4 + k / 20.0);
    line.x.push_back(x);
    line.y.push_back(dimensions == 2 ? (1 - nu * nu) * cylinder_force(x) : ball_force(x));
  }
  return line;
}

void draw(const std::vector<Loading>& all, int dimensions, const std::string& path) {
  ChartPanel panel{{"Compression \u03b4/D", "", {}, Spacing::logarithmic},
                   {"Force, in units of the table", "", {}, Spacing::logarithmic},
                   {}};
  double low = 1, high = 0, least = 1;
  bool has_modulus = false;
  for (const Loading& loading : all) {
    if (loading.dimensions != dimensions) continue;
    ChartSeries points{loading.name, loading.compression, loading.force};
    points.color = line_palette[panel.series.size() % line_palette.size()];
    points.marks = Marks::points;
    points.width = 1.6;
    low = std::min(low, loading.compression.front());
    high = std::max(high, loading.compression.back());
    for (const double f : loading.force) least = f > 0 ? std::min(least, f) : least;
    has_modulus |= loading.unit.starts_with("E");
    panel.series.push_back(std::move(points));
  }
  if (panel.series.empty()) return;
  const std::array guides{guide(1, low, high, 0.4 * least, {}), guide(1.5, low, high, 0.04 * least, {3, 2})};
  panel.series.insert(panel.series.begin(), guides.begin(), guides.end());
  if (has_modulus) panel.series.push_back(theory(dimensions));
  draw_chart(path, {{{{panel}, 1}}, 300, 280});
}

}  // namespace

int main(int count, char** argument) try {
  if (count < 3) {
    fmt::print(stderr, "usage: plate_compression OUT RUN.h5...\n");
    return 2;
  }
  fmt::print(
      "| case | fit, delta/D | nodes at its beginning | exponent | five nodes from, exponent from there | "
      "largest force | hysteresis | turned [radian] | evaluations a step "
      "|\n|---|---|---|---|---|---|---|---|---|\n");
  std::vector<Loading> all;
  for (int k = 2; k < count; ++k) {
    const RunFile run(argument[k]);
    all.emplace_back(run);
    print_row(run, all.back());
  }
  for (const int dimensions : {2, 3})
    draw(all, dimensions, fmt::format("{}/plate_compression_{}d.png", argument[1], dimensions));
} catch (const supple::Error& e) {
  fmt::print(stderr, "plate_compression: {}\n", e.what());
  return e.exit_code();
}
