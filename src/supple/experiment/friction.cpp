#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "supple/core/error.hpp"
#include "supple/experiment/bodies_of_case.hpp"
#include "supple/experiment/body_motion.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/experiment/frame_schedule.hpp"
#include "supple/experiment/key_sets.hpp"
#include "supple/experiment/sliding_pair.hpp"
#include "supple/experiment/sliding_record.hpp"
#include "supple/experiment/sound_states.hpp"
#include "supple/observe/summary.hpp"

namespace supple {

namespace {

/// Time steps in a row at rest after which motion counts as died down: the kinetic energy of a vibration is
/// zero at its turning points.
constexpr int steps_at_rest = 20;

bool moves_in_time(const Case& c) { return c.sliding.relaxation == "dynamics"; }

/// The drag that a contact needs to stop without swinging, half of the critical one, unless one is given.
double damping_of(const Case& c, const SlidingPair& pair) {
  if (c.motion.damping > 0) return c.motion.damping;
  return std::sqrt(pair.spring / pair.packing.system.state.mass.front());
}

double time_step_of(const Case& c, SlidingPair& pair) {
  pair.packing.field->external().tethers = pair.tethers(0);
  return body_time_step(c, pair.packing, nullptr, damped_step);
}

/// The upper particle on its way.
class Slide {
 public:
  Slide(const Case& c, SlidingPair pair, Recorder& recorder)
      : case_(c),
        pair_(std::move(pair)),
        packing_(pair_.packing),
        recorder_(recorder),
        dt_(moves_in_time(c) ? time_step_of(c, pair_) : 0),
        mover_(*packing_.field, damping_of(c, pair_)),
        good_(packing_),
        frames_(pair_.path.places() - 1, c.output.frames) {
    sliding_observables().declare("friction", recorder_);
  }

  /// From the first place on, or from where the run was that goes on.
  void run() {
    restore(recorder_, keeps_);
    frames_.skip_to(place_);
    for (; place_ < pair_.path.places(); ++place_) {
      hold_vertices();
      if (moves_in_time(case_)) come_to_rest();
      else minimise();
      const Soundness soundness = good_.look();
      remember(packing_, work_.last, soundness);
      record();
      recorder_.progress(fmt::format("slide: x = {:.3f} D", pair_.path.x(place_) / pair_.width), place_,
                         pair_.path.places());
    }
    record_sliding(pair_, recorder_);
    record_packing(packing_, work_, recorder_, Surroundings::open);
  }

  /// The state as it is, for a run that ends early.
  void leave() { hand_over(packing_, recorder_); }

 private:
  /// Moves the springs of the upper particle to the present place.
  void hold_vertices() {
    const std::vector<Tether<2>> tethers = pair_.tethers(place_);
    packing_.field->external().tethers = tethers;
    packing_.field->invalidate();
    mover_.forces().external().tethers = tethers;
    mover_.invalidate();
  }

  std::string where() const {
    return fmt::format("the pair at x = {:.4g} D", pair_.path.x(place_) / pair_.width);
  }

  void minimise() {
    recorder_.hold(keeps_, "before step of the pair", place_);
    work_.last = relax(packing_);
    ++work_.minimisations;
    work_.evaluations += work_.last.evaluations;
    require_converged(packing_, work_.last, where());
  }

  /// Moves with drag until the kinetic energy has been below sliding.rest for steps_at_rest steps.
  void come_to_rest() {
    System<2>& s = packing_.system;
    for (; still_ < steps_at_rest; ++steps_) {
      recorder_.safe_point(keeps_, "at step", s.step);
      if (steps_ >= case_.sliding.most_steps) {
        const double kinetic = pair_.in_contact_energies(kinetic_energy(s).total());
        good_.go_back();
        throw numerics_error(
            fmt::format("{} is not at rest after {} steps", where(), steps_),
            fmt::format("its kinetic energy is {:.2g} k_c sigma^2", kinetic),
            "raise sliding.most_steps, motion.damping or sliding.rest, or set sliding.relaxation = "
            "\"minimise\"");
      }
      mover_.advance(s, dt_);
      const bool rests = pair_.in_contact_energies(kinetic_energy(s).total()) < case_.sliding.rest;
      still_ = rests ? still_ + 1 : 0;
    }
    still_ = 0;
    steps_ = 0;
    packing_.field->invalidate();
  }

  void record() {
    const SlidingInstant instant = look_at_pair(pair_, place_);
    sliding_observables().append("friction", instant, recorder_);
    if (!frames_.due(place_)) return;
    Frame<2> frame = packing_frame(packing_, report_packing(packing_), Surroundings::open);
    frame.numbers["sliding_x"] = instant.x / pair_.width;
    frame.numbers["friction"] = instant.force.friction();
    recorder_.frame(frame);
  }

