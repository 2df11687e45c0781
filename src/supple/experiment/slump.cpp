#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "supple/core/error.hpp"
#include "supple/core/random.hpp"
#include "supple/core/whole_number.hpp"
#include "supple/experiment/body_motion.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/experiment/heap.hpp"
#include "supple/experiment/key_sets.hpp"
#include "supple/experiment/sound_states.hpp"
#include "supple/model/bodies.hpp"
#include "supple/model/sanity.hpp"

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

/// Particles in rows above the floor of a box of this width. Returns the height of the rows.
double hang(System<2>& s, double width, double spacing, double widest, std::int64_t seed) {
  const int bodies = s.topology.body_count(s.state.size());
  const int columns = std::max(1, whole_number<int>(std::floor(width / spacing),
                                                    "particles in a row of the heap", "lower slump.width"));
  const int rows = (bodies - 1) / columns + 1;
  const double across = width / columns;
  const std::vector<int> places = drawn_places(bodies, seed);  // or the large ones would all be on top
  for (int b = 0; b < bodies; ++b) {
    const int column = places[b] % columns, row = places[b] / columns;
    // Rows are offset in turn, or they would balance on top of each other.
    const double offset = (row % 2 ? 0.1 : -0.1) * (across - widest);
    move_body(s, b, Vec2{(column + 0.5) * across + offset, (row + 0.5) * spacing} - body_centre(s, b));
  }
  place_sites(s);
  return rows * spacing;
}

/// Walls without a lid, and with or without the right one.
WallLaw<2> open_box(const Case& c, bool right_wall) {
  WallLaw<2> walls = wall_law<2>(c);
  walls.stands[gradient][1] = false;
  walls.stands[flow][1] = right_wall;
  return walls;
}

/// The particles, at rest, above the floor of the open box, about to fall. Those of a file fall anew: only
/// what they are is kept.
Packing<2> hanging_packing(const Case& c, const InitialState* initial, const Making& making) {
  Packing<2> p = make_packing(c, initial, 0.1, making);
  System<2>& s = p.system;
  put_at_rest(s);
  const double mean = mean_diameter(s), widest = widest_diameter(s), width = c.slump.width * mean;
  if (width < widest)
    throw input_error(fmt::format("slump.width = {}", c.slump.width),
                      "the widest particle does not fit between the walls", "raise it");
  s.box = {};
  s.box.periodic = {false, false};
  s.box.length = {width, hang(s, width, c.slump.drop_spacing * widest, widest, c.general.seed)};
  require_sane(s, "this heap");
  p.cell = s.box;
  p.field->external().gravity = {0, -c.slump.gravity};
  p.field->set_walls(open_box(c, true));
  p.field->invalidate();
  return p;
}

/// Steps of a time that the case gives in units of sqrt(1/gravity).
std::int64_t steps_of(const Case& c, double time, double dt) {
  return std::max<std::int64_t>(
      1, whole_number(time / std::sqrt(c.slump.gravity) / dt, "steps of the heap",
                      "lower slump.settle_time and slump.spread_time, or raise slump.gravity"));
}

/// A heap that moves, and what is recorded of it on the way.
class MovingHeap {
 public:
  MovingHeap(const Case& c, Packing<2> packing, Recorder& recorder)
      : case_(c),
        packing_(std::move(packing)),
        recorder_(recorder),
        dt_(body_time_step(c, packing_, nullptr, damped_step)),
        dynamics_(*packing_.field, c.motion.damping),
        good_(packing_) {
    dynamics_.set_plasticity(plastic_law(c));
    const std::int64_t total = steps_of(c, c.slump.settle_time, dt_) + steps_of(c, c.slump.spread_time, dt_);
    per_row_ = std::max<std::int64_t>(1, total / 1000);
    per_frame_ = std::max<std::int64_t>(1, total / c.output.frames);
    heap_observables().declare("motion", recorder_);
  }

  /// From the first step on, or from where the run was that goes on.
  void run() {
    if (!restore(recorder_, keeps_)) append();
    stand_walls();
    if (!spreads_) {
      move("settle", case_.slump.settle_time);
      record("settled_", " before the wall is taken away");
      take_right_wall_away();
    }
    move("spread", case_.slump.spread_time);
    record("", "");
    finish();
  }

  /// The state as it is, for a run that ends early.
  void leave() { hand_over(packing_, recorder_); }

 private:
  /// Until the particles are at rest, or the time is over.
  void move(const std::string& phase, double time) {
    const std::int64_t steps = steps_of(case_, time, dt_),
                       least = steps_of(case_, std::min(time, time_to_start), dt_);
    for (; step_ < steps; ++step_) {
      recorder_.safe_point(keeps_, "at step", packing_.system.step);
      if (step_ % look_interval(steps) == 0) good_.look();
      if (step_ % per_frame_ == 0) take_frame();
      dynamics_.advance(packing_.system, dt_);
      if (step_ % 256 == 0) recorder_.progress(phase, step_, steps);
      if ((step_ + 1) % per_row_ != 0) continue;
      append();
      if (step_ >= least && is_at_rest(heap_, case_.slump.rest)) break;
    }
    recorder_.progress(phase, step_, step_);
    append();
  }

  /// Walls as they are before or after the right one is taken away.
  void stand_walls() {
    packing_.field->set_walls(open_box(case_, !spreads_));
    dynamics_.forces().set_walls(open_box(case_, !spreads_));
  }

