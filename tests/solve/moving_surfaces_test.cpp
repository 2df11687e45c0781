#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include "supple/core/error.hpp"
#include "supple/core/parallel.hpp"
#include "supple/observe/body_stress.hpp"
#include "supple/solve/body_objective.hpp"
#include "tests/support/dense.hpp"
#include "tests/support/moving_surfaces.hpp"

namespace supple {
namespace {

using testing::add_shell;
using testing::heat;
using testing::largest;
using testing::rough_surfaces;
using testing::smooth_surfaces;
using testing::surface_field;
using testing::total_energy;
using testing::touching_shells;

/// Two shells that are about to collide, off centre, in open space.
System<3> before_a_collision(double speed = 0.2) {
  System<3> system;
  system.box = {.length = {20, 20, 20}, .periodic = {false, false, false}};
  add_shell(system, 42, {9, 10, 10});
  add_shell(system, 42, {10.7, 10.5, 10.3});
  for (int i = 0; i < 42; ++i) {
    system.state.velocity[i] = {speed, 0.03, 0};
    system.state.velocity[42 + i] = {-speed, 0, 0.02};
  }
  return system;
}

class MovingSurfaces : public ::testing::TestWithParam<const char*> {
 protected:
  static ForceField<3> field() {
    return std::string(GetParam()) == "rough" ? rough_surfaces() : smooth_surfaces();
  }
};
INSTANTIATE_TEST_SUITE_P(Contacts, MovingSurfaces, ::testing::Values("rough", "smooth"),
                         [](const auto& i) { return std::string(i.param); });

/// Root mean square of the change of the energy over a collision of shells that vibrate.
double fluctuation(const System<3>& start, const ForceField<3>& field, double dt) {
  System<3> system = start;
  Mover dynamics(field);
  const double before = total_energy(dynamics, system);
  double sum = 0, squares = 0, elastic = 0;
  const auto steps = std::lround(8 / dt);
  for (int k = 0; k < steps; ++k) {
    dynamics.advance(system, dt);
    const Evaluation<3>& out = dynamics.evaluate_energies(system);
    const double change = out.energy.stored() + kinetic_energy(system).total() - before;
    sum += change;
    squares += change * change;
    elastic = std::max(elastic, out.energy.elastic);
  }
  EXPECT_GT(elastic, 0.01 * before) << "they collide";
  return std::sqrt(squares / steps - sum / steps * (sum / steps)) / before;
}

TEST_P(MovingSurfaces, EnergyOfACollisionIsKeptToSecondOrderOfTheStep) {
  System<3> start = before_a_collision();
  RandomStream draw(3, Purpose::test);
  for (Vec3& v : start.state.velocity)
    for (int d = 0; d < 3; ++d) v[d] += 0.15 * draw.uniform(-1, 1);
  const double coarse = fluctuation(start, field(), 0.01), fine = fluctuation(start, field(), 0.005),
               finer = fluctuation(start, field(), 0.0025);
  EXPECT_NEAR(coarse / fine, 4, 0.3);
  EXPECT_NEAR(fine / finer, 4, 0.3);
  EXPECT_LT(finer, 1e-5);
}

TEST_P(MovingSurfaces, CollisionsKeepMomenta) {
  System<3> system = before_a_collision();
  Mover dynamics(field());
  const Momenta<3> before = momenta(system);
  const double dt = default_step(system, dynamics.forces(), 0.1);
  const auto spin = [&] { return body_motion(system, 0).spin; };
  EXPECT_LT(norm(spin()), 1e-15);
  while (system.time < 8) dynamics.advance(system, dt);
  EXPECT_LT(norm(momenta(system).linear - before.linear), 1e-12);
  EXPECT_LT(norm(momenta(system).angular - before.angular), 1e-11);
  EXPECT_GT(norm(spin()), 0.01);
}

TEST_P(MovingSurfaces, RunBackwards) {
  System<3> system = before_a_collision();
  Mover dynamics(field());
  const std::vector<Vec3> before = system.state.position;
  for (int k = 0; k < 400; ++k) dynamics.advance(system, 0.01);
  EXPECT_GT(largest(before, system.state.position), 0.3);
  for (Vec3& v : system.state.velocity) v = -v;
  for (int k = 0; k < 400; ++k) dynamics.advance(system, 0.01);
  EXPECT_LT(largest(before, system.state.position), 1e-11);
}

/// The lowest mode with a stiffness, one in the middle and the stiffest of an undeformed shell, in which
/// nothing is under stress.
TEST(MovingSurface, OscillatesAtTheFrequencyOfItsMode) {
  System<3> rest;
  rest.box.length = {10, 10, 10};
  add_shell(rest, 42, {5, 5, 5}, 1.7);
  ForceField<3> field = rough_surfaces();
  BodyObjective<3> objective(rest, field, {});
  SparseMatrix lower;
  objective.hessian(objective.coordinates(), lower);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(testing::dense(lower));
  ASSERT_LT(modes.eigenvalues()[5], 1e-12);
  ASSERT_GT(modes.eigenvalues()[6], 1e-3);
  for (const int k : {6, 7, 70, 124, 125}) {
    const double omega = std::sqrt(modes.eigenvalues()[k] / 1.7), dt = 0.02 / omega;
    System<3> system = rest;
    const auto mode = [&](int i) {
      return Vec3{modes.eigenvectors()(3 * i, k), modes.eigenvectors()(3 * i + 1, k),
                  modes.eigenvectors()(3 * i + 2, k)};
    };
    const auto amplitude = [&] {
      double sum = 0;
      for (int i = 0; i < 42; ++i) sum += dot(mode(i), system.state.position[i] - rest.state.position[i]);
      return sum;
    };
    for (int i = 0; i < 42; ++i) system.state.position[i] += 1e-6 * mode(i);
    Mover dynamics(field);
    double before = amplitude(), first = -1, last = 0;
    for (int crossings = 0; crossings < 21;) {
      dynamics.advance(system, dt);
      const double now = amplitude();
      if ((before > 0) != (now > 0)) {
        last = system.time - dt * now / (now - before);
        if (crossings++ == 0) first = last;
      }
      before = now;
    }
    EXPECT_NEAR(20 * std::numbers::pi / (last - first), omega, 1e-4 * omega) << k;
  }
}

}  // namespace
}  // namespace supple
