#include "supple/experiment/body_motion.hpp"

#include <cmath>
#include <numbers>

#include "supple/core/random.hpp"

namespace supple {

double body_time_step(const Case& c, Packing& packing) {
  return c.time.time_step > 0 ? c.time.time_step : c.time.step_factor * default_step(packing.system, *packing.field);
}

std::optional<PlasticLaw> plastic_law(const Case& c) {
  if (c.bodies.flow_time <= 0) return std::nullopt;
  return PlasticLaw{c.bodies.flow_time, c.bodies.yield_strain, c.bodies.yield_strain, c.bodies.yield_strain};
}

void draw_velocities(System<2>& system, double kinetic_energy, std::int64_t seed) {
  State<2>& s = system.state;
  Vec2 total{};
  double mass = 0;
  for (int i = 0; i < s.size(); ++i) {
    RandomStream draw(static_cast<std::uint64_t>(seed), Purpose::body_velocity, static_cast<std::uint64_t>(i));
    // Box and Muller: two Gaussians, each with half of the energy.
    const double size = std::sqrt(-2 * std::log(1 - draw.uniform()) * kinetic_energy / s.mass[i]);
    const double angle = 2 * std::numbers::pi * draw.uniform();
    s.velocity[i] = {size * std::cos(angle), size * std::sin(angle)};
    total += s.mass[i] * s.velocity[i];
    mass += s.mass[i];
  }
  for (Vec2& v : s.velocity) v -= (1 / mass) * total;
}

std::vector<Column> motion_columns() {
  return {{"time", "", "time"},
          {"kinetic_energy", "", "kinetic energy"},
          {"potential_energy", "", "energy of shapes, contacts, walls, gravity"},
          {"total_energy", "", "their sum"},
          {"pressure", "k_a a0", "full pressure (9.26), with its kinetic part"},
          {"height", "", "mean height of the vertices"}};
}

std::vector<double> motion_row(const Packing& packing, const Evaluation<2>& evaluation) {
  const System<2>& s = packing.system;
  const double kinetic = kinetic_energy(s), potential = evaluation.energy.stored();
  double height = 0;
  for (const Vec2& x : s.state.position) height += x[gradient] / s.state.size();
  const double moving = 2 * (kinetic - spin_energy(s));
  const double p = 0.5 * (evaluation.virial[0][0] + evaluation.virial[1][1] + moving) / s.box.volume() / packing.pressure_unit;
  return {s.time, kinetic, potential, kinetic + potential, p, height};
}

}  // namespace supple
