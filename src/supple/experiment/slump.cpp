#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "supple/core/error.hpp"
#include "supple/core/random.hpp"
#include "supple/experiment/body_motion.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/model/bodies.hpp"

namespace supple {

namespace {

/// Places 0 ... n - 1 in random order: the place of each body.
std::vector<int> drawn_places(int n, std::int64_t seed) {
  std::vector<int> place(static_cast<std::size_t>(n));
  std::iota(place.begin(), place.end(), 0);
  RandomStream draw(static_cast<std::uint64_t>(seed), Purpose::body_position, 1u << 31);
  for (int k = n - 1; k > 0; --k) std::swap(place[k], place[draw.below(static_cast<std::uint64_t>(k) + 1)]);
  return place;
}

/// A box of walls without a lid, and the particles above its floor, row over row, about to fall.
Packing hanging_packing(const Case& c, const InitialState* initial) {
  Packing p = make_packing(c, initial, 0.1);
  System<2>& s = p.system;
  const int bodies = s.topology.body_count(s.state.size());
  double widest = 0, mean = 0;
  for (int b = 0; b < bodies; ++b) {
    const double d = 2 * outer_radius(s, b);
    widest = std::max(widest, d);
    mean += d / bodies;
  }
  const double width = c.slump.width * mean, spacing = c.slump.drop_spacing * widest;
  const int columns = std::max(1, static_cast<int>(width / spacing)), count = (bodies + columns - 1) / columns;
  if (width < widest)
    throw input_error(fmt::format("slump.width = {}", c.slump.width), "the widest particle does not fit between the walls", "raise it");
  const double across = width / columns;
  const std::vector<int> places = drawn_places(bodies, c.general.seed);  // or the large ones would all be on top
  for (int b = 0; b < bodies; ++b) {
    const int place = places[static_cast<std::size_t>(b)];
    // Rows are offset in turn, or they would balance on top of each other.
    const double offset = (place / columns % 2 ? 0.1 : -0.1) * (across - widest);
    const Vec2 at{(place % columns + 0.5) * across + offset, (place / columns + 0.5) * spacing};
    move_body(s, b, at - body_centre(s, b));
  }
  s.box = {};
  s.box.length = {width, (count + 1) * spacing};
  s.box.periodic = {false, false};
  place_sites(s);
  p.field->external().gravity = {0, -c.slump.gravity};
  p.field->invalidate();
  return p;
}

WallLaw open_box(const Case& c, bool right_wall) {
  WallLaw walls = wall_law(c);
  walls.stands[gradient][1] = false;
  walls.stands[flow][1] = right_wall;
  return walls;
}

/// Columns and numbers of the heap: how far it reaches, how high it is, and the slope of its surface.
std::vector<Column> slump_columns(const Packing& packing) {
  std::vector<Column> all = motion_columns(packing);
  all.push_back({"front", "", "rightmost end of a particle"});
  all.push_back({"top", "", "highest end of a particle"});
  all.push_back({"slope", "", "of the line through the surface, downward to the right"});
  return all;
}

/// Slope of the least-squares line through the highest points in columns of the width of a particle, downward to the right.
double surface_slope(const System<2>& s) {
  double front = 0, widest = 0;
  for (int b = 0; b < s.topology.body_count(s.state.size()); ++b) widest = std::max(widest, 2 * outer_radius(s, b));
  for (int i = 0; i < s.state.size(); ++i) front = std::max(front, s.state.position[i][0] + s.state.radius[i]);
  const int columns = std::max(2, static_cast<int>(front / widest));
  std::vector<double> top(static_cast<std::size_t>(columns));
  for (int i = 0; i < s.state.size(); ++i) {
    const auto k = static_cast<std::size_t>(std::clamp(s.state.position[i][0] / front * columns, 0.0, columns - 1.0));
    top[k] = std::max(top[k], s.state.position[i][1] + s.state.radius[i]);
  }
  double x = 0, y = 0, xx = 0, xy = 0;
  for (int k = 0; k < columns; ++k) {
    const double at = (k + 0.5) * front / columns, h = top[static_cast<std::size_t>(k)];
    x += at / columns;
    y += h / columns;
    xx += at * at / columns;
    xy += at * h / columns;
  }
  return -(xy - x * y) / (xx - x * x);
}

std::vector<double> slump_row(const Packing& packing, const Evaluation<2>& evaluation) {
  std::vector<double> row = motion_row(packing, evaluation);
  const State<2>& s = packing.system.state;
  double front = 0, top = 0;
  for (int i = 0; i < s.size(); ++i) {
    front = std::max(front, s.position[i][0] + s.radius[i]);
    top = std::max(top, s.position[i][1] + s.radius[i]);
  }
  for (const double x : {front, top, surface_slope(packing.system)}) row.push_back(x);
  return row;
}

}  // namespace

std::vector<Derived> derive_slump(const Case& c, const InitialState* initial) {
  Packing packing = hanging_packing(c, initial);
  packing.field->set_walls(open_box(c, true));
  std::vector<Derived> all = derived_packing(packing);
  const double dt = body_time_step(c, packing, nullptr);
  all.push_back({{"time_step", "", "time step"}, dt});
  all.push_back({{"steps", "", "steps"}, std::ceil((c.slump.settle_time + c.slump.spread_time) / dt)});
  return all;
}

void run_slump(const Case& c, const InitialState* initial, Recorder& recorder) {
  Packing packing = hanging_packing(c, initial);
  System<2>& s = packing.system;
  packing.field->set_walls(open_box(c, true));
  const double dt = body_time_step(c, packing, nullptr);
  begin_packing(packing, derive_slump(c, initial), recorder);
  recorder.declare("motion", slump_columns(packing));
  const std::int64_t settle = std::llround(c.slump.settle_time / dt), spread = std::llround(c.slump.spread_time / dt);
  const std::int64_t total = settle + spread, per_row = std::max<std::int64_t>(1, total / 1000),
             per_frame = std::max<std::int64_t>(1, total / c.output.frames);
  BodyDynamics dynamics(*packing.field, c.motion.damping);
  dynamics.set_plasticity(plastic_law(c));
  for (std::int64_t i = 0; i <= total; ++i) {
    if (i == settle) {
      const std::vector<double> row = slump_row(packing, dynamics.evaluate(s, Detail::energies));
      recorder.value("results", {"settled_front", "", "rightmost end of a particle before the wall is taken away"}, row[6]);
      recorder.value("results", {"settled_slope", "", "slope of the surface before the wall is taken away"}, row[8]);
      packing.field->set_walls(open_box(c, false));
      dynamics.forces().set_walls(open_box(c, false));
      s.box.length[flow] *= 3;  // nothing stands there: the width is for pictures
    }
    if (i % per_row == 0 || i == total) recorder.append("motion", slump_row(packing, dynamics.evaluate(s, Detail::energies)));
    if (i % per_frame == 0 && i < total) recorder.frame(packing_frame(packing, report_packing(packing)));
    if (i == total) break;
    dynamics.advance(s, dt);
    if (i % 256 == 0) recorder.progress(i < settle ? "settle" : "spread", i, total);
    if (!recorder.stop_requested()) continue;
    hand_over(packing, recorder);
    throw Error(ErrorKind::interrupted, fmt::format("interrupted after step {}", i + 1));
  }
  const std::vector<double> row = slump_row(packing, dynamics.evaluate(s, Detail::energies));
  recorder.value("results", {"front", "", "rightmost end of a particle"}, row[6]);
  recorder.value("results", {"slope", "", "slope of the surface, downward to the right"}, row[8]);
  record_packing(packing, {}, recorder);
}

}  // namespace supple
