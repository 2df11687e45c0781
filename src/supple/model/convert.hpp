/// A system of discs in other units.
#pragma once
#include "supple/model/system.hpp"
#include "supple/model/units.hpp"

namespace supple {

/// Multiplies every quantity of the system by the ratio of its units; what contacts and links remember are
/// lengths. Shapes, rigid bodies and the floor stay as they are: systems that have them are in reduced units
/// alone.
template <int Dim>
void convert(System<Dim>& system, const Units& from, const Units& to) {
  const double length = from.length / to.length, mass = from.mass / to.mass, time = from.time / to.time;
  const double speed = from.speed() / to.speed(), inertia = from.inertia() / to.inertia();
  const auto scale = [](auto& values, double factor) {
    for (auto& v : values) v *= factor;
  };

  system.time *= time;
  system.lag *= time;
  system.box.length *= length;
  system.box.strain_rate /= time;
  scale(system.state.position, length);
  scale(system.state.velocity, speed);
  scale(system.state.mass, mass);
  scale(system.state.radius, length);
  scale(system.state.spin, 1 / time);
  scale(system.state.inertia, inertia);
  scale(system.pairs.history, length);
  for (Touch& touch : system.touches.rows) touch.elongation *= length;
  for (Link& link : system.links) link.rest *= length, link.elongation *= length;
}

}  // namespace supple
