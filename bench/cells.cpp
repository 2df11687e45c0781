#include "bench/cells.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>

#include "bench/dense_discs.hpp"
#include "bench/machine.hpp"
#include "supple/experiment/body_motion.hpp"
#include "supple/experiment/packing.hpp"
#include "supple/solve/mover.hpp"

namespace supple::bench {
namespace {

constexpr int repeats = 3, discs = 4000;

/// Height over width: of 4000 discs, 300 leaves a cell six diameters wide.
double seconds_of_cell(double aspect_ratio) {
  DenseSpec spec;
  spec.discs = discs;
  spec.aspect_ratio = aspect_ratio;
  const System<2> start = dense_discs(spec);
  double best = std::numeric_limits<double>::infinity();
  for (int repeat = 0; repeat < repeats; ++repeat) {
    System<2> system = start;
    Mover dynamics = dense_dynamics();
    const double begin = cpu_seconds();
    for (int i = 0; i < 500; ++i) {
      dynamics.evaluate(system, {});
      dynamics.advance(system, {}, time_step, 1);
    }
    best = std::min(best, cpu_seconds() - begin);
  }
  return best;
}

/// 300 steps of 4000 discs at phi = 0.4, four of them larger.
double seconds_of_ratio(double ratio) {
  Case c;
  c.general.experiment = "dynamics";
  c.general.physics = "deformable";
  c.bodies.family = "disc";
  c.bodies.count = discs;
  c.bodies.large_fraction = 1e-3;
  c.bodies.size_ratio = ratio;
  resolve_family(c);
  Packing<2> start = make_packing(c, nullptr, 0.4);
  draw_velocities(start.system, 0.01, 1);
  const double dt = body_time_step(c, start, nullptr, conserving_step);
  double best = std::numeric_limits<double>::infinity();
  for (int repeat = 0; repeat < repeats; ++repeat) {
    System<2> system = start.system;
    Mover dynamics(*start.field);
    const double begin = cpu_seconds();
    for (int i = 0; i < 300; ++i) dynamics.advance(system, dt);
    best = std::min(best, cpu_seconds() - begin);
  }
  return best;
}

}  // namespace

void print_cells() {
  fmt::print(
      "\n{} dense frictional discs, 500 steps: a thin cell over a square one\n  {:>14}  {:>7}  {:>6}\n",
      discs, "height / width", "CPU s", "ratio");
  const double square = seconds_of_cell(1);
  for (const double aspect : {1.0, 10.0, 100.0, 300.0}) {
    const double seconds = aspect == 1 ? square : seconds_of_cell(aspect);
    fmt::print("  {:>14}  {:>7.3f}  {:>6.2f}\n", aspect, seconds, seconds / square);
  }
  fmt::print(
      "\n{} discs at phi = 0.4, 300 steps: four large ones among them over equal discs\n  {:>14}  {:>7}  "
      "{:>6}\n",
      discs, "large / small", "CPU s", "ratio");
  const double equal = seconds_of_ratio(1);
  for (const double ratio : {1.0, 10.0, 20.0, 50.0, 100.0}) {
    const double seconds = ratio == 1 ? equal : seconds_of_ratio(ratio);
    fmt::print("  {:>14}  {:>7.3f}  {:>6.2f}\n", ratio, seconds, seconds / equal);
  }
}

}  // namespace supple::bench
