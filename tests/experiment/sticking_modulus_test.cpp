/// The elastic response of particles that stick and are linked: a slow, small oscillation against the tangent
/// stiffness of all that acts.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "supple/experiment/body_rheology.hpp"
#include "supple/experiment/experiments.hpp"

namespace supple {
namespace {

Case slow_small_shear() {
  Case c;
  c.general.experiment = "oscillatory_shear";
  c.general.physics = "deformable";
  c.given.insert("physics");
  c.bodies.count = 9;
  c.bodies.vertices = 10;
  c.jamming.pressure = 5e-2;
  c.jamming.step = 1e-2;
  c.jamming.packing_fraction = 0.4;
  c.particles.cut_lines = 3;
  c.particles.avoid_height_spanning_particles = false;
  c.material.friction = 1e3;  // nothing slips
  c.shear.amplitude = 1e-4;
  c.shear.relative_frequency = 5e-4;  // at 2e-3 soft motions do not keep up in some samples: up to 13 % off
  c.shear.pre_periods = 0.3;
  c.shear.periods = 2;
  c.shear.post_periods = 0;
  c.output.frames = 2;
  resolve_family(c);
  return c;
}

/// G = -(1/A) d(virial_xy)/d(strain) with the sites following the strain so that no force is left, from
/// central differences of forces and stress about the state with what its contacts remember. A displacement
/// is a motion over a short time, in which tangential springs wind up; there are no dashpots.
double tangent_modulus(Case c, const System<2>& end) {
  c.material.relative_viscosity = 0;
  InitialState state;
  state.system = end;
  system_of<2>(state).box.strain_rate = system_of<2>(state).lag = 0;
  for (Vec2& v : system_of<2>(state).state.velocity) v = {};
  Making making;
  making.flow = Flow::kept;
  Packing<2> packing = make_packing(c, &state, 0, making);
  add_rheology(body_laws(c, packing), packing);
  const System<2> rest = packing.system;
  const int n = 2 * rest.state.size();
  constexpr double h = 1e-7, time = 1e-3;

  // Forces, and stress as the last number, where one number of the sites, or the strain (n), is moved by
  // `by`.
  const auto moved = [&](int k, double by) {
    System<2> s = rest;
    s.lag = time;
    if (k < n) {
      s.state.position[k / 2][k % 2] += by;
      s.state.velocity[k / 2][k % 2] = by / time;
    } else {
      s.box.strain += by;
      s.box.strain_rate = by / time;
    }
    Evaluation<2> e;
    packing.field->evaluate(s, Detail::energies, e);
    Eigen::VectorXd out(n + 1);
    for (int i = 0; i < n; ++i) out[i] = e.force[i / 2][i % 2];
    out[n] = -0.5 * (e.virial[0][1] + e.virial[1][0]);
    return out;
  };
  Eigen::MatrixXd slope(n + 1, n + 1);
  for (int k = 0; k <= n; ++k) slope.col(k) = (moved(k, h) - moved(k, -h)) / (2 * h);
  // Two translations cost nothing: the least of all motions that leave no force.
  const Eigen::VectorXd follow =
      (-slope.topLeftCorner(n, n)).completeOrthogonalDecomposition().solve(slope.col(n).head(n));
  const double total = slope(n, n) + slope.row(n).head(n).dot(follow);
  return total / (rest.box.volume() * packing.pressure_unit);
}

/// Amplitude and frequency to zero: G' is that of the network of springs, of which those along contacts are a
/// third.
TEST(StickingModulus, SlowSmallShearIsThatOfTheTangentStiffness) {
  Case c = slow_small_shear();
  MemoryRecorder r;
  run(c, nullptr, r);
  const double modulus = tangent_modulus(c, r.last_system);
  EXPECT_NEAR(r.get("results", "storage_modulus_virial"), modulus, 0.02 * modulus);
  c.material.relative_transversal_link_strength = 0;
  EXPECT_LT(tangent_modulus(c, r.last_system), 0.8 * modulus);
}

}  // namespace
}  // namespace supple
