#include <algorithm>
#include <cmath>
#include <vector>

#include "supple/core/error.hpp"
#include "supple/experiment/jam.hpp"
#include "supple/experiment/sound_states.hpp"
#include "supple/model/bodies.hpp"
#include "supple/solve/cell_objective.hpp"

namespace supple {

namespace {

/// Contacts of another stiffness for as long as it lives.
template <int Dim>
class Softened {
 public:
  Softened(BodyContacts<Dim>& contacts, double factor) : contacts_(contacts), laws_(contacts.laws()) {
    contacts_.set_laws(laws_.map([&](const BodyLaw& law) { return law.stiffer(factor); }));
  }
  ~Softened() { contacts_.set_laws(laws_); }
  Softened(const Softened&) = delete;
  Softened& operator=(const Softened&) = delete;

 private:
  BodyContacts<Dim>& contacts_;
  ContactLaws laws_;
};

/// Stiffness of contacts and pressure on the way, as shares of what they are at the end.
struct Stage {
  double stiffness = 1, pressure = 1;
};

/// Appends stages after the last one up to `end`, whose contacts yield ten times less from one to the next.
/// At such steps the contacts of one stage are nearly those of the next; at larger ones too many open at
/// once.
void append_tenths(std::vector<Stage>& stages, Stage end) {
  const Stage start = stages.back();
  const double stiffer = end.stiffness / start.stiffness, lower = end.pressure / start.pressure;
  const int steps = static_cast<int>(std::ceil(std::log10(stiffer / lower) - 0.1));
  for (int k = 1; k < steps; ++k)
    stages.push_back({start.stiffness * std::pow(stiffer, 1.0 * k / steps),
                      start.pressure * std::pow(lower, 1.0 * k / steps)});
  if (steps > 0) stages.push_back(end);
}

template <int Dim>
class Press {
 public:
  Press(Packing<Dim>& packing, const JamSpec& spec, JamState<Dim>& state, const BeforeMinimisation& before,
        const JamCallback<Dim>& callback)
      : packing_(packing),
        spec_(spec),
        progress_(state.progress),
        s_(state.press),
        before_(before),
        callback_(callback) {}

  bool run() {
    if (s_.part == Part::failed) return false;
    if (s_.part == Part::approach) {
      approach();
      // One state less to keep where the last one in equilibrium is as good to go back to.
      if (packing_.relaxed) s_.good.reset();
      else s_.good = packing_.system;
      s_.part = Part::soften;
    }
    const auto go_back = [&] {
      packing_.system = s_.good ? *s_.good : *packing_.relaxed;
      packing_.field->invalidate();
    };
    try {
      if (s_.part == Part::soften) s_.part = soften() ? Part::harden : Part::failed;
      if (s_.part == Part::harden && harden()) return true;
    } catch (const Error&) {
      if (!progress_.settled) go_back();  // or the state handed over would be one of softened contacts
      throw;
    }
    go_back();
    s_.good.reset();
    progress_.share.reset();
    s_.part = Part::failed;
    return false;
  }

 private:
  using Part = typename PressState<Dim>::Part;
  static constexpr int most_rounds = 20, most_pressed = 100;
  static constexpr double longest_stride = 0.02;
  /// How far a contact yields at first under the force that one particle bears, at most: as a share of the
  /// contact distance, as vertices pass each other at five times as much; and of a particle's diameter, as
  /// particles that have been compressed far beyond jamming jam at a higher packing fraction (discs, by
  /// 0.0065 after 0.02).
  static constexpr double first_yield_of_contact = 0.02, first_yield_of_particle = 0.003;
  /// The first pressure [pressure_unit]: it deforms shapes by a thousandth or so.
  static constexpr double first_pressure = 1e-3;
  /// Share of the work until the first stage is at its minimum, as measured with 64 and 256 shells.
  static constexpr double collapsed = 0.25;

