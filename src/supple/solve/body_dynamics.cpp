#include "supple/solve/body_dynamics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "supple/core/error.hpp"
#include "supple/model/outer_product.hpp"
#include "supple/model/rigid.hpp"
#include "supple/solve/degrees.hpp"
#include "supple/solve/eigenvalue_bound.hpp"

namespace supple {

namespace {

// Sites of rigid bodies are kicked and moved like all others, so that the loop has no branches; place_sites()
// puts them right at the end.

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

/// The part of an outer product that free sites have, of masses 1.
OuterPart part_of(const OuterProduct<2>& product, const std::vector<std::int32_t>& number_of_site,
                  const std::vector<double>& mass) {
  OuterPart part{product.factor, {}, {}};
  for (std::size_t k = 0; k < product.slope.size(); ++k) {
    const std::int32_t number = number_of_site[product.first + static_cast<std::int32_t>(k)];
    for (int d = 0; d < 2 && number >= 0; ++d) {
      part.index.push_back(number + d);
      part.slope.push_back(product.slope[k][d] / std::sqrt(mass[number + d]));
    }
  }
  return part;
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
  blocks.reserve(3 * static_cast<std::size_t>(system.state.size()));
  OuterProducts<2> products;
  forces.add_split_hessian(system, blocks, products);
  std::vector<MatrixEntry> entries = degrees.hessian(system, blocks, evaluation.force);
  const std::vector<double> mass = degrees.masses(system);
  for (MatrixEntry& e : entries) e = {e.row(), e.col(), e.value() / std::sqrt(mass[e.row()] * mass[e.col()])};
  std::vector<std::int32_t> number_of_site(static_cast<std::size_t>(system.state.size()), -1);
  for (int k = 0; k < degrees.site_count(); ++k) number_of_site[degrees.sites()[k]] = 2 * k;
  std::vector<OuterPart> parts;
  for (const OuterProduct<2>& product : products) parts.push_back(part_of(product, number_of_site, mass));
  return std::sqrt(eigenvalue_bound(entries, parts, degrees.size()) + further_contacts(system, forces));
}

double default_step(System<2>& system, ForceField& forces, double fraction) {
  const double omega = frequency_bound(system, forces);
  if (!(omega > 0)) throw input_error("no time step follows from the forces", "nothing acts", "give a step");
  return fraction * 2 / omega;
}

}  // namespace supple
