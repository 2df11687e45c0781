/// Two bodies that push each other: the force between them along and across the line of their centres, and
/// the height at which they begin to touch.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "supple/observe/body_shapes.hpp"
#include "supple/observe/contact_network.hpp"

namespace supple {

/// The force of one body on another [MacKeith 2025, eq. 9.10-9.12].
struct MutualForce {
  Vec2 force{};         ///< on the body that is asked for [force]
  Vec2 normal{};        ///< unit vector to its centre from that of the other body
  double distance = 0;  ///< of the two centres [length]
  int contacts = 0;     ///< of single vertices

  double normal_force() const { return dot(force, normal); }
  /// Along t, for which n x t is the unit vector toward the reader: n turned counter-clockwise.
  double tangential_force() const { return normal[0] * force[1] - normal[1] * force[0]; }
  /// mu_eff = F_t/F_n; 0 without a force along n, as where nothing touches.
  double friction() const { return normal_force() != 0 ? tangential_force() / normal_force() : 0; }
};

/// The force on body `on` by body `by`. The centre of a body is the mean of its sites.
MutualForce force_on(const System<2>& system, const std::vector<SiteContact<2>>& contacts, int on, int by);

/// The largest mu_eff of a rough vertex that leaves the groove between two others [MacKeith 2025, eq. 9.13]:
/// s/sqrt(sigma^2 - s^2), s half the distance of these two and sigma that at which vertices touch [length],
/// with s = R sin(pi/N) in a regular polygon. Nullopt where the vertex passes between the two.
std::optional<double> rough_friction_bound(double half_edge, double sigma);

/// A boundary as first_touch() takes it: vertices counter-clockwise, and the radius of each.
struct TouchingRing {
  std::span<const Vec2> vertices;
  double radius = 0;
};
/// The greatest y at which `upper`, displaced by (0, y) and let down from above, touches `lower` [length]:
/// rough, two vertices at the sum of the radii; smooth, also a vertex and an edge. Nullopt where they pass.
std::optional<double> first_touch(const TouchingRing& lower, const TouchingRing& upper, Outline outline);

}  // namespace supple
