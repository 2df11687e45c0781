#include "bench/packings.hpp"

#include <fmt/core.h>

#include "bench/machine.hpp"
#include "supple/experiment/jam.hpp"
#include "supple/model/polygons.hpp"

namespace supple::bench {

Case shell_case(int count, int vertices) {
  Case c;
  c.bodies.count = count;
  c.bodies.vertices = vertices;
  c.bodies.vertex_rule = "scaled";
  c.bodies.k_a = c.bodies.k_l = c.contact.k_c = 1;
  c.bodies.k_b = 0.01;
  c.jamming.pressure_kind = "contact";
  c.jamming.search = "pressure";
  c.jamming.window = 1;
  c.minimise.force_tolerance = 1e-9;
  return c;
}

namespace {

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
    Case c = shell_case(task.count, task.vertices);
    c.general.seed = seed;
    c.jamming.pressure = task.pressure;
    c.jamming.step = task.step;
    c.minimise.least_force = task.least_force;
    if (task.name == 'C') {
      c.bodies.k_b = 0;
      c.bodies.shape_parameter = 1.0055 * least_shape_parameter(task.vertices);
    }
    const double start = cpu_seconds();
    Packing<2> packing = make_packing(c, nullptr, task.packing_fraction);
    const JamProgress<2> end = jam(packing, jam_spec(c));
    const double seconds = cpu_seconds() - start;
    sum += seconds / seeds;
    fmt::print("  {:>4}  {:>4}  {:>12}  {:>11}  {:>7.4f}  {:>8.2e}  {:>7.2f}\n", task.name, seed,
               end.minimisations, end.evaluations, covered_fraction(packing), end.state.pressure, seconds);
  }
  fmt::print("  {:>4}  mean {:.2f} CPU s; published {} CPU s elsewhere: {:.0f} times", task.name, sum,
             task.published, task.published / sum);
  if (slower > 0) fmt::print("; {:.0f} times if it ran here", task.published * slower / sum);
  fmt::print("\n");
}

}  // namespace

void print_jamming(double slower) {
  fmt::print("\nJamming of shells: contact pressure in [P, 2P]\n");
  fmt::print("  {:>4}  {:>4}  {:>12}  {:>11}  {:>7}  {:>8}  {:>7}\n", "task", "seed", "minimisation",
             "evaluations", "phi", "P", "CPU s");
  for (const Task& task : tasks) print_task(task, slower);
}

}  // namespace supple::bench
