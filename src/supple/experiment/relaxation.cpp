#include "supple/experiment/relaxation.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "supple/core/error.hpp"
#include "supple/observe/stress.hpp"

namespace supple {

namespace {

/// Spread of the stresses over a window.
class StressSpread {
 public:
  void add(const Mat2& s) {
    const double values[] = {s[0][0], s[1][1], 0.5 * (s[0][1] + s[1][0])};
    for (int k = 0; k < 3; ++k) {
      low_[k] = count_ ? std::min(low_[k], values[k]) : values[k];
      high_[k] = count_ ? std::max(high_[k], values[k]) : values[k];
    }
    ++count_;
  }
  double spread() const { return std::max({high_[0] - low_[0], high_[1] - low_[1], high_[2] - low_[2]}); }

 private:
  double low_[3]{}, high_[3]{};
  int count_ = 0;
};

/// One window of damped steps; the spread of the virial stress over it [Pa]. `go_on` is called at every fifth
/// step.
template <class GoOn>
double run_window(System<2>& system, Stepper& stepper, const Units& units, int steps, double dt,
                  double damping, const GoOn& go_on) {
  StressSpread stress;
  for (int i = 0; i < steps; ++i) {
    if (i % 5 == 0) go_on();
    const Evaluation<2>& evaluation = stepper.evaluate(system, {});
    if (i % 5 == 0) stress.add(stress_tensors(system, evaluation, units.stress()).virial);
    stepper.advance(system, {}, dt, damping);
  }
  return stress.spread();
}

}  // namespace

std::int64_t relax(System<2>& system, Stepper& stepper, const Units& units, const RelaxationSpec& spec,
                   bool rough, const std::string& phase, Recorder& recorder) {
  const auto go_on = [&] {
    if (recorder.stop_requested())
      throw Error(ErrorKind::interrupted, "interrupted while preparing (" + phase + ")");
  };
  std::int64_t done = 0;
  if (rough) {
    const struct { double step, damping; } stages[] = {{4, 0.5}, {2, 0.75}, {1, 0.875}};
    for (const auto& stage : stages) {
      run_window(system, stepper, units, spec.window, stage.step * spec.time_step, stage.damping, go_on);
      done += spec.window;
    }
  }
  for (double spread = 0;; recorder.progress(phase, done, spec.most_steps)) {
    spread = run_window(system, stepper, units, spec.window, spec.time_step, 0.98, go_on);
    done += spec.window;
    recorder.append("preparation", std::vector<double>{static_cast<double>(done), spread});
    if (spread < spec.tolerance) {
      recorder.progress(phase, done, done);
      return done;
    }
    if (done >= spec.most_steps)
      throw numerics_error(fmt::format("{}: stress still varies by {:.3g} Pa after {} steps, above {:.3g} Pa",
                                       phase, spread, done, spec.tolerance),
                           "the discs do not come to rest",
                           "raise [preparation] max_time or stress_tolerance");
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