  const Case& case_;
  SlidingPair pair_;
  Packing<2>& packing_;
  Recorder& recorder_;
  double dt_;
  Mover<2> mover_;
  LastGood<2> good_;
  FrameSchedule frames_;
  std::int64_t place_ = 0;
  std::int64_t steps_ = 0;  ///< of the present relaxation
  int still_ = 0;           ///< of these at rest, the last ones
  JamProgress<2> work_;
  const Keep keeps_ = [this](Keeper& k) {
    k("packing", packing_);
    k("good", good_);
    k("place", place_);
    k("steps", steps_);
    k("still", still_);
    k("work", work_);
  };
};

std::vector<Derived> derived_friction(const Case& c, SlidingPair& pair) {
  std::vector<Derived> all = derived_pair(pair);
  if (!moves_in_time(c)) return all;
  all.push_back({{"time_step", "", "time step"}, time_step_of(c, pair)});
  all.push_back({{"damping", "", "rate of the drag"}, damping_of(c, pair)});
  return all;
}

std::vector<Derived> derive_friction(const Case& c, const InitialState*) {
  SlidingPair pair = make_sliding_pair(c);
  return derived_friction(c, pair);
}

void run_friction(const Case& c, const InitialState*, Recorder& recorder) {
  SlidingPair pair = make_sliding_pair(c);
  begin_packing(pair.packing, derived_friction(c, pair), recorder);
  Slide slide(c, std::move(pair), recorder);
  try {
    slide.run();
  } catch (const Error&) {
    slide.leave();
    throw;
  }
}

/// Two particles of one size, unless sizes are given.
void choose_pair(Case& c) {
  if (!c.is_given("bodies.N")) c.bodies.count = 2;
  if (!c.is_given("bodies.large_fraction")) c.bodies.large_fraction = 0;
  for (std::size_t k = 0; k < c.species.size(); ++k)
    if (!c.is_given(species_section(k) + ".N")) c.species[k].count = c.species.size() == 1 ? 2 : 1;
}

void check_pair(const Case& c, Problems& problems) {
  if (const std::int64_t n = sample_size(c).bodies; n != 2)
    add_problem(problems, c, fmt::format("{} particles with experiment = \"friction\"", n),
                "one particle slides over another one",
                c.species.empty() ? "leave bodies.N and bodies.discs away" : "give two [[species]] of N = 1");
  for (const Species& s : species_of(c))
    if (is_disc(s)) {
      add_problem(problems, c, fmt::format("family = \"{}\" with experiment = \"friction\"", s.family),
                  "smooth discs push along the line of their centres: mu_eff is 0 everywhere",
                  "choose a family of polygons");
      break;
    }
  const Sliding& s = c.sliding;
  if (c.is_given("sliding.overlap") && s.centre_distance > 0)
    add_problem(problems, c, "sliding.overlap and sliding.centre_distance",
                "both say how high the upper one is", "leave one away");
  if ((s.from != 0 || s.to != 0) && !(s.from < s.to))
    add_problem(problems, c, fmt::format("sliding.from = {} and sliding.to = {}", s.from, s.to),
                "the way goes from left to right, and back with sliding.path = \"backward\"",
                "make sliding.to larger");
  if (moves_in_time(c) && c.is_given("motion.damping") && c.motion.damping == 0)
    add_problem(problems, c, "motion.damping = 0 with sliding.relaxation = \"dynamics\"",
                "motion that is not damped never dies down", "leave it away, or raise it");
}

}  // namespace

Experiment friction() {
  return {.name = "friction",
          .meaning = "one particle slides over another one: their effective friction (9.3.3)",
          .matter = &body_matter(),
          .keys = with(minimised_keys(), {"sliding.*", "output.frames", "time.step", "time.step_factor",
                                          "motion.damping", "-initial.state", "-initial.packing"}),
          .needs = {{"time.step time.step_factor motion.damping sliding.rest sliding.most_steps",
                     Need::Of::value, moves_in_time, "sliding.relaxation = \"dynamics\""},
                    {"sliding.cycles", Need::Of::value,
                     [](const Case& c) { return c.sliding.path == "cyclic"; }, "sliding.path = \"cyclic\""},
                    {"sliding.noise", Need::Of::value, has_soft, "a family of deformable particles"}},
          .derive = derive_friction,
          .run = run_friction,
          .figure = always<Figure::friction>,
          .first_keys = {"experiment", "seed", "bodies.family", "bodies.vertices", "contact.kind",
                         "sliding.overlap", "sliding.step"},
          .complete = choose_pair,
          .check = check_pair};
}

}  // namespace supple
