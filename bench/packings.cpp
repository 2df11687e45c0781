#include "bench/packings.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "bench/machine.hpp"
#include "supple/experiment/jam.hpp"
#include "supple/force/polygon_shape.hpp"
#include "supple/model/bodies.hpp"
#include "supple/model/polygons.hpp"

namespace supple::bench {
namespace {

/// Shells as the published tasks have them: all energies relative, large particles with more vertices.
Case shells(int count, int vertices) {
  Case c;
  c.bodies.count = count;
  c.bodies.vertices = vertices;
  c.bodies.vertex_rule = "scaled";
  c.bodies.k_a = c.bodies.k_l = c.contact.k_c = 1;
  c.bodies.k_b = 0.01;
  c.jamming.pressure_kind = "contact";
  c.jamming.window = 1;
  c.minimise.force_tolerance = 1e-9;
  return c;
}

/// Nanoseconds of a call per vertex, the fastest of several turns.
template <class Call>
double time_per_vertex(const System<2>& system, Call&& call) {
  const int calls = std::max(3, 2'000'000 / system.state.size());
  double best = 1e300;
  for (int turn = 0; turn < 5; ++turn) {
    const double start = cpu_seconds();
    for (int k = 0; k < calls; ++k) call();
    best = std::min(best, cpu_seconds() - start);
  }
  return 1e9 * best / (static_cast<double>(calls) * system.state.size());
}

void print_shells_of(int count, double packing_fraction) {
  Case c = shells(count, 20);
  c.bodies.vertex_rule = "equal";
  Packing p = make_packing(c, nullptr, 0.6);
  const double factor = std::sqrt(p.covered_area / p.system.box.volume() / packing_fraction);
  scale_cell(p.system, {factor, factor});
  p.field->invalidate();
  p.minimise.method = Minimiser::fire;
  p.minimise.max_evaluations = 300;  // no more than until overlaps are gone: the contacts are what they will be
  relax(p);
  Evaluation<2> out;
  const double all = time_per_vertex(p.system, [&] { p.field->evaluate(p.system, Detail::energies, out); });
  const double forces = time_per_vertex(p.system, [&] { p.field->evaluate(p.system, Detail::forces, out); });
  const double shape = time_per_vertex(p.system, [&] { PolygonShape().evaluate(p.system, Detail::forces, out); });
  const double contacts = time_per_vertex(p.system, [&] { p.field->bodies()->evaluate(p.system, Detail::forces, out); });
  fmt::print("  {:>7}  {:>9}  {:>5.2f}  {:>8.1f}  {:>13.1f}  {:>6.1f}  {:>8.1f}  {:>11.1f}\n", count, p.system.state.size(),
             packing_fraction, forces, all, shape, contacts, static_cast<double>(p.system.pairs.size()) / p.system.state.size());
}

struct Task {
  char name;
  int count, vertices;
  double pressure, least_force, packing_fraction, step, published;  ///< CPU seconds
};

/// The published program's conventions: k_a = k_l = k_c = 1; task C is floppy.
constexpr Task tasks[] = {{'A', 16, 10, 1e-7, 1e-12, 0.5, 0.005, 76.7},
                          {'B', 16, 20, 1e-6, 1e-11, 0.5, 0.005, 543.9},
                          {'C', 16, 10, 1e-7, 1e-12, 0.5, 0.005, 151.5},
                          {'E', 64, 20, 1e-6, 1e-10, 0.7, 0.01, 138.1}};

void print_task(const Task& task, double slower) {
  double sum = 0;
  constexpr int seeds = 3;
  for (int seed = 1; seed <= seeds; ++seed) {
    Case c = shells(task.count, task.vertices);
    c.general.seed = seed;
    c.jamming.pressure = task.pressure;
    c.jamming.step = task.step;
    c.minimise.least_force = task.least_force;
    if (task.name == 'C') {
      c.bodies.k_b = 0;
      c.bodies.shape_parameter = 1.0055 * least_shape_parameter(task.vertices);
    }
    const double start = cpu_seconds();
    Packing packing = make_packing(c, nullptr, task.packing_fraction);
    const JamProgress end = jam(packing, jam_spec(c));
    const double seconds = cpu_seconds() - start;
    sum += seconds / seeds;
    fmt::print("  {:>4}  {:>4}  {:>12}  {:>11}  {:>7.4f}  {:>8.2e}  {:>7.2f}\n", task.name, seed, end.minimisations, end.evaluations,
               end.state.packing_fraction, end.state.pressure, seconds);
  }
  fmt::print("  {:>4}  mean {:.2f} CPU s; published {} CPU s elsewhere: {:.0f} times", task.name, sum, task.published, task.published / sum);
  if (slower > 0) fmt::print("; {:.0f} times if it ran here", task.published * slower / sum);
  fmt::print("\n");
}

}  // namespace

void print_shells() {
  fmt::print("\nShells of 20 vertices: CPU ns per vertex and evaluation (best of repeats)\n");
  fmt::print("  {:>7}  {:>9}  {:>5}  {:>8}  {:>13}  {:>6}  {:>8}  {:>11}\n", "shells", "vertices", "phi", "forces", "with energies",
             "shape", "contacts", "rows/vertex");
  for (const double packing_fraction : {0.77, 0.85}) {
    print_shells_of(64, packing_fraction);
    print_shells_of(1024, packing_fraction);
  }
}

void print_jamming(double slower) {
  fmt::print("\nJamming of shells: contact pressure in [P, 2P]\n");
  fmt::print("  {:>4}  {:>4}  {:>12}  {:>11}  {:>7}  {:>8}  {:>7}\n", "task", "seed", "minimisation", "evaluations", "phi", "P", "CPU s");
  for (const Task& task : tasks) print_task(task, slower);
}

}  // namespace supple::bench
