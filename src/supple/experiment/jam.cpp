#include "supple/experiment/jam.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "supple/contact/reach.hpp"
#include "supple/core/error.hpp"
#include "supple/experiment/sound_states.hpp"
#include "supple/model/bodies.hpp"

namespace supple {

template <int Dim>
void require_room(const Packing<Dim>& packing) {
  const System<Dim>& s = packing.system;
  const BodyContacts<Dim>* contacts = packing.field->bodies();
  const std::vector<double> reach = contacts ? reach_of_sites(s, contacts->meeting(), contacts->range())
                                             : reach_of_sites(s, Meeting::sites);
  if (const auto period = short_period(s.box, least_period(s, reach)))
    throw input_error(
        fmt::format("the cell of {} particles has shrunk to {:.4g}", s.topology.body_count(s.state.size()),
                    period->length),
        fmt::format("below {:.4g} a particle meets itself or a neighbour on two sides", period->least),
        "raise bodies.N");
}

template <int Dim>
double reached_fraction(const Packing<Dim>& packing, const JamProgress<Dim>& progress) {
  return is_minimum(progress) ? covered_fraction(packing) : progress.state.packing_fraction;
}

bool in_window(const JamSpec& spec, double pressure) {
  return pressure > spec.pressure && pressure < spec.pressure * (1 + spec.window);
}

namespace {

template <int Dim>
class Search {
 public:
  Search(Packing<Dim>& packing, const JamSpec& spec, JamState<Dim>& state, const BeforeMinimisation& before,
         const JamCallback<Dim>& callback)
      : packing_(packing),
        spec_(spec),
        progress_(state.progress),
        s_(state.line),
        before_(before),
        callback_(callback) {}

  /// Each turn of the loop is one minimisation.
  JamProgress<Dim> run() {
    for (bool found = false; !found;) {
      if (before_) before_();
      switch (s_.way) {
        case Way::start: found = start(); break;
        case Way::halve: found = halve(); break;
        case Way::stride: found = stride(); break;
        case Way::descend: found = descend(); break;
        case Way::root: found = narrow(); break;
      }
    }
    return progress_;
  }

 private:
  using Way = typename LineSearchState<Dim>::Way;
  using From = typename LineSearchState<Dim>::From;
  static constexpr double smallest = 1e-13, longest_stride = 0.02;
  static constexpr int most_turns = 6, most_narrowed = 200;

  /// A state as just minimised, and whether a run may accept it.
  struct Point : JamPoint<Dim> {
    Soundness soundness;
  };

  bool start() {
    const JamPoint<Dim> given{packing_.system, 0, 0};
    const Point first = minimised(given, 0);
    keep_sound(first, given);
    s_.low = first;
    s_.step = spec_.step;
    if (first.pressure >= spec_.pressure) {
      s_.high = first;
      s_.way = Way::descend;
      return jammed(first) && accept(first);
    }
    s_.way = spec_.search == JamSearch::chapter ? Way::halve : Way::stride;
    return false;
  }

  /// The chapter's protocol: above the pressure back to the state before, `low`, with half the step.
  bool halve() {
    if (!(s_.step > smallest)) throw lost();
    const Point next = minimised(*s_.low, s_.low->density + s_.step);
    if (passes_by(next)) return false;
    if (jammed(next)) return accept(next);
    if (next.pressure < spec_.pressure) s_.low = next;
    else s_.step *= 0.5, s_.high = next;
    return false;
  }

  /// Steps that grow while nothing resists, and the chapter's steps where something does; then the root
  /// search.
  bool stride() {
    const Point next = minimised(*s_.low, s_.low->density + s_.step);
    if (passes_by(next)) return false;
    if (jammed(next)) return accept(next);
    if (next.pressure < spec_.pressure) {
      s_.low = next;
      const bool free = next.pressure < 1e-3 * spec_.pressure;
      s_.step =
          std::clamp(free ? 1.3 * s_.step : 0.5 * s_.step, spec_.step, std::max(spec_.step, longest_stride));
    } else if (s_.step > spec_.step) {
      s_.step = std::max(spec_.step, 0.2 * s_.step);
    } else {
      s_.high = next;
      search_between(From::below);
    }
    return false;
  }

  /// Whether the point is unsound; a smaller step may lead past such a state.
  bool passes_by(const Point& next) {
    if (!unsound(next)) return false;
    if (s_.step < 0.2 * spec_.step) keep_sound(next, *s_.low);
    s_.step *= 0.5;
    return true;
  }

  /// From a state that is above already: down by growing steps until below.
  bool descend() {
    const Point next = minimised(*s_.high, s_.high->density - s_.step);
    keep_sound(next, *s_.high);
    if (jammed(next)) return accept(next);
    if (next.pressure < spec_.pressure) {
      s_.low = next;
      search_between(From::above);
    } else {
      s_.high = next;
      s_.step *= 1.5;
    }
    return false;
  }

  void search_between(From from) {
    s_.way = Way::root;
    s_.from = from;
    s_.low_weight = s_.high_weight = 1;
    s_.narrowed = 0;
    turn_back_where_narrow();
  }