  /// Minimises in stages, from high pressure and soft contacts to those of the end. A packing that is not yet
  /// stable slides on until it is, in the faster steps the more contacts yield; so the stages at the wanted
  /// pressure leave little of that to the contacts of the end. False where particles get into each other.
  bool soften() {
    const std::vector<Stage> stages = stages_to_the_end();
    for (; s_.stage < static_cast<int>(stages.size()); ++s_.stage, s_.pressed = 0) {
      const Stage& stage = stages[s_.stage];
      const Softened<Dim> soft(*packing_.field->bodies(), stage.stiffness);
      progress_.stiffness = stage.stiffness;
      const double share = stage.pressure > 1 ? spec_.coarse : 0.01 * spec_.coarse;
      const bool sound = press(stage.pressure, coarse_tolerance(share));
      progress_.stiffness = 1;
      if (!sound) return false;
      progress_.share = collapsed + (1 - collapsed) * (s_.stage + 1.0) / (stages.size() + 1.0);
    }
    return true;
  }

  /// The stages before the last, in which contacts are as the case has them at the wanted pressure. None
  /// where that makes contacts yield as much as at first.
  std::vector<Stage> stages_to_the_end() const {
    const ContactLaws& laws = packing_.field->bodies()->laws();
    // Particles that attract would stay where a higher pressure, or a weaker attraction, has let them go.
    if (!laws.all([](const BodyLaw& law) { return !law.attracts(); })) return {};
    Stage first{1, first_pressure / spec_.pressure};
    const double most =
        std::min(first_yield_of_contact * mean_diameter(), first_yield_of_particle * mean_body_diameter());
    if (yield(first) > most) first.pressure *= most / yield(first);
    else first.stiffness = yield(first) / most;
    if (first.pressure <= 1) return {};
    std::vector<Stage> stages{first};
    append_tenths(stages, {first.stiffness, 1});
    append_tenths(stages, {1, 1});
    stages.pop_back();
    return stages;
  }

  /// Minimises with contacts as they are. True once the pressure is in the window; false if it is lost
  /// repeatedly.
  bool harden() {
    for (; s_.round < most_rounds && s_.losses < 2; ++s_.round, s_.is_pressed = false, s_.pressed = 0) {
      if (!s_.is_pressed && !press(1, packing_.tolerance)) return false;
      s_.is_pressed = true;
      begin();
      const MinimiseReport report = relax(packing_);
      if (report.ending == Ending::exhausted) require_converged(packing_, report, "the hardened packing");
      progress_.unconverged += !report.converged;
      const Soundness soundness = look_at(packing_);
      if (must_stop(packing_, soundness)) return false;
      remember(packing_, report, soundness);
      count(report, report.converged);
      if (report.converged && in_window(spec_, progress_.state.pressure)) return true;
      s_.losses += progress_.state.pressure < 0.1 * spec_.pressure;
    }
    return false;
  }

  /// How far contacts yield under the force that one particle bears in this stage [length].
  double yield(const Stage& stage) const {
    const double force = force_by_pressure<Dim>(stage.pressure * spec_.pressure * packing_.pressure_unit,
                                                mean_body_diameter());
    const double softest = packing_.field->bodies()->laws().least(
        [&](const BodyLaw& law) { return law.spring(mean_diameter()); });
    return force / (stage.stiffness * softest);
  }

  /// `share` of a typical contact force at the wanted pressure, or the tolerance of the end if that is more.
  ForceTolerance coarse_tolerance(double share) const {
    const ForceTolerance& exact = packing_.tolerance;
    const double force = force_by_pressure<Dim>(spec_.pressure * packing_.pressure_unit, mean_diameter());
    return {std::max(exact.relative, share), std::max(exact.least, share * force)};
  }

  double mean_body_diameter() const {
    const System<Dim>& s = packing_.system;
    const int bodies = s.topology.body_count(s.state.size());
    double sum = 0;
    for (int b = 0; b < bodies; ++b) sum += 2 * outer_radius(s, b);
    return sum / bodies;
  }

  /// Mean diameter of the vertices.
  double mean_diameter() const {
    double sum = 0;
    for (const double r : packing_.system.state.radius) sum += 2 * r;
    return sum / packing_.system.state.size();
  }

