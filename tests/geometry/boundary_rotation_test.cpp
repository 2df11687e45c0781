#include "supple/geometry/boundary_rotation.hpp"

#include <gtest/gtest.h>

#include "supple/core/random.hpp"
#include "supple/model/polygons.hpp"

namespace supple {
namespace {

/// A bent ring of seven vertices and a disc, in random motion.
System<2> ring_and_disc(std::uint64_t seed) {
  System<2> system;
  add_polygon(system, {3, -2}, 2, 7, 0.4, 0.5, {});
  add_disc_body(system, {1, 5}, 0.6);
  RandomStream draw(seed, Purpose::test, 0);
  for (int i = 0; i < 8; ++i) {
    system.state.position[i] += Vec2{draw.uniform(-0.2, 0.2), draw.uniform(-0.2, 0.2)};
    system.state.velocity[i] = {draw.uniform(-1, 1), draw.uniform(-1, 1)};
    system.state.spin[i] = draw.uniform(-1, 1);
  }
  return system;
}

constexpr Ring polygon{0, 7}, disc{7, 8};

/// Each kind of side: edges inside and over the end of the ring, its vertices, and the disc.
template <class Visit>
void for_each_side(const Instant& at, const Visit& visit) {
  BoundaryRotation rotation;
  for (std::int32_t k = 0; k < 7; ++k) {
    rotation.clear();
    rotation.add_edge(1, k, polygon.after(k), at);
    visit(rotation);
    rotation.clear();
    rotation.add_vertex(1, polygon, k, at);
    visit(rotation);
  }
  rotation.clear();
  rotation.add_vertex(1, disc, 7, at);
  visit(rotation);
}

TEST(BoundaryRotation, IsTheRateOfARigidRotationAboutAnyPoint) {
  System<2> system = ring_and_disc(1);
  for (int i = 0; i < 8; ++i) {
    system.state.velocity[i] = cross(1.7, system.state.position[i] - Vec2{-4, 9});
    system.state.spin[i] = 1.7;
  }
  for_each_side({system.state},
                [&](const BoundaryRotation& w) { EXPECT_NEAR(w.rate({system.state}), 1.7, 1e-14); });
}

TEST(BoundaryRotation, IsTheRateOfTheAngleOfEachEdge) {
  System<2> system = ring_and_disc(2);
  const double h = 1e-6;
  const auto angle = [&](std::int32_t a, std::int32_t b, double t) {
    const Vec2 e = Instant{system.state, -t}.edge(a, b);
    return std::atan2(e[1], e[0]);
  };
  const auto turning = [&](std::int32_t a, std::int32_t b) {
    return std::remainder(angle(a, b, h) - angle(a, b, -h), 2 * std::acos(-1.0)) / (2 * h);
  };
  for (std::int32_t k = 0; k < 7; ++k) {
    BoundaryRotation edge, vertex;
    const std::int32_t before = polygon.before(k), after = polygon.after(k);
    edge.add_edge(1, k, after, {system.state});
    EXPECT_NEAR(edge.rate({system.state}), turning(k, after), 1e-8);
    const double l = norm(Instant{system.state}.edge(before, k)),
                 m = norm(Instant{system.state}.edge(k, after));
    vertex.add_vertex(1, polygon, k, {system.state});
    EXPECT_NEAR(vertex.rate({system.state}), (l * turning(before, k) + m * turning(k, after)) / (l + m),
                1e-8);
  }
}

TEST(BoundaryRotation, TorqueActsAsForcesOfTheSamePowerThatAddToZeroAndToThatTorque) {
  const System<2> system = ring_and_disc(3);
  for_each_side({system.state}, [&](const BoundaryRotation& w) {
    std::vector<Vec2> force(8);
    std::vector<double> torque(8);
    Mat2 virial, expected;
    w.apply(0.9, system.state, force, torque, virial);
    Vec2 sum{};
    double turning = 0, power = 0;
    for (int i = 0; i < 8; ++i) {
      sum += force[i];
      turning += cross(system.state.position[i], force[i]) + torque[i];
      power += dot(force[i], system.state.velocity[i]) + torque[i] * system.state.spin[i];
      expected.add_outer(1, force[i], system.state.position[i]);
    }
    EXPECT_LT(norm(sum), 1e-15);
    EXPECT_NEAR(turning, 0.9, 1e-14);
    EXPECT_NEAR(power, 0.9 * w.rate({system.state}), 1e-14);
    for (int c = 0; c < 2; ++c)
      for (int d = 0; d < 2; ++d) EXPECT_NEAR(virial[c][d], expected[c][d], 1e-14);
  });
}

/// Straight steps turn a ring by the angle 2 atan(w dt/2) at the rate w about the positions between them.
TEST(BoundaryRotation, StraightStepsOfARotationTurnRingsAndDiscsAtOneRate) {
  System<2> system = ring_and_disc(4);
  const double angle = 0.3, dt = 0.1;
  const std::vector<Vec2> x = system.state.position;
  for (int i = 0; i < 8; ++i) {
    system.state.position[i] = std::cos(angle) * x[i] + std::sin(angle) * turned_left(x[i]);
    system.state.velocity[i] = (1 / dt) * (system.state.position[i] - x[i]);
    system.state.spin[i] = angle / dt;
  }
  const Instant between{system.state, 0.5 * dt};
  for_each_side(between, [&](const BoundaryRotation& w) {
    EXPECT_NEAR(w.rate(between), 2 * std::tan(0.5 * angle) / dt, 1e-13);
  });
}

}  // namespace
}  // namespace supple
