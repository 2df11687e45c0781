/// Figure 9.3 of MacKeith et al. (2025): heaps of rough and of smooth particles before and after a wall is
/// taken away. slump OUT SEEDS reads OUT/rough_1.h5, OUT/smooth_1.h5, ..., writes OUT/slump.png and prints
/// the table of the README.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "../panel.hpp"
#include "supple/io/run/run_file.hpp"

namespace {

using namespace supple;
using study::Panel;

/// One run, and what became of the heap.
struct Heap {
  RunFile run;
  RunInfo<2> info = run.info();
  Frame<2> before = last_with_wall(), after = run.frame(run.frames() - 1);

  double result(const std::string& name) const { return run.value("results", name); }

 private:
  /// The box is wider once its right wall is gone.
  Frame<2> last_with_wall() const {
    std::int64_t k = run.frames() - 1;
    while (k > 0 && run.frame(k).length[0] > info.box.length[0]) --k;
    return run.frame(k);
  }
};

/// (a) to (d) at one scale.
void draw(const Heap& rough, const Heap& smooth, const std::string& path) {
  constexpr double page = 520, gap = 30, above = 22;
  const double box = rough.info.box.length[0];
  const double reach = std::max(rough.result("front"), smooth.result("front")) + 1;
  const double tall = std::max(rough.result("settled_top"), smooth.result("settled_top"));
  const double scale = (page - gap - 20) / (box + reach), row = scale * tall + above + 12;
  Canvas canvas(path, page, 2 * row + 6, 250);
  const auto panel = [&](const Heap& heap, Outline outline, const Frame<2>& frame, Point corner,
                         const std::string& title) {
    Frame<2> shown = frame;
    const bool open = frame.length[0] > box;
    shown.length = {open ? reach : box, tall};
    const Panel p{canvas, heap.info, shown, outline, corner, scale};
    p.draw_wall(Panel::Side::left);
    p.draw_wall(Panel::Side::bottom);
    if (!open) p.draw_wall(Panel::Side::right);
    p.draw_particles();
    canvas.text(corner + Point{-5, -p.height() - 7}, title);
  };
  const double left = 10, right = left + scale * box + gap;
  double floor = row - 8;
  panel(rough, Outline::rough, rough.before, {left, floor}, "(a) rough");
  panel(rough, Outline::rough, rough.after, {right, floor},
        fmt::format("(b) slope {:.2f}", rough.result("slope")));
  floor += row;
  panel(smooth, Outline::smooth, smooth.before, {left, floor}, "(c) smooth");
  panel(smooth, Outline::smooth, smooth.after, {right, floor},
        fmt::format("(d) slope {:.2f}", smooth.result("slope")));
  canvas.finish();
}

struct Mean {
  double sum = 0, squares = 0;
  int n = 0;
  void add(double x) { sum += x, squares += x * x, ++n; }
  double value() const { return sum / n; }
  double error() const {
    return n > 1 ? std::sqrt(std::max(0.0, squares / n - value() * value()) / (n - 1)) : 0;
  }
};

constexpr const char* columns[] = {"settled_front", "front", "spread",      "top",
                                   "settled_slope", "slope", "floor_force", "motion"};

std::string number(const std::string& name, double value) {
  return name == "motion" ? fmt::format("{:.0e}", value) : fmt::format("{:.3f}", value);
}

void print(const std::string& kind, int seed, const Heap& heap) {
  fmt::print("| {} | {} |", kind, seed);
  for (const char* name : columns) fmt::print(" {} |", number(name, heap.result(name)));
  fmt::print("\n");
  std::fflush(stdout);
  for (const std::string& warning : heap.run.warnings())
    fmt::print(stderr, "{} {}: {}\n", kind, seed, warning);
}

int run(const std::string& out, int seeds) {
  fmt::print("| contacts | seed |");
  for (const char* name : columns) fmt::print(" {} |", name);
  fmt::print("\n|---|---|---|---|---|---|---|---|---|---|\n");
  std::vector<Heap> first;
  for (const std::string kind : {"rough", "smooth"}) {
    Mean front, spread, slope;
    for (int seed = 1; seed <= seeds; ++seed) {
      Heap heap{RunFile(fmt::format("{}/{}_{}.h5", out, kind, seed))};
      print(kind, seed, heap);
      front.add(heap.result("front"));
      spread.add(heap.result("spread"));
      slope.add(heap.result("slope"));
      if (seed == 1) first.push_back(std::move(heap));
    }
    fmt::print("| {} | mean | | {:.1f} ± {:.1f} | {:.1f} ± {:.1f} | | | {:.3f} ± {:.3f} | | |\n", kind,
               front.value(), front.error(), spread.value(), spread.error(), slope.value(), slope.error());
  }
  draw(first[0], first[1], out + "/slump.png");
  return 0;
}

}  // namespace

int main(int count, char** words) {
  try {
    if (count == 3) return run(words[1], std::atoi(words[2]));
    fmt::print(stderr, "usage: slump OUT SEEDS\n");
    return 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "slump: {}\n", error.what());
    return 1;
  }
}
