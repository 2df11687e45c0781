#include "supple/experiment/jam.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "supple/contact/reach.hpp"
#include "supple/core/error.hpp"
#include "supple/experiment/sound_states.hpp"
#include "supple/model/bodies.hpp"

namespace supple {

void require_room(const Packing& packing) {
  const System<2>& s = packing.system;
  const BodyContacts* contacts = packing.field->bodies();
  const std::vector<double> reach = contacts ? reach_of_sites(s, contacts->meeting(), contacts->range())
                                             : reach_of_sites(s, Meeting::sites);
  if (const auto period = short_period(s.box, least_period(s, reach)))
    throw input_error(
        fmt::format("the cell of {} particles has shrunk to {:.4g}", s.topology.body_count(s.state.size()),
                    period->length),
        fmt::format("below {:.4g} a particle meets itself or a neighbour on two sides", period->least),
        "raise bodies.N");
}

double reached_fraction(const Packing& packing, const JamProgress& progress) {
  return progress.settled ? covered_fraction(packing) : progress.state.packing_fraction;
}

bool in_window(const JamSpec& spec, double pressure) {
  return pressure > spec.pressure && pressure < spec.pressure * (1 + spec.window);
}

namespace {

/// A state of the search: densities are logarithms, ln phi = -2 ln L + constant.
struct Point {
  System<2> system;
  double density = 0, pressure = 0;
  Soundness soundness;
};

class Search {
 public:
  Search(Packing& packing, const JamSpec& spec, const JamCallback& callback)
      : packing_(packing), spec_(spec), callback_(callback) {}

  JamProgress run(const JamProgress& before = {}) {
    progress_ = before;
    const Point start{packing_.system, 0, 0, {}};
    Point low = minimised(start.system, 0);
    keep_sound(low, start);
    if (low.pressure >= spec_.pressure) return descend(low, spec_.step);
    return spec_.search == JamSearch::chapter ? halve_steps(low) : stride(low);
  }

 private:
  static constexpr double smallest = 1e-13;

  /// The chapter's protocol.
  JamProgress halve_steps(Point low) {
    for (double step = spec_.step; step > smallest;) {
      const Point next = minimised(low.system, low.density + step, low.density);
      if (unsound(next)) {
        if (step < 0.2 * spec_.step) keep_sound(next, low);
        step *= 0.5;  // a smaller one may lead past
        continue;
      }
      if (jammed(next)) return accept(next);
      if (next.pressure < spec_.pressure) low = next;
      else step *= 0.5, high_ = next;  // `low` is the state before
    }
    throw lost(low, high_);
  }

  /// Steps that grow while nothing resists, and the chapter's steps where something does; then the root
  /// search.
  JamProgress stride(Point low) {
    for (double step = spec_.step;;) {
      const Point next = minimised(low.system, low.density + step, low.density);
      if (unsound(next)) {
        if (step < 0.2 * spec_.step) keep_sound(next, low);
        step *= 0.5;
        continue;
      }
      if (jammed(next)) return accept(next);
      if (next.pressure < spec_.pressure) {
        low = next;
        const bool free = next.pressure < 1e-3 * spec_.pressure;
        step = std::clamp(free ? 1.3 * step : 0.5 * step, spec_.step, std::max(spec_.step, longest_stride));
      } else if (step > spec_.step) {
        step = std::max(spec_.step, 0.2 * step);
      } else {
        return find_root(low, next, From::below);
      }
    }
  }
  static constexpr double longest_stride = 0.02;

  bool jammed(const Point& p) const { return in_window(spec_, p.pressure); }

  /// The state at `density`, reached from `from` at its density.
  Point minimised(const System<2>& from, double density, double from_density = 0) {
    packing_.system = from;
    const double factor = std::exp(-0.5 * (density - from_density));
    scale_cell(packing_.system, {factor, factor});
    require_room(packing_);
    packing_.field->invalidate();
    const bool exact = spec_.search == JamSearch::chapter || !(spec_.coarse > 0);
    bool below = exact ? minimise_exactly() : minimise_coarsely();
    // A state is not taken before it is in equilibrium; a second run starts where the first gave up.
    if (!progress_.last.converged && in_window(spec_, progress_.state.pressure)) below = minimise_exactly();
    ++progress_.minimisations;
    if (progress_.last.ending == Ending::exhausted)
      require_converged(packing_, progress_.last,
                        fmt::format("the state at P = {:.3g}", progress_.state.pressure));
    progress_.unconverged += progress_.last.ending == Ending::stalled;
    Point point{packing_.system, density, below ? 0 : progress_.state.pressure, look_at(packing_)};
    remember(packing_, progress_.last, point.soundness);
    if (!unsound(point) && callback_ && !callback_(progress_))
      throw Error(ErrorKind::interrupted, "interrupted while searching for the jammed state");
    return point;
  }

  bool unsound(const Point& p) const { return must_stop(packing_, p.soundness); }

  /// Ends the search with the packing at `before` where the point is one that no run may accept.
  void keep_sound(const Point& point, const Point& before) {
    if (!unsound(point)) return;
    packing_.system = before.system;
    packing_.field->invalidate();
    throw unsound_error(point.soundness);
  }

  bool minimise_exactly() {
    count(relax(packing_));
    return false;
  }