  /// Shrinks the cell for as long as particles get out of each other's way at once.
  void approach() {
    const long most = packing_.minimise.max_evaluations;
    if (s_.step == 0) {
      s_.step = spec_.step;
      s_.good = packing_.system;
    }
    for (;;) {
      begin();
      packing_.minimise.max_evaluations = std::min(most, 100L);
      const MinimiseReport report = relax(packing_);
      packing_.minimise.max_evaluations = most;
      const Soundness soundness = look_at(packing_);
      remember(packing_, report, soundness);
      if (must_stop(packing_, soundness)) {  // the root search, with its smaller steps, shall look for a way
        packing_.system = *s_.good;
        packing_.field->invalidate();
        return;
      }
      s_.good = packing_.system;
      count(report, report.converged);
      if (progress_.state.pressure > (report.converged ? 0.1 : 5.0) * spec_.pressure) return;
      scale_cell(packing_.system, std::exp(-s_.step / Dim));
      s_.step = std::min(1.3 * s_.step, std::max(spec_.step, longest_stride));
      require_room(packing_);
      packing_.field->invalidate();
    }
  }

  /// Goes to a minimum of the enthalpy at `times` the wanted pressure. False at a state at which no run may
  /// be.
  bool press(double times, const ForceTolerance& tolerance) {
    while (s_.pressed < most_pressed) {
      begin();
      const int k = s_.pressed;
      const double wanted = times * spec_.pressure * (1 + 0.5 * spec_.window), ratio = s_.ratio,
                   length = packing_.system.box.length[0];
      packing_.field->invalidate();
      CellObjective<Dim> objective(packing_.system, *packing_.field, tolerance, {true, false},
                                   ratio * wanted * packing_.pressure_unit);
      std::vector<double> x = objective.coordinates();
      // The numbers of an objective are those of the cell at its construction, and its pressure is that of
      // all forces: a new one is made where either has changed.
      bool lost = false;
      const auto watch = [&](const MinimiseReport&) {
        if (k < 2) learn_ratio(ratio * wanted);
        return !(lost = must_stop(packing_, look_at(packing_))) && std::abs(s_.ratio - ratio) < 0.3 * ratio &&
               std::abs(packing_.system.box.length[0] / length - 1) < 0.05;
      };
      const MinimiseReport report = minimise(objective, x, packing_.minimise, watch);
      require_going_on(packing_, report);
      if (report.ending == Ending::exhausted)
        require_converged(packing_, report, "the cell at constant pressure");
      if (lost) return false;
      require_room(packing_);
      learn_ratio(ratio * wanted);
      ++s_.pressed;
      count(report, false);
      if (report.ending != Ending::stopped) break;
    }
    return !must_stop(packing_, look_at(packing_));
  }

  /// The minimiser prescribes the pressure of all forces. Where the pressure of contacts is wanted, the ratio
  /// of the two is measured whenever the former is about right.
  void learn_ratio(double pressure) {
    if (!packing_.contact_pressure) return;
    const PackingState<Dim> s = observe(packing_);
    const bool balanced = std::abs(s.full_pressure - pressure) < 0.1 * pressure;
    if (balanced && s.contact_pressure > 0)
      s_.ratio = std::clamp(s.full_pressure / s.contact_pressure, 0.1, 100.0);
  }

  void begin() {
    if (before_) before_();
  }

  void count(const MinimiseReport& report, bool settled) {
    progress_.settled = settled;
    progress_.last = report;
    progress_.state = observe(packing_);
    if (s_.part != Part::harden && s_.stage == 0) {  // on the way to the first minimum
      const double phi = std::min(1.0, progress_.state.packing_fraction);
      progress_.share = std::max(progress_.share.value_or(0), collapsed * phi * phi);
    }
    progress_.evaluations += report.evaluations;
    ++progress_.minimisations;
    if (callback_ && !callback_(progress_))
      throw Error(ErrorKind::interrupted, "interrupted while searching for the jammed state");
  }

  Packing<Dim>& packing_;
  const JamSpec& spec_;
  JamProgress<Dim>& progress_;
  PressState<Dim>& s_;
  const BeforeMinimisation& before_;
  const JamCallback<Dim>& callback_;
};

}  // namespace

template <int Dim>
bool jam_at_pressure(Packing<Dim>& packing, const JamSpec& spec, JamState<Dim>& state,
                     const BeforeMinimisation& before, const JamCallback<Dim>& callback) {
  return Press<Dim>(packing, spec, state, before, callback).run();
}

template bool jam_at_pressure(Packing<2>&, const JamSpec&, JamState<2>&, const BeforeMinimisation&,
                              const JamCallback<2>&);
template bool jam_at_pressure(Packing<3>&, const JamSpec&, JamState<3>&, const BeforeMinimisation&,
                              const JamCallback<3>&);

}  // namespace supple
