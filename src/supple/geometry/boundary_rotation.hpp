/// How fast a piece of a boundary turns, from the velocities of its vertices.
#pragma once
#include <cmath>
#include <cstdint>
#include <vector>

#include "supple/model/evaluation.hpp"
#include "supple/model/ring.hpp"
#include "supple/model/state.hpp"

namespace supple {

/// Sites at the time `back` before the present: positions x - back v; 0: as they are. The velocities of a
/// leapfrog belong to the middle of the last step. In a rigid rotation they are an exact rotation about the
/// positions of that instant, x - (dt/2) v, while about x there is an error of second order in dt. Velocities
/// of the instant of the positions themselves may be given as `motion`.
struct Instant {
  const State<2>& state;
  double back = 0;  ///< [time]
  const PresentMotion<2>* motion = nullptr;

  const Vec2& velocity(std::int32_t a) const { return motion ? motion->velocity[a] : state.velocity[a]; }

  Vec2 position(std::int32_t a) const { return state.position[a] - back * state.velocity[a]; }
  Vec2 edge(std::int32_t a, std::int32_t b) const {
    return state.position[b] - state.position[a] - back * (state.velocity[b] - state.velocity[a]);
  }
  /// Angular velocity of a disc that agrees with straight steps of other sites [1/time]. A point that moves
  /// straight, perpendicular to its arm, and reaches the angle w back in the time `back` had the angular
  /// velocity tan(w back)/back.
  double spin(std::int32_t a) const {
    if (motion) return motion->spin[a];
    return back > 0 ? std::tan(back * state.spin[a]) / back : state.spin[a];
  }
};

/// An angular velocity that is linear in velocities and spins of sites, w = sum W_k . v_k + sum S_k w_k, as a
/// sum of shares of edges, vertices and discs. A torque T on what turns by w acts as forces W_k T and torques
/// S_k T, whose power is T w. The forces add to zero. The torque of all together is T times the sum of the
/// shares.
class BoundaryRotation {
 public:
  void clear() {
    sites_.clear();
    spins_.clear();
  }
  /// Adds `share` times the rotation of the edge from a to b, (v_b - v_a) . m / l, l its length and m its
  /// normal on the left.
  void add_edge(double share, std::int32_t a, std::int32_t b, const Instant& at) {
    const Vec2 e = at.edge(a, b);
    add_difference(share / dot(e, e), a, b, e);
  }
  /// Adds `share` times the rotation of a vertex: the mean over its two edges, weighted by their lengths; of
  /// a disc, its spin.
  void add_vertex(double share, const Ring& ring, std::int32_t i, const Instant& at) {
    if (ring.is_disc()) {
      spins_.push_back({i, share});
      return;
    }
    const std::int32_t before = ring.before(i), after = ring.after(i);
    const Vec2 last = at.edge(before, i), next = at.edge(i, after);
    const double l = norm(last), m = norm(next), per_length = share / (l + m);
    add_difference(per_length / l, before, i, last);
    add_difference(per_length / m, i, after, next);
  }

  /// The angular velocity w [1/time].
  double rate(const Instant& at) const {
    double w = 0;
    for (const SiteShare& s : sites_) w += dot(s.weight, at.velocity(s.site));
    for (const SpinShare& s : spins_) w += s.share * at.spin(s.site);
    return w;
  }
  /// Adds the forces and torques that a torque T acts as, and sum f x^T of these forces to `virial` [energy].
  void apply(double torque, const State<2>& state, std::vector<Vec2>& forces, std::vector<double>& torques,
             Mat2& virial) const {
    for (const SiteShare& s : sites_) {
      forces[s.site] += torque * s.weight;
      virial.add_outer(torque, s.weight, state.position[s.site]);
    }
    for (const SpinShare& s : spins_) torques[s.site] += s.share * torque;
  }

 private:
  struct SiteShare {
    std::int32_t site;
    Vec2 weight;  ///< [1/length]
  };
  struct SpinShare {
    std::int32_t site;
    double share;
  };

  void add_difference(double factor, std::int32_t a, std::int32_t b, const Vec2& edge) {
    const Vec2 weight = factor * turned_left(edge);
    sites_.push_back({a, -weight});
    sites_.push_back({b, weight});
  }

  std::vector<SiteShare> sites_;
  std::vector<SpinShare> spins_;
};

}  // namespace supple
