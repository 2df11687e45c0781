/// Figure 9.19(e) of MacKeith et al. (2025): mu_eff of two smooth shells over displacements of the upper one,
/// in the shapes that they have where mu_eff is largest on its way. friction_map CASE OUT writes
/// OUT/friction_map.png and prints the table of the README.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "../potential_map.hpp"
#include "supple/contact/smooth_contacts.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/force/force_field.hpp"
#include "supple/io/text/case_file.hpp"
#include "supple/model/bodies.hpp"
#include "supple/observe/pair_friction.hpp"

namespace {

using namespace supple;
using study::map_cells;

MemoryRecorder slide(const std::string& path, const std::vector<std::string>& more) {
  std::vector<std::string> keys{"contact.kind=smooth", "sliding.overlap=0.114", "output.frames=1"};
  keys.insert(keys.end(), more.begin(), more.end());
  Case c = read_case(path, keys);
  resolve_family(c);
  experiment_of(c).complete(c);
  check(c);
  MemoryRecorder r;
  run(c, nullptr, r);
  return r;
}

/// Two particles that keep their shapes, by the displacement of vertex t, the lowest of the upper one, from
/// vertex r, the right end of the upper edge of the lower one.
class Pair {
 public:
  explicit Pair(System<2> system) : system_(std::move(system)), field_(SmoothContacts(Harmonic{1, true})) {
    const Topology<2>& t = system_.topology;
    lowest_ = t.body_begin(1);
    left_ = t.body_begin(0);
    right_ = t.body_end(0) - 1;
  }
  Vec2 displacement() const { return system_.state.position[lowest_] - system_.state.position[right_]; }
  double edge() const { return norm(system_.state.position[right_] - system_.state.position[left_]); }
  double sigma() const { return 2 * system_.state.radius[lowest_]; }

  MutualForce at(const Vec2& displacement) {
    move_body(system_, 1, displacement - this->displacement());
    Evaluation<2> out;
    field_.invalidate();
    field_.evaluate(system_, Detail::forces, out);
    BodyContacts<2>& contacts = *field_.bodies();
    return force_on(system_, site_contacts(system_, contacts.records(system_), contacts.laws()), 1, 0);
  }

 private:
  System<2> system_;
  ForceField<2> field_;
  std::int32_t lowest_, left_, right_;
};

/// The largest mu_eff at one height, and the x where it is.
Vec2 largest_at(Pair& pair, double y) {
  Vec2 best{0, -1};
  const double edge = pair.edge();
  for (int k = 0; k <= 2000; ++k) {
    const double x = -edge * k / 2000;
    if (const double mu = pair.at({x, y}).friction(); mu > best[1]) best = {x, mu};
  }
  return best;
}

void draw(Pair& pair, const Vec2& star, const std::string& path) {
  const double size = 230, left = 50, top = 24, edge = pair.edge(), sigma = pair.sigma();
  std::vector<double> values;
  for (int row = 0; row < map_cells; ++row)
    for (int column = 0; column < map_cells; ++column) {
      const MutualForce force =
          pair.at({-edge * (1 - (column + 0.5) / map_cells), sigma * (1 - (row + 0.5) / map_cells)});
      values.push_back(force.contacts > 0 ? force.friction() : NAN);
    }
  const ColorScale scale = scale_over(values);
  Canvas canvas(path, left + size + 75, top + size + 45, 200);
  const double cell = size / map_cells;
  for (int row = 0; row < map_cells; ++row)
    for (int column = 0; column < map_cells; ++column) {
      const Point low{left + column * cell, top + row * cell};
      canvas.rectangle(low, low + Point{1.05 * cell, 1.05 * cell},
                       {.fill = scale.color(values[static_cast<std::size_t>(row) * map_cells + column])});
    }
  canvas.rectangle({left, top}, {left + size, top + size}, {.pen = Pen{}});
  for (double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    canvas.text({left + share * size, top + size + 5}, tick_label(share - 1, 0.01),
                {.size = 7, .across = Across::centre, .down = Down::top});
    canvas.text({left - 5, top + size - share * size}, tick_label(share, 0.01),
                {.size = 7, .across = Across::right, .down = Down::middle});
  }
  canvas.text({left + 0.5 * size, top + size + 24}, "x of vertex t from vertex r, over the edge",
              {.across = Across::centre});
  canvas.text({left - 30, top + 0.5 * size}, "y over \u03c3", {.across = Across::centre, .turn = Turn::left});
  const Point at{left + size * (1 + star[0] / edge), top + size * (1 - star[1] / sigma)};
  for (const double turn : {1.0, -1.0})
    canvas.line(at - Point{4, 4 * turn}, at + Point{4, 4 * turn}, {white, 1.6});
  canvas.text({left, top - 6}, "Effective friction at fixed shapes");
  draw_color_bar(canvas, {left + size + 14, top + 14}, size - 14, scale, "\u03bc", "");
  canvas.finish();
}

void print_row(const std::string& what, const std::string& published, const std::string& ours,
               const std::string& difference) {
  fmt::print("| {} | {} | {} | {} |\n", what, published, ours, difference);
}

int run(const std::string& path, const std::string& out) {
  const MemoryRecorder whole = slide(path, {"sliding.step=0.004"});
  const double x = whole.get("results", "friction_max_x"), most = whole.get("results", "friction_max");
  const MemoryRecorder there =
      slide(path, {"sliding.step=0.004", "sliding.from=-0.4", fmt::format("sliding.to={}", x)});
  Pair pair(there.last_system);
  const Vec2 star = pair.displacement();
  const double edge = pair.edge(), sigma = pair.sigma();
  const double here = pair.at(star).friction();
  const Vec2 best = largest_at(pair, star[1]), limit = largest_at(pair, sigma * (1 - 1e-6));
  int without = 0;
  double least = 1;
  for (int row = 0; row < 100; ++row)
    for (int column = 0; column < 100; ++column) {
      const MutualForce force = pair.at({-edge * (column + 0.5) / 100, sigma * (row + 0.5) / 100});
      without += force.contacts == 0;
      if (column != 49 && column != 50) least = std::min(least, std::abs(force.friction()));
    }
  fmt::print("| | published | ours | difference |\n|---|---|---|---|\n");
  print_row("mu_eff of the star, at x", "0.190",
            fmt::format("{:.4f} at ({:.3f} edges, {:.3f} sigma)", here, star[0] / edge, star[1] / sigma),
            fmt::format("{:+.4f}", here - 0.190));
  print_row("largest mu_eff at the same y", "0.190",
            fmt::format("{:.4f} at x = {:.3f} edges", best[1], best[0] / edge),
            fmt::format("{:+.4f}", best[1] - 0.190));
  print_row("largest mu_eff in the limit of no overlap", "not zero",
            fmt::format("{:.4f} at x = {:.3f} edges", limit[1], limit[0] / edge), "none");
  print_row("places of 100 x 100 where nothing touches", "none", fmt::format("{}", without), "none");
  fmt::print(
      "\nOn its way the upper particle has mu_eff = {:.4f} at most, at x = {:.3f} D; away from the middle, "
      "the "
      "least abs(mu_eff) of the map is {:.1e}.\n",
      most, x, least);
  draw(pair, star, out + "/friction_map.png");
  return 0;
}

}  // namespace

int main(int count, char** words) {
  try {
    if (count == 3) return run(words[1], words[2]);
    fmt::print(stderr, "usage: friction_map CASE OUT\n");
    return 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "friction_map: {}\n", error.what());
    return 1;
  }
}
