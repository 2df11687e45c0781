#include "supple/experiment/relaxation.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "supple/core/error.hpp"
#include "supple/observe/stress.hpp"

namespace supple {

void StressSpread::add(const Mat2& s) {
  const double values[] = {s[0][0], s[1][1], 0.5 * (s[0][1] + s[1][0])};
  for (int k = 0; k < 3; ++k) {
    low_[k] = count_ ? std::min(low_[k], values[k]) : values[k];
    high_[k] = count_ ? std::max(high_[k], values[k]) : values[k];
  }
  ++count_;
}

double StressSpread::spread() const {
  return std::max({high_[0] - low_[0], high_[1] - low_[1], high_[2] - low_[2]});
}

void relax(System<2>& system, Stepper<2>& stepper, const Units& units, const RelaxationSpec& spec, bool rough,
           const std::string& phase, RelaxationState& state, const Keep& keep, Recorder& recorder) {
  // The rest of a window of damped steps; the spread of the virial stress over it [Pa].
  const auto run_window = [&](double dt, double damping) {
    for (; state.step < spec.window; ++state.step) {
      if (state.step % 5 == 0) recorder.safe_point(keep, "while preparing, at step", state.done + state.step);
      const Evaluation<2>& evaluation = stepper.evaluate(system, {});
      if (state.step % 5 == 0) state.stress.add(stress_tensors(system, evaluation, units.stress()).virial);
      stepper.advance(system, {}, dt, damping);
    }
    const double spread = state.stress.spread();
    state.done += spec.window;
    state.step = 0;
    state.stress = {};
    return spread;
  };
  constexpr struct { double step, damping; } coarse[] = {{4, 0.5}, {2, 0.75}, {1, 0.875}};
  for (; rough && state.coarse < 3; ++state.coarse)
    run_window(coarse[state.coarse].step * spec.time_step, coarse[state.coarse].damping);
  for (;;) {
    const double spread = run_window(spec.time_step, 0.98);
    recorder.append("preparation", std::vector<double>{static_cast<double>(state.done), spread});
    if (spread < spec.tolerance) return recorder.progress(phase, state.done, state.done);
    if (state.done >= spec.most_steps)
      throw numerics_error(fmt::format("{}: stress still varies by {:.3g} Pa after {} steps, above {:.3g} Pa",
                                       phase, spread, state.done, spec.tolerance),
                           "the discs do not come to rest",
                           "raise [preparation] max_time or stress_tolerance");
    recorder.progress(phase, state.done, spec.most_steps);
  }
}

void remove_drift(System<2>& system) {
  Vec2 momentum{};
  double mass = 0;
  for (int i = 0; i < system.state.size(); ++i) {
    momentum += system.state.mass[i] * system.state.velocity[i];
    mass += system.state.mass[i];
  }
  for (Vec2& v : system.state.velocity) v -= (1 / mass) * momentum;
}

}  // namespace supple
