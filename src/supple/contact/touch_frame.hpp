/// The motion at a contact of boundaries that turn, and the forces that answer it.
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "supple/geometry/boundary_rotation.hpp"
#include "supple/model/evaluation.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// Two sides, one of positive and one of negative weights c_a, each adding to 1, and the rotation w of the
/// boundary on either side. With b = sum c_a x_a (nearest images) and shares s_i + s_j = 1 of it,
///     v = sum c_a v_a - jump over the boundary - (s_i w_i + s_j w_j) x b
/// is zero in every rigid motion, as sum c_a v_a = w x b there. A force G on the positive side acts as c_a G,
/// and as the torques -s_i b x G, -s_j b x G on the sides, which balance the torque b x G of those: G . v
/// (with the jump) is the power of all these forces, whatever G.
struct TouchFrame {
  struct SiteWeight {
    std::int32_t site;
    double weight;
  };
  std::vector<SiteWeight> sites;
  Vec2 branch{};              ///< b [length]
  Vec2 normal{};              ///< toward the side of positive weight
  Vec2 jump{};                ///< velocity of the image of the positive side relative to its original
  BoundaryRotation rotation;  ///< s_i w_i + s_j w_j

  void clear() {
    sites.clear();
    rotation.clear();
    branch = normal = jump = {};
  }
  /// How much more than a plain contact of that reach the velocity v follows a site, at least 1: more where a
  /// site is held between two parts of one boundary, whose pushes nearly cancel, so that their mean is far
  /// outside of both. Once by the weights c_a and once by b times the rotations, which have them too.
  double leverage(double reach) const {
    double largest = 1;
    for (const SiteWeight& s : sites) {
      double sum = 0;
      for (const SiteWeight& other : sites) sum += other.site == s.site ? other.weight : 0;
      largest = std::max(largest, std::abs(sum));
    }
    return largest * std::max(1.0, norm(branch) / reach);
  }
  /// sum c_a v_a - jump.
  Vec2 separation_velocity(const State<2>& state) const {
    Vec2 v = -jump;
    for (const SiteWeight& s : sites) v += s.weight * state.velocity[s.site];
    return v;
  }
  /// v as above, where the frame is of that instant.
  Vec2 velocity(const Instant& at) const {
    return separation_velocity(at.state) - cross(rotation.rate(at), branch);
  }
  /// Adds the force G on the positive side, its reaction and their torques, and their virial, which is sum
  /// f x^T of all forces of a pair that is not across the boundary.
  void scatter(const Vec2& g, const State<2>& state, Evaluation<2>& out) const {
    for (const SiteWeight& s : sites) out.force[s.site] += s.weight * g;
    out.virial.add_outer(1, g, branch);
    rotation.apply(-cross(branch, g), state, out.force, out.torque, out.virial);
  }
};

}  // namespace supple
