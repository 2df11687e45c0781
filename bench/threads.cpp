#include "bench/threads.hpp"

#include <fmt/core.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <functional>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include "bench/dense_discs.hpp"
#include "bench/machine.hpp"
#include "bench/shells.hpp"
#include "supple/contact/rough_contacts.hpp"
#include "supple/contact/smooth_contacts.hpp"
#include "supple/core/parallel.hpp"
#include "supple/force/polygon_shape.hpp"

namespace supple::bench {
namespace {

/// One process for each core that computes for nobody while this lives.
class Load {
 public:
  Load() {
    for (unsigned i = 0; i < std::thread::hardware_concurrency(); ++i) {
      const pid_t child = fork();
      if (child == 0)
        for (volatile bool goes_on = true; goes_on;) {
        }
      if (child > 0) children_.push_back(child);
    }
  }
  ~Load() {
    for (const pid_t child : children_) {
      kill(child, SIGKILL);
      waitpid(child, nullptr, 0);
    }
  }
  Load(const Load&) = delete;
  Load& operator=(const Load&) = delete;

 private:
  std::vector<pid_t> children_;
};

struct Seconds {
  double wall, cpu;
};

Seconds seconds_of(const std::function<void()>& work, int threads) {
  const WithThreads some(threads);
  const auto begin = std::chrono::steady_clock::now();
  const double cpu = cpu_seconds();
  work();
  return {std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(),
          cpu_seconds() - cpu};
}

/// Two threads over one: best times of several attempts in turn.
Seconds two_over_one(const std::function<void()>& work) {
  constexpr double never = std::numeric_limits<double>::infinity();
  Seconds best[2] = {{never, never}, {never, never}};
  for (int repeat = 0; repeat < 9; ++repeat)
    for (int k = 0; k < 2; ++k) {
      const Seconds took = seconds_of(work, k + 1);
      best[k] = {std::min(best[k].wall, took.wall), std::min(best[k].cpu, took.cpu)};
    }
  return {best[1].wall / best[0].wall, best[1].cpu / best[0].cpu};
}

void print_ratios(const std::string& name, const std::function<void()>& work) {
  work();
  const Seconds quiet = two_over_one(work);
  const Load load;
  const Seconds busy = two_over_one(work);
  fmt::print("  {:<32}  {:>10.2f}  {:>4.2f}  {:>9.2f}  {:>4.2f}\n", name, quiet.wall, quiet.cpu, busy.wall,
             busy.cpu);
}

void print_steps(int discs) {
  DenseSpec spec;
  spec.discs = discs;
  System<2> system = dense_discs(spec);
  Mover dynamics = dense_dynamics();
  print_ratios(fmt::format("{} discs, steps", discs), [&, steps = std::max(2'000'000 / discs, 20)] {
    for (int i = 0; i < steps; ++i) {
      dynamics.evaluate(system, {});
      dynamics.advance(system, {}, time_step, 1);
    }
  });
}

/// Forces of 1024 shells where they jam.
void print_forces(const std::string& name, const System<2>& start, const BodyContacts<2>& contacts) {
  System<2> system = start;
  ForceField<2> field(contacts);
  field.terms().add(std::make_shared<PolygonShape>());
  Evaluation<2> out;
  print_ratios(name, [&] {
    for (int i = 0; i < 300; ++i) field.evaluate(system, Detail::forces, out);
  });
}

}  // namespace

void print_threads() {
  fmt::print(
      "\nTwo threads over one (best of nine, in turn); busy: a thread of another program on each of {} "
      "cores\n",
      std::thread::hardware_concurrency());
  fmt::print("  {:<32}  quiet wall   CPU  busy wall   CPU\n", "");
  for (const int discs : {1500, 10000, 100000}) print_steps(discs);
  const Packing<2> shells = compressed_shells(1024, 0.85);
  const ContactLaws laws = shells.field->bodies()->laws();
  print_forces("1024 shells, forces, rough", shells.system, RoughContacts<2>(laws));
  print_forces("1024 shells, forces, smooth", shells.system, SmoothContacts(laws));
}

}  // namespace supple::bench
