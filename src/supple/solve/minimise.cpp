#include "supple/solve/minimise.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "supple/core/error.hpp"
#include "supple/core/nearest_name.hpp"

namespace supple {
namespace {

constexpr long fire_round = 5000, newton_round = 100;  // iterations between two looks at the progress
constexpr long fire_between = 100;                     // when Newton is stuck
constexpr int idle_rounds = 3;                         // without progress, before it is given up

/// Whether a minimisation still gets anywhere.
class Progress {
 public:
  explicit Progress(const MinimiseReport& report) : residual_(report.residual), energy_(report.energy) {}

  /// Looks again; false after too many rounds in which neither residual nor energy fell.
  bool goes_on(const MinimiseReport& report) {
    const bool fell =
        report.residual < 0.9 * residual_ || report.energy < energy_ - 1e-10 * std::abs(energy_);
    residual_ = std::min(residual_, report.residual);
    energy_ = std::min(energy_, report.energy);
    idle_ = fell ? 0 : idle_ + 1;
    return idle_ < idle_rounds;
  }

 private:
  double residual_, energy_;
  int idle_ = 0;
};

/// A round of Newton; where it is stuck or slow, dynamics finds another way.
void newton_or_fire(Newton& newton, Fire& fire, Descent& descent) {
  const double before = descent.report.residual;
  const bool fine = newton.run(descent, newton_round);
  if (!fine || descent.report.residual > 0.1 * before) fire.run(descent, 1, fire_between);
}

}  // namespace

Minimiser minimiser_named(std::string_view name) {
  if (name == "auto") return Minimiser::automatic;
  if (name == "fire") return Minimiser::fire;
  if (name == "newton") return Minimiser::newton;
  const auto meant = nearest_name(name, {"auto", "fire", "newton"});
  throw input_error(fmt::format("minimiser '{}'", name), "there is none of this name",
                    meant ? fmt::format("did you mean '{}'?", *meant) : "use 'auto', 'fire' or 'newton'");
}

MinimiseReport minimise(Objective& objective, std::span<double> x, const MinimiseSpec& spec,
                        const MinimiseCallback& callback) {
  if (static_cast<int>(x.size()) != objective.size())
    throw input_error(fmt::format("{} numbers to minimise over", x.size()),
                      fmt::format("the objective has {}", objective.size()), "give as many");
  Descent descent(objective, x);
  descent.max_evaluations = spec.max_evaluations;
  descent.callback_interval = std::max(1L, spec.callback_interval);
  descent.callback = callback;
  descent.stop_requested = spec.stop_requested;
  if (!descent.evaluate()) descent.stop(Ending::not_finite, "energy or gradient is not finite at the start");

  Fire fire(spec.fire);
  Newton newton(spec.newton);
  Progress progress(descent.report);
  if (spec.method == Minimiser::automatic) fire.run(descent, spec.handover, spec.fire_iterations);
  while (!descent.finished()) {
    if (spec.method == Minimiser::fire) fire.run(descent, 1, fire_round);
    else newton_or_fire(newton, fire, descent);
    if (!descent.finished() && !progress.goes_on(descent.report))
      descent.stop(Ending::stalled, "the residual falls no further");
  }
  return descent.report;
}

}  // namespace supple
