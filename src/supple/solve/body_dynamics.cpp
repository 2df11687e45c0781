#include "supple/solve/body_dynamics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "supple/core/error.hpp"
#include "supple/model/rigid.hpp"
#include "supple/solve/degrees.hpp"

namespace supple {

namespace {

// Sites of rigid bodies are kicked and moved like all others, for a loop without exceptions: place_sites
// comes last.

void kick(System<2>& system, const std::vector<Vec2>& force, double time) {
  State<2>& s = system.state;
  for (int i = 0; i < s.size(); ++i) {
    if (s.mobility[i] == Mobility::free) s.velocity[i] += time / s.mass[i] * force[i];
    else s.velocity[i] = {};
  }
  RigidBodies& rigid = system.rigid;
  for (int r = 0; r < rigid.size(); ++r) {
    if (held(system, r)) {
      rigid.velocity[r] = {};
      rigid.spin[r] = 0;
      continue;
    }
    const RigidForce on_body = force_on_rigid(system, force, r);
    rigid.velocity[r] += time / rigid.mass[r] * on_body.force;
    rigid.spin[r] += time / rigid.inertia[r] * on_body.torque;
  }
}

void drift(System<2>& system, double time) {
  State<2>& s = system.state;
  double finite = 0;  // becomes NaN with the first value that is not finite
  for (int i = 0; i < s.size(); ++i) {
    s.position[i] += time * s.velocity[i];
    finite += 0 * (s.position[i][0] + s.position[i][1]);
  }
  RigidBodies& rigid = system.rigid;
  for (int r = 0; r < rigid.size(); ++r) {
    rigid.centre[r] += time * rigid.velocity[r];
    rigid.angle[r] += time * rigid.spin[r];
  }
  place_sites(system);
  if (finite == 0) return;
  for (int i = 0; i < s.size(); ++i)
    if (!std::isfinite(s.position[i][0] + s.position[i][1]))
      throw numerics_error(fmt::format("site {} is not finite at step {}", i, system.step + 1),
                           "the time step may be too large or bodies may overlap too much",
                           "reduce the time step");
}

void damp(System<2>& system, double factor) {
  for (Vec2& v : system.state.velocity) v *= factor;
  for (Vec2& v : system.rigid.velocity) v *= factor;
  for (double& w : system.rigid.spin) w *= factor;
}

}  // namespace

BodyDynamics::BodyDynamics(ForceField forces, double damping) : forces_(std::move(forces)) {
  set_damping(damping);
}

void BodyDynamics::set_damping(double rate) {
  if (!(rate >= 0))
    throw input_error(fmt::format("a damping rate of {}", rate), "it would add energy", "give 0 or more");
  damping_ = rate;
}

void BodyDynamics::set_plasticity(const std::optional<PlasticLaw>& law) {
  if (law) check(*law);
  plasticity_ = law;
}

const Evaluation<2>& BodyDynamics::evaluate(System<2>& system, Detail detail) {
  if (!current_ || (detail == Detail::energies && detail_ != detail))
    forces_.evaluate(system, detail, evaluation_);
  detail_ = current_ ? std::max(detail, detail_) : detail;
  current_ = true;
  return evaluation_;
}

void BodyDynamics::advance(System<2>& system, double dt) {
  if (system.box.strain_rate != 0)
    throw input_error("bodies cannot move by this method in a cell that is being sheared",
                      "their images have velocities", "shear in steps, or set the strain rate to 0");
  evaluate(system);
  const double decay = std::exp(-0.5 * damping_ * dt);
  if (damping_ > 0) damp(system, decay);
  kick(system, evaluation_.force, 0.5 * dt);
  current_ = false;
  drift(system, dt);
  if (plasticity_) supple::advance(system, *plasticity_, dt);
  system.time += dt;
  ++system.step;
  evaluate(system);
  forces_.commit(system, evaluation_);
  kick(system, evaluation_.force, 0.5 * dt);
  if (damping_ > 0) damp(system, decay);
  place_sites(system);
}

double kinetic_energy(const System<2>& system) {
  double sum = 0;
  for (int i = 0; i < system.state.size(); ++i)
    sum += 0.5 * system.state.mass[i] * dot(system.state.velocity[i], system.state.velocity[i]);
  return sum;
}

double spin_energy(const System<2>& system) {
  double sum = 0;
  for (int r = 0; r < system.rigid.size(); ++r)
    sum += 0.5 * system.rigid.inertia[r] * system.rigid.spin[r] * system.rigid.spin[r];
  return sum;
}

Vec2 momentum(const System<2>& system) {
  Vec2 sum{};
  for (int i = 0; i < system.state.size(); ++i) sum += system.state.mass[i] * system.state.velocity[i];
  return sum;
}

namespace {

/// Largest eigenvalue, or more, of |A| for a symmetric matrix: max_i (|A| x)_i / x_i for any x > 0 [Collatz
/// 1942].
double eigenvalue_bound(std::vector<MatrixEntry> entries, int size) {
  const auto place = [](const MatrixEntry& e) { return std::pair{e.row(), e.col()}; };
  std::stable_sort(entries.begin(), entries.end(),
                   [&](const MatrixEntry& a, const MatrixEntry& b) { return place(a) < place(b); });
  std::vector<MatrixEntry> sums;
  for (const MatrixEntry& e : entries) {
    const bool known = !sums.empty() && place(sums.back()) == place(e);
    if (known) sums.back() = {e.row(), e.col(), sums.back().value() + e.value()};
    else sums.push_back(e);
  }
  std::vector<double> x(static_cast<std::size_t>(size), 1.0), y(x.size());
  double bound = 0;
  for (int iteration = 0; iteration < 30; ++iteration) {
    std::fill(y.begin(), y.end(), 0.0);
    for (const MatrixEntry& e : sums) {
      y[e.row()] += std::abs(e.value()) * x[e.col()];
      if (e.row() != e.col()) y[e.col()] += std::abs(e.value()) * x[e.row()];
    }
    double largest_ratio = 0, largest = 0;
    for (std::size_t k = 0; k < x.size(); ++k) {
      largest_ratio = std::max(largest_ratio, y[k] / x[k]);
      largest = std::max(largest, y[k]);
    }
    bound = iteration == 0 ? largest_ratio : std::min(bound, largest_ratio);
    if (largest == 0) break;
    // Numbers that nothing connects to the stiffest ones must not vanish.
    for (std::size_t k = 0; k < x.size(); ++k) x[k] = y[k] / largest + 1e-3;
  }
  return bound;
}

/// Squared frequency of a site that six further neighbours and a wall press on.
double further_contacts(const System<2>& system, const ForceField& forces) {
  double largest = 0;
  for (int i = 0; i < system.state.size(); ++i) {
    const double sigma = 2 * system.state.radius[i];
    double spring = forces.bodies() ? 6 * forces.bodies()->law().stiffness(0.5 * sigma, sigma) : 0;
    if (const auto& walls = forces.walls())
      spring += walls->repulsion.spring(sigma) *
                std::max(1.0, walls->floor_friction > 0 ? walls->floor_stiffness : 0);
    largest = std::max(largest, spring / system.state.mass[i]);
  }
  return largest;
}

}  // namespace

double frequency_bound(System<2>& system, ForceField& forces) {
  const BodyDegrees degrees(system);
  Evaluation<2> evaluation;
  forces.evaluate(system, Detail::forces, evaluation);
  HessianBlocks<2> blocks;
  forces.add_hessian(system, blocks);
  std::vector<MatrixEntry> entries = degrees.hessian(system, blocks, evaluation.force);
  const std::vector<double> mass = degrees.masses(system);
  for (MatrixEntry& e : entries) e = {e.row(), e.col(), e.value() / std::sqrt(mass[e.row()] * mass[e.col()])};
  return std::sqrt(eigenvalue_bound(std::move(entries), degrees.size()) + further_contacts(system, forces));
}

double default_step(System<2>& system, ForceField& forces, double fraction) {
  const double omega = frequency_bound(system, forces);
  if (!(omega > 0)) throw input_error("no time step follows from the forces", "nothing acts", "give a step");
  return fraction * 2 / omega;
}

}  // namespace supple