  void take_right_wall_away() {
    packing_.system.box.length[gradient] = 1.05 * heap_.top;  // without a lid the height is for pictures
    take_frame();
    spreads_ = true;
    step_ = 0;
    stand_walls();
    packing_.system.box.length[flow] *= 1.2;  // and from now on the width
  }

  /// Numbers of the heap as it is; a warning where it should be at rest and is not.
  void record(const std::string& prefix, const std::string& when) {
    const auto is_result =
        one_of({"time", "front", "top", "spread", "slope", "floor_force", "motion", "imbalance"});
    for (const auto& [name, of] : heap_observables())
      if (is_result(name.name))
        recorder_.value("results", {prefix + name.name, name.unit, name.meaning + when}, of(heap_));
    if (!is_at_rest(heap_, case_.slump.rest))
      recorder_.warning(
          fmt::format("the heap is not at rest{}: its kinetic energy is {:.1e} of what falling by a "
                      "diameter gives, and the largest net force {:.1e} of a particle's weight",
                      when, heap_.motion, heap_.imbalance));
  }

  void finish() {
    good_.look();
    widen_box();
    record_packing(packing_, {}, recorder_, Surroundings::open);
  }

  /// Time before which a heap does not count as at rest, as even one about to fall hardly moves at first
  /// [sqrt(1/gravity)].
  static constexpr double time_to_start = 10;

  void take_frame() {
    good_.look();
    widen_box();
    recorder_.frame(packing_frame(packing_, report_packing(packing_), Surroundings::open));
  }
  /// Widens the box so that pictures show all of a heap that has spread.
  void widen_box() {
    if (!packing_.field->walls()->stands[flow][1])
      packing_.system.box.length[flow] = std::max(packing_.system.box.length[flow], 1.05 * heap_.front);
  }
  /// Measures the heap and adds a row, one for each instant.
  void append() {
    heap_ = measure_heap(packing_.system, *packing_.field, dynamics_.evaluate_energies(packing_.system));
    if (!std::isfinite(heap_.spread + heap_.height)) good_.look();  // throws, back at the last good state
    if (last_row_ == packing_.system.step) return;
    heap_observables().append("motion", heap_, recorder_);
    last_row_ = packing_.system.step;
  }

  const Case& case_;
  Packing<2> packing_;
  Recorder& recorder_;
  double dt_;
  Mover<2> dynamics_;
  LastGood<2> good_;
  std::int64_t per_row_ = 1, per_frame_ = 1;
  std::optional<std::int64_t> last_row_;
  Heap heap_;
  bool spreads_ = false;   ///< the right wall is gone
  std::int64_t step_ = 0;  ///< since it is, or since the start
  const Keep keeps_ = [this](Keeper& k) {
    k("packing", packing_);
    k("good", good_);
    k("dt", dt_);
    k("per_row", per_row_);
    k("per_frame", per_frame_);
    k("last_row", last_row_);
    k("heap", heap_);
    k("spreads", spreads_);
    k("step", step_);
  };
};

std::vector<Derived> derived_slump(const Case& c, Packing<2>& packing) {
  std::vector<Derived> all = derived_packing(packing);
  const double dt = body_time_step(c, packing, nullptr, damped_step);
  const std::int64_t most = steps_of(c, c.slump.settle_time, dt) + steps_of(c, c.slump.spread_time, dt);
  all.push_back({{"time_step", "", "time step"}, dt});
  all.push_back({{"steps", "", "steps at most"}, static_cast<double>(most)});
  all.push_back({{"weight", "", "weight of all particles"}, weight(packing.system, *packing.field)});
  all.push_back(
      {{"floor_pressure", packing.pressure_symbol,
        "their weight over the width of the box: the pressure at its floor"},
       weight(packing.system, *packing.field) / packing.system.box.length[flow] / packing.pressure_unit});
  return all;
}

std::vector<Derived> derive_slump(const Case& c, const InitialState* initial) {
  Packing<2> packing = hanging_packing(c, initial, set_apart);
  return derived_slump(c, packing);
}

void run_slump(const Case& c, const InitialState* initial, Recorder& recorder) {
  Packing<2> packing = hanging_packing(c, initial, at_random(recorder));
  begin_packing(packing, derived_slump(c, packing), recorder);
  MovingHeap heap(c, std::move(packing), recorder);
  try {
    heap.run();
  } catch (const Error&) {
    heap.leave();
    throw;
  }
}

/// The drag with which a particle loses its velocity while it falls by its diameter, unless one is given;
/// also for a state from a run without drag.
void choose_damping(Case& c) {
  if (!c.is_given("motion.damping") && c.motion.damping == 0) c.motion.damping = std::sqrt(c.slump.gravity);
}

}  // namespace

Experiment slump() {
  return {.name = "slump",
          .meaning = "a heap under gravity spreads when a wall is taken away (9.3)",
          .matter = &body_matter(),
          .keys = with(moving_keys(), {"slump.*"}),
          .derive = derive_slump,
          .run = run_slump,
          .figure = always<Figure::motion>,
          .first_keys = {"experiment", "seed", "bodies.family", "bodies.N", "contact.floor_friction",
                         "slump.gravity"},
          .complete = choose_damping,
          .doubt = [](const Case& c, Doubts& doubts) {
            if (c.motion.damping == 0) doubts.push_back("motion.damping = 0: nothing ever settles");
          }};
}

}  // namespace supple
