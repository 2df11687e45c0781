#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "supple/core/error.hpp"
#include "supple/experiment/jam.hpp"
#include "supple/model/bodies.hpp"
#include "supple/solve/cell_objective.hpp"

namespace supple {

namespace {

/// Contacts of another stiffness for as long as it lives.
class Softened {
 public:
  Softened(BodyContacts& contacts, double factor) : contacts_(contacts), law_(contacts.law()) {
    Harmonic soft = law_;
    soft.stiffness *= factor;
    contacts_.set_law(soft);
  }
  ~Softened() { contacts_.set_law(law_); }
  Softened(const Softened&) = delete;
  Softened& operator=(const Softened&) = delete;

 private:
  BodyContacts& contacts_;
  Harmonic law_;
};

/// Stiffness of contacts and pressure on the way, as shares of what they are at the end.
struct Stage {
  double stiffness, pressure;
};
constexpr Stage stages[] = {{1e-3, 5}, {1e-2, 1}};

class Press {
 public:
  Press(Packing& packing, const JamSpec& spec, const JamCallback& callback) : packing_(packing), spec_(spec), callback_(callback) {}

  JamProgress run() {
    approach();
    // Soft contacts make sense where shapes are stiffer than they are.
    const auto& shapes = packing_.system.shape.stiffness;
    const auto bears = [](const ShapeStiffness& k) { return k.volume > 0 || k.facet > 0; };
    const ForceTolerance exact = packing_.tolerance;
    const ForceTolerance coarse{std::max(exact.relative, spec_.coarse), std::max(exact.least, spec_.coarse * force_at(spec_.pressure))};
    if (std::any_of(shapes.begin(), shapes.end(), bears))
      for (const Stage& stage : stages) {
        const Softened soft(*packing_.field->bodies(), stage.stiffness);
        press(stage.pressure, coarse);
      }
    for (int k = 0; k < most_rounds; ++k) {
      press(1, k < 3 ? coarse : exact);
      count(relax(packing_));
      progress_.unconverged += !progress_.last.converged;
      const double p = progress_.state.pressure;
      if (progress_.last.converged && p > spec_.pressure && p < spec_.pressure * (1 + spec_.window)) return progress_;
    }
    throw numerics_error(fmt::format("no packing with 1 < P/{:.3g} < {:.4g} was found", spec_.pressure, 1 + spec_.window),
                         fmt::format("after {} minimisations P = {:.6g}", progress_.minimisations, progress_.state.pressure),
                         progress_.unconverged > 0 ? "raise minimise.max_evaluations, or take another seed"
                                                   : "widen jamming.window, or take another seed");
  }

 private:
  static constexpr int most_rounds = 20;
  static constexpr double longest_stride = 0.02;

  /// Shrinks the cell for as long as particles get out of each other's way at once.
  void approach() {
    const long most = packing_.minimise.max_evaluations;
    for (double step = spec_.step;; step = std::min(1.3 * step, std::max(spec_.step, longest_stride))) {
      packing_.minimise.max_evaluations = std::min(most, 500L);
      const MinimiseReport report = relax(packing_);
      packing_.minimise.max_evaluations = most;
      count(report);
      if (progress_.state.pressure > (report.converged ? 0.1 : stages[0].pressure) * spec_.pressure) return;
      const double factor = std::exp(-0.5 * step);
      scale_cell(packing_.system, {factor, factor});
      require_room(packing_);
      packing_.field->invalidate();
    }
  }

  /// A minimum of the enthalpy at so many times the pressure.
  void press(double times, const ForceTolerance& tolerance) {
    for (int k = 0; k < most_rounds; ++k) {
      const double wanted = times * spec_.pressure * (1 + 0.5 * spec_.window), ratio = ratio_, length = packing_.system.box.length[0];
      packing_.field->invalidate();
      CellObjective objective(packing_.system, *packing_.field, tolerance, {true, false}, ratio * wanted * packing_.pressure_unit);
      std::vector<double> x = objective.coordinates();
      // Numbers are those of the cell at the start, and the pressure that of all forces: begin anew where either has changed.
      const auto watch = [&](const MinimiseReport&) {
        if (k < 2) learn_ratio(ratio * wanted);
        return std::abs(ratio_ - ratio) < 0.3 * ratio && std::abs(packing_.system.box.length[0] / length - 1) < 0.05;
      };
      const MinimiseReport report = minimise(objective, x, packing_.minimise, watch);
      require_room(packing_);
      learn_ratio(ratio * wanted);
      count(report);
      if (report.reason != "stopped by the caller") break;
    }
  }

  /// The minimiser knows the pressure of all forces: how much of it contacts bear is learnt on the way, where it is about what it shall be.
  void learn_ratio(double pressure) {
    if (!packing_.contact_pressure) return;
    const PackingState s = observe(packing_);
    const bool balanced = std::abs(s.full_pressure - pressure) < 0.1 * pressure;
    if (balanced && s.contact_pressure > 0) ratio_ = std::clamp(s.full_pressure / s.contact_pressure, 0.1, 100.0);
  }

  void count(const MinimiseReport& report) {
    progress_.last = report;
    progress_.state = observe(packing_);
    progress_.evaluations += report.evaluations;
    ++progress_.minimisations;
    if (callback_ && !callback_(progress_)) throw Error(ErrorKind::interrupted, "interrupted while searching for the jammed state");
  }

  /// A contact force at this pressure, roughly.
  double force_at(double pressure) const {
    double diameter = 0;
    for (const double r : packing_.system.state.radius) diameter += 2 * r / packing_.system.state.size();
    return pressure * packing_.pressure_unit * diameter;
  }

  Packing& packing_;
  const JamSpec& spec_;
  const JamCallback& callback_;
  JamProgress progress_;
  double ratio_ = 1;  ///< of the pressure of all forces to the one wanted
};

}  // namespace

JamProgress jam_at_pressure(Packing& packing, const JamSpec& spec, const JamCallback& callback) {
  return Press(packing, spec, callback).run();
}

}  // namespace supple