  /// A state between `low` and `high`, by false position on P with the weight of an end that stays halved
  /// [Dowell & Jarratt 1971], or bisection where the lower pressure says nothing (unjammed).
  bool narrow() {
    if (++s_.narrowed > most_narrowed) throw lost();
    const JamPoint<Dim>&low = *s_.low, &high = *s_.high;
    const double target = spec_.pressure * (1 + 0.5 * spec_.window), width = high.density - low.density;
    const double below = s_.low_weight * (low.pressure - target),
                 above = s_.high_weight * (high.pressure - target);
    double share =
        low.pressure < 1e-2 * spec_.pressure ? guess_from_above(low, high) : -below / (above - below);
    share = std::clamp(share, 0.02, 0.98);
    const JamPoint<Dim>& start = s_.from == From::below ? low : high;
    const Point next = minimised(start, low.density + share * width);
    keep_sound(next, start);
    if (jammed(next)) return accept(next);
    if (next.pressure < spec_.pressure) {
      s_.low = next;
      s_.low_weight = 1;
      s_.high_weight *= 0.5;
    } else {
      s_.slope = (high.pressure - next.pressure) / (high.density - next.density);
      s_.high = next;
      s_.high_weight = 1;
      s_.low_weight *= 0.5;
    }
    turn_back_where_narrow();
    return false;
  }

  /// Where the pressure jumps, the packing rearranges: down from the state above the jump, or up again from
  /// the one below.
  void turn_back_where_narrow() {
    if (!(s_.high->density - s_.low->density < smallest)) return;
    if (++s_.turns > most_turns) throw lost();
    s_.slope = 0;
    s_.way = s_.from == From::below ? Way::descend : Way::stride;
    s_.step = s_.from == From::below ? 0.1 * spec_.step : spec_.step;
  }

  bool jammed(const JamPoint<Dim>& p) const { return in_window(spec_, p.pressure); }

  /// The state at `density`, reached from `from`.
  Point minimised(const JamPoint<Dim>& from, double density) {
    packing_.system = from.system;
    scale_cell(packing_.system, std::exp(-(density - from.density) / Dim));
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
    Point point{{packing_.system, density, below ? 0 : progress_.state.pressure}, look_at(packing_)};
    remember(packing_, progress_.last, point.soundness);
    if (!unsound(point) && callback_ && !callback_(progress_))
      throw Error(ErrorKind::interrupted, "interrupted while searching for the jammed state");
    return point;
  }

  bool unsound(const Point& p) const { return must_stop(packing_, p.soundness); }

  /// Ends the search with the packing at `before` where the point is one that no run may accept.
  void keep_sound(const Point& point, const JamPoint<Dim>& before) {
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
    return force_by_pressure<Dim>(pressure * packing_.pressure_unit, diameter);
  }

  bool accept(const JamPoint<Dim>& p) {
    require_converged(packing_, progress_.last, "the jammed state");
    packing_.system = p.system;
    return true;
  }

  /// Where the line through the last two states above meets the target, as a share of the interval; its
  /// middle before there are two.
  double guess_from_above(const JamPoint<Dim>& low, const JamPoint<Dim>& high) const {
    if (!(s_.slope > 0)) return 0.5;
    const double target = spec_.pressure * (1 + 0.5 * spec_.window), width = high.density - low.density;
    const double share = 1 - (high.pressure - target) / s_.slope / width;
    return share > 0 && share < 1 ? share : 0.5;
  }

  Error lost() {
    const JamPoint<Dim> low = *s_.low, high = s_.high.value_or(low);
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

  Packing<Dim>& packing_;
  const JamSpec& spec_;
  JamProgress<Dim>& progress_;
  LineSearchState<Dim>& s_;
  const BeforeMinimisation& before_;
  const JamCallback<Dim>& callback_;
};

}  // namespace

template <int Dim>
JamProgress<Dim> jam(Packing<Dim>& packing, const JamSpec& spec, JamState<Dim>& state,
                     const BeforeMinimisation& before,
                     const std::type_identity_t<JamCallback<Dim>>& callback) {
  if (spec.search != JamSearch::pressure) return Search<Dim>(packing, spec, state, before, callback).run();
  if (jam_at_pressure(packing, spec, state, before, callback)) return state.progress;
  JamSpec root = spec;
  root.search = JamSearch::root;
  return Search<Dim>(packing, root, state, before, callback).run();
}

template <int Dim>
JamProgress<Dim> jam(Packing<Dim>& packing, const JamSpec& spec,
                     const std::type_identity_t<JamCallback<Dim>>& callback) {
  JamState<Dim> state;
  return jam(packing, spec, state, {}, callback);
}

template void require_room(const Packing<2>&);
template double reached_fraction(const Packing<2>&, const JamProgress<2>&);
template JamProgress<2> jam(Packing<2>&, const JamSpec&, JamState<2>&, const BeforeMinimisation&,
                            const JamCallback<2>&);
template JamProgress<2> jam(Packing<2>&, const JamSpec&, const JamCallback<2>&);
template void require_room(const Packing<3>&);
template double reached_fraction(const Packing<3>&, const JamProgress<3>&);
template JamProgress<3> jam(Packing<3>&, const JamSpec&, JamState<3>&, const BeforeMinimisation&,
                            const JamCallback<3>&);
template JamProgress<3> jam(Packing<3>&, const JamSpec&, const JamCallback<3>&);

}  // namespace supple
