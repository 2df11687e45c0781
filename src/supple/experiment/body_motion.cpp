#include "supple/experiment/body_motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "supple/core/random.hpp"
#include "supple/model/rigid.hpp"
#include "supple/observe/summary.hpp"

namespace supple {

template <int Dim>
double body_time_step(const Case& c, Packing<Dim>& packing, const InitialState* initial, double of_limit) {
  if (initial && !c.is_given("time.step") && !c.is_given("time.step_factor"))
    if (const auto dt = initial->protocol.find("dt"); dt != initial->protocol.end()) return dt->second;
  return c.time.time_step > 0 ? c.time.time_step
                              : c.time.step_factor * default_step(packing.system, *packing.field, of_limit);
}

std::optional<PlasticLaw> plastic_law(const Case& c) {
  if (c.bodies.flow_time <= 0) return std::nullopt;
  return PlasticLaw{c.bodies.flow_time, c.bodies.yield_strain, c.bodies.yield_strain, c.bodies.yield_strain};
}

namespace {

/// Rigid bodies move as wholes: each of their three motions has as much energy as one of a site.
void draw_rigid_velocities(System<2>& system, double kinetic_energy, std::int64_t seed) {
  RigidBodies& r = system.rigid;
  if (r.body.empty()) return;
  for (std::size_t k = 0; k < r.body.size(); ++k) {
    RandomStream draw(static_cast<std::uint64_t>(seed), Purpose::body_velocity, (std::uint64_t{1} << 32) + k);
    const auto gaussian = [&] {
      const double size = std::sqrt(-2 * std::log(1 - draw.uniform()));
      return size * std::cos(2 * std::numbers::pi * draw.uniform());
    };
    const double speed = std::sqrt(kinetic_energy / r.mass[k]);
    r.velocity[k] = {speed * gaussian(), speed * gaussian()};
    r.spin[k] = std::sqrt(kinetic_energy / r.inertia[k]) * gaussian();
  }
  place_sites(system);
}

/// Takes the mean velocity away, and gives back the energy that went with it.
template <int Dim>
void leave_in_place(System<Dim>& system, double energy) {
  const Vec<Dim> total = momenta(system).linear;
  double mass = 0;
  for (const double m : system.state.mass) mass += m;
  for (Vec<Dim>& v : system.state.velocity) v -= (1 / mass) * total;
  if constexpr (Dim == 2) {
    for (Vec2& v : system.rigid.velocity) v -= (1 / mass) * total;
    place_sites(system);
  }
  const double left = kinetic_energy(system).total();
  if (!(left > 1e-20 * energy))
    throw input_error("motion.kinetic_energy of one site", "without net momentum it stays where it is",
                      "raise bodies.N, or set motion.kinetic_energy = 0");
  const double factor = std::sqrt(energy / left);
  for (Vec<Dim>& v : system.state.velocity) v *= factor;
  if constexpr (Dim == 2) {
    for (Vec2& v : system.rigid.velocity) v *= factor;
    for (double& w : system.rigid.spin) w *= factor;
    place_sites(system);
  }
}

/// Gaussian, by Box and Muller: each pair of components has this energy.
template <int Dim>
Vec<Dim> gaussian_velocity(RandomStream& draw, double energy, double mass) {
  Vec<Dim> v;
  for (int d = 0; d < Dim; d += 2) {
    const double size = std::sqrt(-2 * std::log(1 - draw.uniform()) * energy / mass);
    const double angle = 2 * std::numbers::pi * draw.uniform();
    v[d] = size * std::cos(angle);
    if (d + 1 < Dim) v[d + 1] = size * std::sin(angle);
  }
  return v;
}

}  // namespace

template <int Dim>
void put_at_rest(System<Dim>& system) {
  std::fill(system.state.velocity.begin(), system.state.velocity.end(), Vec<Dim>{});
  std::fill(system.rigid.velocity.begin(), system.rigid.velocity.end(), Vec<Dim>{});
  std::fill(system.rigid.spin.begin(), system.rigid.spin.end(), Angular<Dim>{});
  system.floor_contact.clear();
  system.time = 0;
  system.step = 0;
}

template <int Dim>
void draw_velocities(System<Dim>& system, double energy, std::int64_t seed) {
  State<Dim>& s = system.state;
  for (int i = 0; i < s.size(); ++i) {
    RandomStream draw(static_cast<std::uint64_t>(seed), Purpose::body_velocity,
                      static_cast<std::uint64_t>(i));
    s.velocity[i] = gaussian_velocity<Dim>(draw, energy, s.mass[i]);
  }
  if constexpr (Dim == 2) draw_rigid_velocities(system, energy, seed);
  // A rigid body has three motions, each with as much as one of the two of a site.
  int free = s.size();
  for (const std::int32_t b : system.rigid.body) free -= system.topology.body_size(b);
  leave_in_place(system, energy * (free + 1.5 * static_cast<double>(system.rigid.body.size())));
}

template <int Dim>
std::vector<Column> motion_columns(const Packing<Dim>& packing) {
  return {{"time", "", "time"},
          {"kinetic_energy", "", "kinetic energy"},
          {"potential_energy", "", "energy of shapes, contacts, walls, gravity"},
          {"total_energy", "", "their sum"},
          {"pressure", packing.pressure_symbol, "full pressure (9.26), with its kinetic part"},
          {"height", "", "mean height of the vertices"}};
}

template <int Dim>
std::vector<double> motion_row(const Packing<Dim>& packing, const Evaluation<Dim>& evaluation) {
  const System<Dim>& s = packing.system;
  const KineticEnergy parts = kinetic_energy(s);
  const double kinetic = parts.total(), potential = evaluation.energy.stored();
  double height = 0;
  for (const Vec<Dim>& x : s.state.position) height += x[gradient] / s.state.size();
  const double moving = 2 * parts.translation;
  double trace = evaluation.virial[0][0];
  for (int d = 1; d < Dim; ++d) trace += evaluation.virial[d][d];
  const double p = (trace + moving) / Dim / s.box.volume() / packing.pressure_unit;
  return {s.time, kinetic, potential, kinetic + potential, p, height};
}

// clang-format off
#define SUPPLE_BODY_MOTION(Dim) \
  template double body_time_step(const Case&, Packing<Dim>&, const InitialState*, double); \
  template void put_at_rest(System<Dim>&); \
  template void draw_velocities(System<Dim>&, double, std::int64_t); \
  template std::vector<Column> motion_columns(const Packing<Dim>&); \
  template std::vector<double> motion_row(const Packing<Dim>&, const Evaluation<Dim>&);
// clang-format on
SUPPLE_BODY_MOTION(2)
SUPPLE_BODY_MOTION(3)
#undef SUPPLE_BODY_MOTION

}  // namespace supple
