#include "supple/solve/fire.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace supple {
namespace {

/// What FIRE needs of velocity and gradient, in one pass.
struct Products {
  double vg = 0, vv = 0, gg = 0;
};

Products products(const double* v, const double* g, std::size_t n) {
  Lanes vg, vv, gg;
  Lanes::Eight a, b;
  std::size_t i = 0;
  for (; i + 8 <= n; i += 8) {
    Lanes::load(v + i, a);
    Lanes::load(g + i, b);
    vg.value += a * b;
    vv.value += a * a;
    gg.value += b * b;
  }
  Products p{vg.sum(), vv.sum(), gg.sum()};
  for (; i < n; ++i) {
    p.vg += v[i] * g[i];
    p.vv += v[i] * v[i];
    p.gg += g[i] * g[i];
  }
  return p;
}

/// v = keep v - push g; x += dt v.
void kick_and_drift(double keep, double push, double dt, const double* __restrict g, double* __restrict v,
                    double* __restrict x, std::size_t n) {
  for (std::size_t i = 0; i < n; ++i) {
    v[i] = keep * v[i] - push * g[i];
    x[i] += dt * v[i];
  }
}

/// Numbers in [-1/2, 1/2) without structure that an eigenvector could be orthogonal to.
void fill_scattered(std::vector<double>& u) {
  for (std::size_t i = 0; i < u.size(); ++i) {
    std::uint64_t h = (i + 1) * 0x9E3779B97F4A7C15u;  // the finaliser of SplitMix64 (Steele et al. 2014)
    h = (h ^ (h >> 30)) * 0xBF58476D1CE4E5B9u;
    h = (h ^ (h >> 27)) * 0x94D049BB133111EBu;
    u[i] = static_cast<double>((h ^ (h >> 31)) >> 11) * 0x1.0p-53 - 0.5;
  }
}

}  // namespace

double largest_eigenvalue(Descent& descent, std::vector<double>& direction, int iterations) {
  const std::size_t n = descent.x.size();
  const std::vector<double> origin(descent.x.begin(), descent.x.end()), gradient = descent.gradient;
  const MinimiseReport before = descent.report;
  if (direction.size() != n) {
    direction.resize(n);
    fill_scattered(direction);
  }
  // A displacement far above rounding and far below the distance over which contacts change.
  const double move = descent.objective.largest_move();
  const double probe = std::isfinite(move) ? 1e-4 * move : 1e-6 * std::max(1.0, largest(origin));
  double eigenvalue = 0;
  for (int i = 0; i < iterations; ++i) {
    const double scale = largest(direction);
    if (!(scale > 0)) break;
    for (std::size_t k = 0; k < n; ++k) {
      direction[k] /= scale;
      descent.x[k] = origin[k] + probe * direction[k];
    }
    if (!descent.evaluate_slope()) break;
    const double length = std::sqrt(dot(direction, direction));
    for (std::size_t k = 0; k < n; ++k) direction[k] = (descent.gradient[k] - gradient[k]) / probe;
    eigenvalue = std::max(eigenvalue, std::sqrt(dot(direction, direction)) / length);
  }
  if (!(largest(direction) > 0)) direction.clear();
  std::copy(origin.begin(), origin.end(), descent.x.begin());
  descent.gradient = gradient;
  descent.report.energy = before.energy;  // not its ending: a request to stop may have come meanwhile
  descent.report.residual = before.residual;
  descent.report.tolerance = before.tolerance;
  return eigenvalue;
}

void Fire::run(Descent& descent, double factor, long iterations) {
  const auto done = [&] {
    return descent.finished() || descent.report.residual <= factor * descent.report.tolerance;
  };
  if (done()) return;
  start(descent);
  do
    step(descent);  // at least once: the eigenvalue was measured elsewhere, and a run must end evaluated at x
  while (--iterations > 0 && !done());
  if (!energy_known_) descent.evaluate();
}

