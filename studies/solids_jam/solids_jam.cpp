/// Pressure against packing fraction of elastic discs, shells and soft discs. solids_jam CASES OUT reads
/// CASES/*.toml, writes OUT/solids_jam.png and OUT/solids_jam_cell.png and prints the table of the README.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "supple/build/solid_bodies.hpp"
#include "supple/draw/chart/chart.hpp"
#include "supple/draw/page/snapshot.hpp"
#include "supple/draw/scene/frame_scene.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/io/text/case_file.hpp"

namespace {

using namespace supple;

constexpr int seeds = 5;

/// Points of all seeds: packing fraction over that of the onset, and pressure over the stiffness k of the
/// kind, in its own meaning.
struct Curve {
  std::vector<double> phi, excess, pressure;
};

struct Kind {
  std::string file, label;
  Color color;
  double per_unit;  ///< pressures of the run over those of the figure; 0: from the network
};

struct Row {
  std::vector<double> onset, slope, at_highest;
};

double mean(const std::vector<double>& x) {
  double sum = 0;
  for (const double v : x) sum += v;
  return sum / static_cast<double>(x.size());
}
double standard_error(const std::vector<double>& x) {
  double square = 0;
  for (const double v : x) square += (v - mean(x)) * (v - mean(x));
  const auto n = static_cast<double>(x.size());
  return std::sqrt(square / (n * (n - 1)));
}

std::string show(const std::vector<double>& x, int digits) {
  return fmt::format("{:.{}f} ± {:.{}f}", mean(x), digits, standard_error(x), digits);
}

/// Young's modulus of the first particle over the stiffness of its springs.
double modulus_over_spring(const System<2>& system) {
  return nominal_constants(system, 0)->young_modulus / system.solid.stiffness[0].bond;
}

void measure(Case c, const Kind& kind, int seed, const std::string& out, Curve& curve, Row& row) {
  c.general.seed = seed;
  MemoryRecorder recorder;
  run(c, nullptr, recorder);
  const auto& table = recorder.tables.at("packing");
  const std::vector<double> phi = table.column("packing_fraction"), pressure = table.column("pressure");
  const double unit = kind.per_unit > 0 ? kind.per_unit : modulus_over_spring(recorder.last_system);
  const double onset = recorder.get("results", "onset_compression");
  for (std::size_t k = 0; k < phi.size(); ++k) {
    curve.phi.push_back(phi[k]);
    curve.excess.push_back(phi[k] - onset);
    curve.pressure.push_back(unit * pressure[k]);
  }
  row.onset.push_back(onset);
  row.slope.push_back(unit * recorder.get("results", "slope_compression"));
  row.at_highest.push_back(phi.back());
  if (seed == 1 && kind.per_unit == 0)
    draw_snapshot(out + "/solids_jam_cell.png", scene_of(recorder.info, recorder.frames.back()),
                  {.title = fmt::format("P = {:.3f} k", curve.pressure.back())});
}

ChartSeries points(const Kind& kind, const std::vector<double>& x, const std::vector<double>& y) {
  return {kind.label, x, y, {}, kind.color, Marks::points, 1.8};
}

void study(const std::string& cases, const std::string& out) {
  const std::vector<Kind> kinds{{"networks", "elastic discs, P/k", hex(0xc04020), 0},
                                {"shells", "shells, P/(k_a a_0)", hex(0x2060a0), 1},
                                {"discs", "smooth discs, P sigma^2/k_c", hex(0x308040), 1}};
  ChartPanel linear{{"packing fraction", ""}, {"pressure", ""}, {}},
      logarithmic{{"excess over the onset", "", {}, Spacing::logarithmic},
                  {"pressure", "", {}, Spacing::logarithmic},
                  {}};
  fmt::print(
      "| particles | N | seeds | onset | slope dP/dphi | phi at the highest P "
      "|\n|---|---|---|---|---|---|\n");
  for (const Kind& kind : kinds) {
    Case c = read_case(cases + "/" + kind.file + ".toml");
    resolve_family(c);
    Curve curve;
    Row row;
    for (int seed = 1; seed <= seeds; ++seed) measure(c, kind, seed, out, curve, row);
    linear.series.push_back(points(kind, curve.phi, curve.pressure));
    logarithmic.series.push_back(points(kind, curve.excess, curve.pressure));
    logarithmic.series.back().label.clear();
    fmt::print("| {} | {} | {} | {} | {} | {} |\n", kind.label, c.bodies.count, seeds, show(row.onset, 4),
               show(row.slope, 3), show(row.at_highest, 4));
    std::fflush(stdout);
  }
  draw_chart(out + "/solids_jam.png", {{{{linear}}, {{logarithmic}}}, 504, 230});
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return fmt::print(stderr, "solids_jam CASES OUT\n"), 2;
  try {
    study(argv[1], argv[2]);
  } catch (const std::exception& e) {
    return fmt::print(stderr, "solids_jam: {}\n", e.what()), 1;
  }
}
