#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include "supple/solve/body_objective.hpp"
#include "tests/support/dense.hpp"
#include "tests/support/moving_surfaces.hpp"

namespace supple {
namespace {

/// The lowest mode with a stiffness, one in the middle and the stiffest of an undeformed shell, in which
/// nothing is under stress.
TEST(SurfaceModes, OscillatesAtTheFrequencyOfItsMode) {
  System<3> rest;
  rest.box.length = {10, 10, 10};
  testing::add_shell(rest, 42, {5, 5, 5}, 1.7);
  ForceField<3> field = testing::rough_surfaces();
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
