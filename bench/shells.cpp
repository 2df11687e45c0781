#include "bench/shells.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "bench/machine.hpp"
#include "bench/packings.hpp"
#include "bench/time_per_vertex.hpp"
#include "supple/contact/rough_contacts.hpp"
#include "supple/experiment/packing.hpp"
#include "supple/force/polygon_shape.hpp"
#include "supple/model/bodies.hpp"
#include "supple/model/polygons.hpp"
#include "supple/solve/body_objective.hpp"
#include "supple/solve/fire.hpp"

namespace supple::bench {
namespace {

constexpr int vertices = 20;

/// The packing side by side with copies of itself, so that a large one costs no minimisation.
System<2> tiled(const System<2>& tile, int times) {
  System<2> system = tile;
  const auto append = [](auto& all, const auto& more) { all.insert(all.end(), more.begin(), more.end()); };
  Topology<2>& t = system.topology;
  for (int copy = 1; copy < times * times; ++copy) {
    const std::int32_t sites = system.state.size();
    const Vec2 shift{copy % times * tile.box.length[0], copy / times * tile.box.length[1]};
    const State<2>& s = tile.state;
    for (const Vec2& x : s.position) system.state.position.push_back(x + shift);
    append(system.state.velocity, s.velocity);
    append(system.state.mass, s.mass);
    append(system.state.radius, s.radius);
    append(system.state.angle, s.angle);
    append(system.state.inertia, s.inertia);
    append(system.state.spin, s.spin);
    append(system.state.mobility, s.mobility);
    append(system.shape.stiffness, tile.shape.stiffness);
    append(system.shape.rest_volume, tile.shape.rest_volume);
    append(system.shape.rest_facet, tile.shape.rest_facet);
    append(system.shape.rest_hinge, tile.shape.rest_hinge);
    for (const auto& f : tile.topology.facet) t.facet.push_back({f[0] + sites, f[1] + sites});
    for (const auto& h : tile.topology.hinge) t.hinge.push_back({h[0] + sites, h[1] + sites, h[2] + sites});
    for (std::vector<std::int32_t>* begin : {&t.begin, &t.facet_begin, &t.hinge_begin}) {
      const std::vector<std::int32_t>& of_tile = begin == &t.begin         ? tile.topology.begin
                                                 : begin == &t.facet_begin ? tile.topology.facet_begin
                                                                           : tile.topology.hinge_begin;
      const std::int32_t end = begin->back();
      for (std::size_t k = 1; k < of_tile.size(); ++k) begin->push_back(of_tile[k] + end);
    }
  }
  for (int d = 0; d < 2; ++d) system.box.length[d] *= times;
  system.pairs = {};
  return system;
}

/// Nanoseconds per vertex of an iteration of FIRE, evaluation included; from a copy of the packing.
double time_iteration(Packing<2> p) {
  BodyObjective<2> objective(p.system, *p.field, {0, 0});
  std::vector<double> x = objective.coordinates();
  MinimiseSpec spec = p.minimise;
  spec.max_evaluations = 300;
  double best = 1e300;
  for (int turn = 0; turn < 20; ++turn) {
    const double start = cpu_seconds();
    const MinimiseReport report = minimise(objective, x, spec, {});
    best = std::min(best, (cpu_seconds() - start) / static_cast<double>(report.evaluations));
  }
  return 1e9 * best / p.system.state.size();
}

void print_shells_of(int count, double packing_fraction, double slower) {
  Packing<2> p = compressed_shells(count, packing_fraction);
  System<2>& s = p.system;
  Evaluation<2> out;
  const auto [forces, energies, shape, contacts] =
      time_per_vertex<4>(s.state.size(), {[&] { p.field->evaluate(s, Detail::forces, out); },
                                          [&] { p.field->evaluate(s, Detail::energies, out); },
                                          [&] { PolygonShape().evaluate(s, Detail::forces, out); },
                                          [&] { p.field->bodies()->evaluate(s, Detail::forces, out); }});
  const double per_vertex = 1.0 / s.state.size();
  fmt::print(
      "  {:>6}  {:>4.2f}  {:>6.1f}  {:>9}  {:>8.1f}  {:>5.1f}  {:>8.1f}  {:>4.1f}  {:>4.1f}  {:>4.2f}  "
      "{:>8.2f}\n",
      count, packing_fraction, forces, slower > 0 ? fmt::format("{:.1f}", forces / slower) : "", energies,
      shape, contacts, forces - shape - contacts, time_iteration(p), per_vertex * s.pairs.size(),
      per_vertex * static_cast<double>(p.field->bodies()->records(s).size()));
}

/// Instructions on vectors of a shape evaluation (additions, multiplications and both in one) per vertex,
/// counted in the loops of force/polygon_shape.cpp, and per row of the pair table in those of
/// contact/rough_contacts.cpp.
constexpr double shape_operations = 71, row_operations = 28;

/// Bytes per vertex and row that an evaluation must meet: positions now and at the last build, rest lengths
/// and angles, radii, forces (set to zero, then twice read and written; torques set to zero); two sites and
/// the image of a row.
double bytes_per_vertex(double rows) {
  return 3 * sizeof(Vec2) + 3 * sizeof(double) + 5 * sizeof(Vec2) + sizeof(double) +
         rows * 3 * sizeof(std::int32_t);
}

}  // namespace

Packing<2> compressed_shells(int count, double packing_fraction) {
  Case c = shell_case(count, vertices);
  c.bodies.vertex_rule = "equal";
  Packing<2> p = make_packing(c, nullptr, 0.6);
  const double factor = std::sqrt(p.covered_area / p.system.box.volume() / packing_fraction);
  scale_cell(p.system, {factor, factor});
  p.field->invalidate();
  p.minimise.method = Minimiser::fire;
  p.minimise.max_evaluations = 300;
  relax(p);
  return p;
}

void print_shells(double slower) {
  fmt::print("\nShells of {} vertices: CPU ns per vertex and evaluation (best of repeats)\n", vertices);
  fmt::print("  {:>6}  {:>4}  {:>6}  {:>9}  {:>8}  {:>5}  {:>8}  {:>4}  {:>4}  {:>4}  {:>8}\n", "shells",
             "phi", "forces", "published", "energies", "shape", "contacts", "rest", "FIRE", "rows",
             "contacts");
  for (const double packing_fraction : {0.77, 0.85})
    for (const int count : {64, 1024}) print_shells_of(count, packing_fraction, slower);
  fmt::print(
      "  published: the forces, on the machine of the published figures by the ratio of LAMMPS. energies: "
      "with energies and virial.\n");
  fmt::print(
      "  rest: list check, zeroing. FIRE: an iteration with its evaluation. rows, contacts: per vertex.\n");
}

void print_shell_sizes() {
  fmt::print("\nShells of {} vertices at phi = 0.85: CPU ns per vertex and evaluation of forces\n", vertices);
  fmt::print("  {:>8}  {:>6}  {:>10}  {:>6}  {:>12}  {:>6}  {:>8}\n", "vertices", "forces", "arithmetic",
             "memory", "bytes/vertex", "build", "to 1e3");
  const Packing<2> five = compressed_shells(5, 0.85), fifty = compressed_shells(50, 0.85);
  double of_thousand = 0;
  for (const auto& [tile, times] :
       {std::pair{&five, 1}, {&fifty, 1}, {&fifty, 3}, {&fifty, 10}, {&fifty, 32}}) {
    System<2> system = tiled(tile->system, times);
    ForceField<2> field(RoughContacts<2>{tile->field->bodies()->laws()});
    field.terms().add(std::make_shared<PolygonShape>());
    Evaluation<2> out;
    const double start = cpu_seconds();
    field.evaluate(system, Detail::forces, out);
    const double build = 1e9 * (cpu_seconds() - start) / system.state.size();
    const auto [forces] =
        time_per_vertex<1>(system.state.size(), {[&] { field.evaluate(system, Detail::forces, out); }});
    const double rows = static_cast<double>(system.pairs.size()) / system.state.size(),
                 bytes = bytes_per_vertex(rows);
    const double arithmetic = nanoseconds_of_operations(shape_operations + rows * row_operations);
    const double memory = bytes / bytes_per_nanosecond(static_cast<std::size_t>(bytes * system.state.size()));
    if (tile == &fifty && times == 1) of_thousand = forces;
    fmt::print("  {:>8}  {:>6.1f}  {:>10.1f}  {:>6.1f}  {:>12.0f}  {:>6.0f}  {:>8}\n", system.state.size(),
               forces, arithmetic, memory, bytes, build,
               of_thousand > 0 ? fmt::format("{:.2f}", forces / of_thousand) : "");
  }
  fmt::print(
      "  arithmetic: {:.0f} additions and multiplications a vertex, {:.0f} a row, at the best rate of this "
      "machine;\n",
      shape_operations, row_operations);
  fmt::print(
      "  memory: these bytes at the speed of a copy of that size; build: of the neighbour list, with the "
      "first evaluation.\n");
}

}  // namespace supple::bench
