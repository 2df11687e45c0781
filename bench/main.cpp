/// The benchmarks of Supple, as tables. Nothing here passes or fails; docs/performance.md discusses the
/// numbers.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "bench/cells.hpp"
#include "bench/dense_discs.hpp"
#include "bench/lammps.hpp"
#include "bench/machine.hpp"
#include "bench/packings.hpp"
#include "bench/pictures.hpp"
#include "bench/shells.hpp"
#include "bench/solids.hpp"
#include "bench/surfaces.hpp"
#include "bench/threads.hpp"
#include "supple/core/version.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/observe/stress.hpp"

namespace supple::bench {
namespace {

// Measured elsewhere, on one core of an AMD EPYC (Zen 5, 3.7 GHz).
constexpr double package_seconds = 1000.6;  ///< particleShear 1.0.2, default run, CPython 3.11
constexpr double lammps_published = 73;     ///< ns per disc and step, LAMMPS 29 Sep 2021, these 10 000 discs

struct StepTime {
  double nanoseconds = std::numeric_limits<double>::infinity();  ///< per disc and step
  double contacts = 0, rows = 0, speed = 0;                      ///< at the end; rows per disc
  long builds = 0;
  /// Keeps the faster of two runs of the same steps.
  void keep_best(const StepTime& other) {
    if (other.nanoseconds < nanoseconds) *this = other;
  }
};

StepTime time_steps(System<2> system, int steps) {
  Mover dynamics = dense_dynamics();
  const double start = cpu_seconds();
  for (int i = 0; i < steps; ++i) {
    dynamics.evaluate(system, {});
    dynamics.advance(system, {}, time_step, 1);
  }
  const double discs = system.state.size();
  return {1e9 * (cpu_seconds() - start) / (steps * discs), contacts_per_disc(system),
          system.pairs.size() / discs, rms_speed(system), dynamics.forces().neighbors().builds()};
}

/// The everyday case: few discs, strongly compressed, all tensors at every step.
double time_with_tensors(int steps) {
  DenseSpec spec;
  spec.discs = 150;
  spec.packing_fraction = 1.5;
  System<2> system = dense_discs(spec);
  Mover dynamics = dense_dynamics();
  double kept = 0;
  const double start = cpu_seconds();
  for (int i = 0; i < steps; ++i) {
    kept += stress_tensors(system, dynamics.evaluate(system, {})).overall[0][0];
    dynamics.advance(system, {}, time_step, 1);
  }
  const double seconds = cpu_seconds() - start;
  return std::isfinite(kept) ? 1e9 * seconds / (steps * 150.0) : 0;
}

/// Seconds of the published package's default run in its own physics, and the rows of stress that it wrote.
void print_default_run(double machine) {
  double best = std::numeric_limits<double>::infinity();
  std::size_t rows = 0;
  for (int repeat = 0; repeat < 3; ++repeat) {
    Case c;
    c.general.physics = "particleshear-1.0.2";
    MemoryRecorder recorder;
    const double start = cpu_seconds();
    run(c, nullptr, recorder);
    best = std::min(best, cpu_seconds() - start);
    rows = recorder.tables.at("stress").rows.size();
  }
  fmt::print(
      "\nDefault oscillatory run, physics \"particleshear-1.0.2\": 150 discs, tensors at every step\n");
  fmt::print("  {} steps of protocol and the preparation: {:.3f} CPU s\n", rows, best);
  fmt::print("  particleShear 1.0.2 (CPython, measured elsewhere): {} CPU s, {:.0f} times as long",
             package_seconds, package_seconds / best);
  if (machine > 0) fmt::print("; {:.0f} times if it ran here", package_seconds * machine / best);
  fmt::print("\n");
}

void print_sizes() {
  fmt::print("\nDense frictional discs, phi = 0.84, history: CPU time per disc and step (best of repeats)\n");
  fmt::print("  {:>7}  {:>8}  {:>13}  {:>9}  {:>12}  {:>6}\n", "discs", "ns", "contacts/disc", "rows/disc",
             "steps/build", "to 1e3");
  double of_thousand = 0;
  for (const int discs : {150, 1000, 10000, 100000}) {
    DenseSpec spec;
    spec.discs = discs;
    const System<2> start = dense_discs(spec);
    const int steps = std::clamp(10'000'000 / discs, 100, 20000);
    StepTime best;
    for (int repeat = 0; repeat < 4; ++repeat) best.keep_best(time_steps(start, steps));
    if (discs == 1000) of_thousand = best.nanoseconds;
    fmt::print("  {:>7}  {:>8.1f}  {:>13.2f}  {:>9.2f}  {:>12.0f}  {:>6}\n", discs, best.nanoseconds,
               best.contacts, best.rows, static_cast<double>(steps) / best.builds,
               of_thousand > 0 ? fmt::format("{:.2f}", best.nanoseconds / of_thousand) : "");
  }
  fmt::print("  150 discs at phi = 1.5 with all stress tensors: {:.1f} ns\n", time_with_tensors(20000));
}

struct Comparison {
  StepTime supple;
  double lammps = 0;  ///< ns per disc and step; 0: not there
};

/// The two codes in turn, so that both meet the same disturbances.
Comparison print_comparison() {
  const int steps = 1000;
  const DenseSpec spec;
  const System<2> start = dense_discs(spec);
  const auto folder = std::filesystem::temp_directory_path() / "supple_bench";
  std::filesystem::create_directories(folder);
  write_lammps_case(folder.string(), start, dense_law(), time_step);

  Comparison best;
  LammpsRun peer;
  double peer_skin = 0;
  peer.seconds = std::numeric_limits<double>::infinity();
  for (int repeat = 0; repeat < 3; ++repeat) {
    for (const double skin : {0.1, 0.2, 0.3}) {
      best.supple.keep_best(time_steps(start, steps));
      if (!lammps_found()) continue;
      const LammpsRun run = run_lammps(folder.string(), steps, skin);
      if (run.seconds < peer.seconds) {
        peer = run;
        peer_skin = skin;
      }
    }
  }
  std::filesystem::remove_all(folder);

  fmt::print("\n{} discs, {} steps, in turn with LAMMPS gran/hooke/history (same discs, law and time step)\n",
             spec.discs, steps);
  fmt::print("  {:<8}  {:>6}  {:>13}  {:>6}  {:>12}\n", "", "ns", "contacts/disc", "builds", "final speed");
  fmt::print("  {:<8}  {:>6.1f}  {:>13.2f}  {:>6}  {:>12.6f}\n", "Supple", best.supple.nanoseconds,
             best.supple.contacts, best.supple.builds, best.supple.speed);
  if (!lammps_found()) {
    fmt::print("  LAMMPS is not installed (scripts/deps --bench)\n");
    return best;
  }
  best.lammps = 1e9 * peer.seconds / (steps * static_cast<double>(spec.discs));
  fmt::print("  {:<8}  {:>6.1f}  {:>13.2f}  {:>6}  {:>12.6f}   (best of three skins: {})\n", "LAMMPS",
             best.lammps, peer.contacts, peer.builds, peer.speed, peer_skin);
  fmt::print(
      "  Supple takes {:.2f} of the time. LAMMPS measured elsewhere: {} ns, so this machine is {:.2f} times "
      "slower "
      "now.\n",
      best.supple.nanoseconds / best.lammps, lammps_published, best.lammps / lammps_published);
  return best;
}

/// What the memory and the divider alone would take for the same step.
void print_limit(const StepTime& measured) {
  const double contacts = 0.5 * measured.contacts;  // pairs per disc
  const double row = 2 * sizeof(std::int32_t) + 2 * (sizeof(double) + sizeof(ContactState));
  const double site = 2 * sizeof(Vec2) + 5 * sizeof(double) + sizeof(Mobility)  // state, read and written
                      + sizeof(Vec2) + sizeof(double)                           // forces
                      + sizeof(Vec2);                                           // positions at the last build
  const double bytes = measured.rows * row + contacts * sizeof(PairForce<2>) + site;
  const double memory = bytes / bytes_per_nanosecond(static_cast<std::size_t>(10000 * bytes));
  const double divider = contacts * nanoseconds_of_divisions(6) + nanoseconds_of_divisions(2);
  fmt::print("\nLimits of this machine for 10 000 discs\n");
  fmt::print(
      "  memory   {:>6.1f} ns: {:.0f} bytes per disc and step, each met once, at the speed of a copy of that "
      "size\n",
      memory, bytes);
  fmt::print("  divider  {:>6.1f} ns: six divisions and roots a contact, two a disc, in vectors\n", divider);
  fmt::print("  measured {:>6.1f} ns: {:.1f} times the sum\n", measured.nanoseconds,
             measured.nanoseconds / (memory + divider));
}

}  // namespace
}  // namespace supple::bench

/// supple_bench [sizes | cells | peers | run | shells | surfaces | solids | jamming | pictures | threads]...:
/// these tables, or all.
int main(int argc, char** argv) {
  using namespace supple::bench;
  const std::vector<std::string> wanted(argv + 1, argv + argc);
  const auto wants = [&](const char* table) {
    return wanted.empty() || std::find(wanted.begin(), wanted.end(), table) != wanted.end();
  };
  fmt::print("Supple {} on one core of: {}\n", supple::version(), processor_name());
  Comparison comparison;
  if (wants("sizes")) print_sizes();
  if (wants("cells")) print_cells();
  if (wants("peers")) {
    comparison = print_comparison();
    print_limit(comparison.supple);
  }
  if (wants("run")) print_default_run(comparison.lammps / lammps_published);
  if (wants("shells")) {
    print_shells(comparison.lammps / lammps_published);
    print_shell_sizes();
  }
  if (wants("surfaces")) print_surfaces();
  if (wants("solids")) print_solids();
  if (wants("jamming")) print_jamming(comparison.lammps / lammps_published);
  if (wants("pictures")) print_pictures();
  if (wants("threads")) print_threads();
}
