/// Shape parameters of single triangulated particles at rest: relaxed_surfaces FOLDER writes
/// FOLDER/relaxed_surfaces.png and prints the tables of the README.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "supple/build/surfaces.hpp"
#include "supple/core/error.hpp"
#include "supple/draw/chart/chart.hpp"
#include "supple/experiment/packing.hpp"
#include "supple/experiment/random_surfaces.hpp"

namespace supple {
namespace {

/// A particle without forces on it.
struct Rest {
  double shape_parameter = 0, volume = 0, energy = 0;  ///< volume: over v0; energy [k_v v0^2]
  bool converged = false;
};

double shape_parameter(const TriangleMesh& mesh) {
  const std::vector<double> areas = face_areas(mesh);
  return surface_shape_parameter(std::accumulate(areas.begin(), areas.end(), 0.0), enclosed_volume(mesh));
}

/// Of many vertices by FIRE: the volume couples all of them, so that a second-order step is of a full matrix.
Rest rest_of(int vertices, const ShapeSpec& shape) {
  Case c;
  c.general.experiment = "jamming";
  SurfaceSample one{.count = 1, .vertices = vertices, .large_fraction = 0, .shape = shape};
  one.packing_fraction = 0.02;
  Packing<3> packing = packing_of(c, random_surfaces(one));
  packing.minimise.method = vertices > 200 ? Minimiser::fire : Minimiser::automatic;
  const MinimiseReport report = relax(packing);
  Evaluation<3> out;
  packing.field->evaluate(packing.system, Detail::energies, out);
  const TriangleMesh mesh = mesh_of(packing.system, 0);
  return {shape_parameter(mesh), enclosed_volume(mesh), out.energy.stored(), report.converged};
}

/// k_v, k_a, k_b, gamma, relative, and A0; 0 leaves the triangles of the geodesic sphere at rest.
ShapeSpec spec(double k_a, double k_b, double gamma, double shape_parameter = 0) {
  ShapeSpec s{.area = 1, .length = k_a, .bending = k_b, .tension = gamma};
  s.shape_parameter = shape_parameter;
  return s;
}

/// A star marks what has not come to rest.
std::string mark(const Rest& r) { return r.converged ? "" : "*"; }

void print_least_areas() {
  constexpr std::array known{"1.0984", "1.0235", "1.0058", ""};
  constexpr std::array vertices{12, 42, 162, 642};
  fmt::print(
      "| vertices | geodesic sphere | known | under tension alone | vertices × (A - 1) "
      "|\n|---|---|---|---|---|\n");
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    const int n = vertices[k];
    const Rest r = rest_of(n, spec(0, 0, 0.3));
    fmt::print("| {} | {:.4f} | {} | {:.4f}{} | {:.3f} |\n", n, shape_parameter(geodesic_icosahedron(n)),
               known[k], r.shape_parameter, mark(r), n * (r.shape_parameter - 1));
  }
}

/// Particles at rest for each value of a stiffness, column by column for these numbers of vertices.
struct Rows {
  std::vector<double> values;
  std::vector<int> vertices;
  std::vector<std::vector<Rest>> columns = {};

  /// shape(value) makes a particle, cell(particle) is what is printed of it.
  template <class Shape, class Cell>
  void print(const char* name, const Shape& shape, const Cell& cell) {
    fmt::print("\n| {} |", name);
    for (const int n : vertices) fmt::print(" {} vertices |", n);
    fmt::print("\n|---|{}\n", fmt::join(std::vector<std::string>(vertices.size(), "---|"), ""));
    columns.resize(vertices.size());
    for (const double value : values) {
      fmt::print("| {} |", value);
      for (std::size_t k = 0; k < vertices.size(); ++k) {
        columns[k].push_back(rest_of(vertices[k], shape(value)));
        fmt::print(" {}{} |", cell(columns[k].back()), mark(columns[k].back()));
      }
      fmt::print("\n");
      std::fflush(stdout);
    }
  }

  ChartPanel panel(const ChartAxis& x, const ChartAxis& y, double Rest::*number) const {
    constexpr Color colors[] = {hex(0x1f77b4), hex(0xd62728), hex(0x2ca02c)};
    ChartPanel p{x, y, {}};
    for (std::size_t k = 0; k < columns.size(); ++k)
      for (const Marks marks : {Marks::line, Marks::points}) {
        ChartSeries s{marks == Marks::line ? fmt::format("{} vertices", vertices[k]) : "", values, {}};
        for (const Rest& r : columns[k]) s.y.push_back(r.*number);
        s.color = colors[k];
        s.marks = marks;
        if (marks == Marks::points) s.width = 2;
        p.series.push_back(std::move(s));
      }
    return p;
  }
};

void run(const std::string& folder) {
  print_least_areas();
  const auto and_volume = [](const Rest& r) {
    return fmt::format("{:.4f}, {:.4f}", r.shape_parameter, r.volume);
  };
  const auto and_energy = [](const Rest& r) {
    return fmt::format("{:.4f}, {:.0e}", r.shape_parameter, r.energy);
  };
  Rows droplets{{0.01, 0.03, 0.1, 0.2, 0.3, 0.5, 0.7}, {42, 162, 642}};
  droplets.print(
      "γ s0/(k_v v0²)", [](double gamma) { return spec(0.1, 0, gamma); }, and_volume);
  Rows shells{{1e-4, 3e-4, 1e-3, 2e-3, 3e-3, 4e-3, 5e-3, 7e-3, 1e-2, 3e-2, 0.1, 0.3, 1}, {42, 162}};
  shells.print(
      "k_b/k_a", [](double k_b) { return spec(1, k_b, 0, 1.1); }, and_volume);
  Rows floppy{{1.03, 1.04, 1.1, 1.2}, {42, 162, 642}};
  floppy.print(
      "A0", [](double a) { return spec(1, 0, 0, a); }, and_energy);
  Rows tense{{0.001, 0.01, 0.1, 1, 10}, {42, 162}};
  tense.print(
      "k_a/(k_v v0²)", [](double k_a) { return spec(k_a, 0, 0, 1); }, and_volume);

  const ChartAxis stiffness{"k_b/k_a", "", {}, Spacing::logarithmic}, tension{"γ s0/(k_v v0²)", ""};
  Chart chart;
  chart.columns = {{{shells.panel(stiffness, {"A of shells, A0 = 1.1", ""}, &Rest::shape_parameter)}},
                   {{droplets.panel(tension, {"v/v0 of droplets", ""}, &Rest::volume)}}};
  draw_chart(folder + "/relaxed_surfaces.png", chart);
}

}  // namespace
}  // namespace supple

int main(int count, char** words) {
  try {
    if (count == 2) return supple::run(words[1]), 0;
    fmt::print(stderr, "usage: relaxed_surfaces FOLDER\n");
    return 2;
  } catch (const std::exception& e) {
    fmt::print(stderr, "relaxed_surfaces: {}\n", e.what());
    return 1;
  }
}