void Fire::start(Descent& descent) {
  velocity_.assign(descent.x.size(), 0.0);
  last_good_.assign(descent.x.begin(), descent.x.end());
  set_largest_step(descent, stiffness_ > 0 ? 3 : 10);
  dt_ = 0.25 * dt_max_;
  mixing_ = spec_.mixing;
  energy_at_rest_ = descent.report.energy;
  energy_known_ = true;
  downhill_ = 0;
}

void Fire::set_largest_step(Descent& descent, int iterations) {
  stiffness_ = largest_eigenvalue(descent, direction_, iterations);
  since_refresh_ = 0;
  dt_max_ = stiffness_ > 0 ? safety_ * spec_.step * 2 / std::sqrt(stiffness_) : 1.0;
}

void Fire::step(Descent& descent) {
  if (++since_refresh_ >= spec_.refresh) set_largest_step(descent, 3);
  const std::size_t n = velocity_.size();
  Products p = products(velocity_.data(), descent.gradient.data(), n);
  if (p.vg < 0) {
    if (++downhill_ > spec_.delay) {
      dt_ = std::min(dt_ * spec_.growth, dt_max_);
      mixing_ *= spec_.mixing_decay;
    }
  } else if (p.vv > 0) {
    turn_back(descent);
    p = {0, 0, dot(descent.gradient, descent.gradient)};
  }
  // v + dt F, of which the share `mixing` is then turned into the direction of F.
  const double speed = std::sqrt(std::max(0.0, p.vv - 2 * dt_ * p.vg + dt_ * dt_ * p.gg));
  double keep = 1 - mixing_;
  double push = keep * dt_ + (p.gg > 0 ? mixing_ * speed / std::sqrt(p.gg) : 0.0);
  const double move = descent.objective.largest_move();
  if (dt_ * speed > move) {  // else no component can be too fast
    double fastest = 0;
    for (std::size_t i = 0; i < n; ++i)
      fastest = std::max(fastest, std::abs(keep * velocity_[i] - push * descent.gradient[i]));
    const double factor = std::min(1.0, move / (dt_ * fastest));
    keep *= factor;
    push *= factor;
  }
  kick_and_drift(keep, push, dt_, descent.gradient.data(), velocity_.data(), descent.x.data(), n);
  // Energies take time: they are computed only for the callback.
  energy_known_ = (descent.report.iterations + 1) % descent.callback_interval == 0;
  if (!(energy_known_ ? descent.evaluate() : descent.evaluate_slope())) recover(descent);
  descent.count_iteration();
}

void Fire::turn_back(Descent& descent) {
  if (!energy_known_ && !descent.evaluate()) return recover(descent);
  // Damped dynamics never reaches an energy above that of its start, unless the step is unstable.
  const double energy = descent.report.energy;
  if (energy > energy_at_rest_ + 1e-6 * std::abs(energy_at_rest_) && since_refresh_ > 20) {
    safety_ = std::max(0.1, 0.8 * safety_);
    set_largest_step(descent, 5);
  } else if (std::isfinite(energy)) {
    std::copy(descent.x.begin(), descent.x.end(), last_good_.begin());
  }
  energy_at_rest_ = energy;
  add_scaled(-0.5 * dt_, velocity_, descent.x);
  std::fill(velocity_.begin(), velocity_.end(), 0.0);
  dt_ = std::min(dt_, dt_max_) * spec_.cut;
  mixing_ = spec_.mixing;
  downhill_ = 0;
}

/// Back to the last place that was fine, with smaller steps.
void Fire::recover(Descent& descent) {
  std::copy(last_good_.begin(), last_good_.end(), descent.x.begin());
  if (!descent.evaluate()) return descent.stop(Ending::not_finite, "energy or gradient is not finite");
  safety_ *= 0.5;
  if (safety_ < 1e-6)
    return descent.stop(Ending::not_finite, "energy or gradient is not finite however small the step");
  start(descent);
}

}  // namespace supple
