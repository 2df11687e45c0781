/// The motion at a contact of boundaries that turn, and the forces that answer it.
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "supple/contact/laws/touch.hpp"
#include "supple/geometry/boundary_rotation.hpp"
#include "supple/model/evaluation.hpp"
#include "supple/model/loss_power.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// Two sides, with site weights c_a that add to 1 on one side and to -1 on the other, and rotations w_i, w_j
/// of the boundaries there. With b = sum c_a x_a (of the images that meet) and shares s_i + s_j = 1, by
/// radius,
///     v = sum c_a v_a - jump over the boundary - (s_i w_i + s_j w_j) x b
/// is zero in every rigid motion, where sum c_a v_a = w x b. A force G on the positive side acts as the
/// forces c_a G, and as the torques -s_i b x G and -s_j b x G on the two sides, which balance the torque b x
/// G of the forces. Their power is G . (v + jump), whatever G.
struct TouchFrame {
  struct SiteWeight {
    std::int32_t site;
    double weight;
  };
  std::vector<SiteWeight> sites;
  Vec2 branch{};              ///< b [length]
  Vec2 normal{};              ///< toward the side of positive weight
  std::int32_t up = 0;        ///< cells between the two sides along the gradient
  Vec2 jump{};                ///< Box::velocity_jump of the cells subtracted from the positive side
  BoundaryRotation rotation;  ///< s_i w_i + s_j w_j [1/time]

  void clear() {
    sites.clear();
    rotation.clear();
    branch = normal = jump = {};
    up = 0;
  }
  /// How strongly v depends on the velocity of one site, relative to a plain contact with this reach
  /// [length]; at least 1. It is large where a site is held between two parts of one boundary whose pushes
  /// nearly cancel: the weights of the mean of both are then far above 1. They enter twice: as c_a, and in b
  /// and the rotations.
  double leverage(double reach) const {
    double largest = 1;
    for (const SiteWeight& s : sites) {
      double sum = 0;
      for (const SiteWeight& other : sites) sum += other.site == s.site ? other.weight : 0;
      largest = std::max(largest, std::abs(sum));
    }
    return largest * std::max(1.0, norm(branch) / reach);
  }
  /// sum c_a v_a - jump [length/time].
  Vec2 separation_velocity(const Instant& at) const {
    Vec2 v = -jump;
    for (const SiteWeight& s : sites) v += s.weight * at.velocity(s.site);
    return v;
  }
  /// The velocity v of TouchFrame [length/time]; the frame must be filled for this instant.
  Vec2 velocity(const Instant& at) const {
    return separation_velocity(at) - cross(rotation.rate(at), branch);
  }
  /// The same with the velocities of the instant of the positions, in a cell that shears at its rate.
  Vec2 present_velocity(const System<2>& system, const PresentMotion<2>& now) const {
    Vec2 rest = jump;
    rest[flow] -= up * now.strain_rate * system.box.length[gradient];
    return velocity({system.state, 0, &now}) + rest;
  }
  /// Adds the force G on the positive side, its reaction and their torques, and their virial: G b^T, and sum
  /// f x^T of the forces that the torques act as.
  void scatter(const Vec2& g, const State<2>& state, Evaluation<2>& out) const {
    for (const SiteWeight& s : sites) out.force[s.site] += s.weight * g;
    out.virial.add_outer(1, g, branch);
    rotation.apply(-cross(branch, g), state, out.force, out.torque, out.virial);
  }
};

/// The motion that dashpots see: of this instant where it is known, about the frame as it is; else `v`, of
/// the middle of the last step, about the frame as it was there.
inline TouchMotion present_motion_of(const TouchFrame& frame, const TouchFrame& moved, const Vec2& v,
                                     const System<2>& system, const PresentMotion<2>& now) {
  if (now.empty()) return {dot(v, moved.normal), dot(v, turned_left(moved.normal))};
  const Vec2 present = frame.present_velocity(system, now);
  return {dot(present, frame.normal), dot(present, turned_left(frame.normal))};
}

/// The motion at which the power of dashpots is booked: that of the last half step, in which their forces act
/// (EnergyBalance); `seen` by the dashpots where it is the only one.
inline TouchMotion booked_motion(const TouchFrame& frame, const Instant& at, const TouchMotion& seen,
                                 const PresentMotion<2>& now) {
  if (now.empty()) return seen;
  const Vec2 v = frame.velocity(at);
  return {dot(v, frame.normal), dot(v, turned_left(frame.normal))};
}

/// The forces of one touch by which it loses energy: along n on the positive side, and against t on it.
struct LossyTouch {
  TouchFrame frame;
  double viscous, tangential_viscous, sliding;

  /// At the velocities and the shear rate of now, with positions as in the frame.
  LossPower power(const System<2>& system) const {
    const Vec2 v = frame.velocity(Instant{system.state}) + frame.jump - system.box.velocity_jump(frame.up);
    const double v_t = dot(v, turned_left(frame.normal));
    return {viscous * dot(v, frame.normal), -tangential_viscous * v_t, -sliding * v_t};
  }
};

inline LossPower power_of(const std::vector<LossyTouch>& touches, const System<2>& system) {
  LossPower sum;
  for (const LossyTouch& touch : touches) sum += touch.power(system);
  return sum;
}

}  // namespace supple