  /// Minimises the packing, within a factor of two of the window to the full tolerance, elsewhere until it is
  /// clear on which side of the window it is. True if so little energy is left that the pressure must end
  /// below the window.
  bool minimise_coarsely() {
    const ForceTolerance exact = packing_.tolerance;
    packing_.tolerance.relative = std::max(exact.relative, spec_.coarse);
    packing_.tolerance.least = std::max(exact.least, spec_.coarse * force_at(spec_.pressure));
    bool below = false;
    const auto watch = [&](const MinimiseReport& r) {
      return !(below = r.energy > 0 && r.energy < least_energy(packing_, 0.5 * spec_.pressure));
    };
    count(relax(packing_, watch));
    packing_.tolerance = exact;
    const double p = progress_.state.pressure;
    if (below || p < 0.5 * spec_.pressure || p > 2 * spec_.pressure * (1 + spec_.window)) return below;
    return minimise_exactly();
  }

  void count(const MinimiseReport& report) {
    progress_.last = report;
    progress_.settled = report.converged;
    progress_.state = observe(packing_);
    progress_.evaluations += report.evaluations;
  }

  /// A typical contact force at this pressure [force].
  double force_at(double pressure) const {
    double diameter = 0;
    for (const double r : packing_.system.state.radius) diameter += 2 * r / packing_.system.state.size();
    return pressure * packing_.pressure_unit * diameter;
  }

  JamProgress accept(const Point& p) {
    require_converged(packing_, progress_.last, "the jammed state");
    packing_.system = p.system;
    return progress_;
  }

  /// From which end of the interval a root search starts its minimisations. On the way down a packing stays
  /// jammed at densities at which it had not jammed on the way up.
  enum class From { below, above };

  /// The search from a state that is above already: goes down by growing steps until below, then searches
  /// between the last two, starting from the one above.
  JamProgress descend(Point high, double first_step) {
    if (jammed(high)) return accept(high);
    for (double step = first_step;; step *= 1.5) {
      const Point next = minimised(high.system, high.density - step, high.density);
      keep_sound(next, high);
      if (jammed(next)) return accept(next);
      if (next.pressure < spec_.pressure) return find_root(next, high, From::above);
      high = next;
    }
  }

  /// A state inside the window between `low` (below) and `high` (above), by false position on P with the
  /// weight of an end that stays halved [Dowell & Jarratt 1971], or bisection where the lower pressure says
  /// nothing (unjammed).
  JamProgress find_root(Point low, Point high, From from) {
    const double target = spec_.pressure * (1 + 0.5 * spec_.window);
    double low_weight = 1, high_weight = 1;
    for (int k = 0; k < 200; ++k) {
      const double width = high.density - low.density;
      // The pressure jumps here: the packing rearranges. Come back from the other side.
      if (width < smallest) return turn_back(low, high, from);
      const double below = low_weight * (low.pressure - target),
                   above = high_weight * (high.pressure - target);
      double share =
          low.pressure < 1e-2 * spec_.pressure ? guess_from_above(low, high) : -below / (above - below);
      share = std::clamp(share, 0.02, 0.98);
      const Point& start = from == From::below ? low : high;
      const Point next = minimised(start.system, low.density + share * width, start.density);
      keep_sound(next, start);
      if (jammed(next)) return accept(next);
      if (next.pressure < spec_.pressure) {
        low = next;
        low_weight = 1;
        high_weight *= 0.5;
      } else {
        slope_ = (high.pressure - next.pressure) / (high.density - next.density);
        high = next;
        high_weight = 1;
        low_weight *= 0.5;
      }
    }
    throw lost(low, high);
  }

  /// After a jump: down from the state above it, or up again from the one below.
  JamProgress turn_back(const Point& low, const Point& high, From from) {
    if (++turns_ > most_turns) throw lost(low, high);
    slope_ = 0;
    return from == From::below ? descend(high, 0.1 * spec_.step) : stride(low);
  }
  static constexpr int most_turns = 6;

  /// Where the line through the last two states above meets the target, as a share of the interval; its
  /// middle before there are two.
  double guess_from_above(const Point& low, const Point& high) const {
    if (!(slope_ > 0)) return 0.5;
    const double target = spec_.pressure * (1 + 0.5 * spec_.window), width = high.density - low.density;
    const double share = 1 - (high.pressure - target) / slope_ / width;
    return share > 0 && share < 1 ? share : 0.5;
  }

  Error lost(const Point& low, const Point& high) {
    packing_.system = low.system;
    return numerics_error(
        fmt::format("no packing with 1 < P/{:.3g} < {:.4g} was found", spec_.pressure, 1 + spec_.window),
        fmt::format(
            "between P = {:.6g} and {:.6g} the packing fraction differs by {:.1e} of itself: it rearranges "
            "there, or its minimisations stop too early",
            low.pressure, high.pressure, high.density - low.density),
        progress_.unconverged > 0 ? "raise minimise.max_evaluations, or take another seed"
                                  : "widen jamming.window, or take another seed");
  }

  Packing& packing_;
  const JamSpec& spec_;
  const JamCallback& callback_;
  JamProgress progress_;
  Point high_;
  int turns_ = 0;
  double slope_ = 0;  ///< dP/d(ln phi) between the last two states above
};

}  // namespace

JamProgress jam(Packing& packing, const JamSpec& spec, const JamCallback& callback) {
  JamProgress work;
  if (spec.search != JamSearch::pressure) return Search(packing, spec, callback).run();
  if (jam_at_pressure(packing, spec, callback, work)) return work;
  JamSpec root = spec;
  root.search = JamSearch::root;
  return Search(packing, root, callback).run(work);
}

}  // namespace supple
