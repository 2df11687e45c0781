#include <gtest/gtest.h>

#include <cmath>

#include "supple/core/error.hpp"
#include "supple/core/parallel.hpp"
#include "supple/observe/body_stress.hpp"
#include "supple/solve/body_objective.hpp"
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

double mean_height(const System<3>& system) {
  double sum = 0;
  for (const Vec3& x : system.state.position) sum += x[gradient] / system.state.size();
  return sum;
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

TEST(MovingSurface, ThatIsDampedComesToRestAtTheEnergyOfTheMinimiser) {
  for (const bool rough : {true, false}) {
    ForceField<3> field = rough ? rough_surfaces() : smooth_surfaces();
    field.set_walls({.repulsion = Harmonic{4, true}});
    System<3> system;
    system.box = {.length = {2, 3.6, 2.1}, .periodic = {false, false, false}};
    add_shell(system, 12, {1, 1, 1});
    add_shell(system, 12, {1, 2.6, 1.1}, 1.5);
    const auto minimised = [&](System<3>& s) {
      BodyObjective<3> objective(s, field, {1e-10, 1e-13});
      std::vector<double> x = objective.coordinates();
      field.invalidate();
      EXPECT_TRUE(minimise(objective, x, {}).converged);
      return objective.evaluation().energy.stored();
    };
    minimised(system);
    RandomStream draw(2, Purpose::test);
    for (Vec3& x : system.state.position)
      for (int d = 0; d < 3; ++d) x[d] += draw.uniform(-0.02, 0.02);
    System<3> other = system;
    field.invalidate();
    Mover dynamics(field, 0.2);
    const double dt = default_step(system, dynamics.forces(), 0.3);
    double before = total_energy(dynamics, system);
    const double start = before;
    for (int block = 0; block < 300; ++block) {
      for (int k = 0; k < 25; ++k) dynamics.advance(system, dt);
      const double now = total_energy(dynamics, system);
      EXPECT_LE(now, before * (1 + 1e-13));
      before = now;
    }
    const double least = minimised(other);
    EXPECT_GT(least, 0.01) << "they still touch";
    EXPECT_GT(start, 1.02 * least);
    EXPECT_LT(kinetic_energy(system).total(), 1e-8 * least);
    EXPECT_NEAR(before, least, 1e-7 * least);
  }
}

/// Shells, one of them heavier, and a sphere fall into a box and come to rest: the floor bears their weight,
/// the walls beside it push against each other.
TEST(MovingSurface, InABoxStandsOnTheFloorWithItsWeight) {
  for (const bool rough : {true, false}) {
    System<3> system;
    system.box = {.length = {2.9, 9, 2.1}, .periodic = {false, false, false}};
    add_shell(system, 12, {1.1, 1.2, 1});
    add_shell(system, 12, {1.8, 2.9, 1.1}, 1.5);
    add_sphere_body(system, {1.4, 4.5, 1}, 0.5);
    ForceField<3> field = rough ? rough_surfaces() : smooth_surfaces();
    field.set_walls({.repulsion = Harmonic{4, true}});
    const double g = 0.005;
    field.external().gravity = {0, -g, 0};
    Mover dynamics(std::move(field), 0.05);
    const double dt = default_step(system, dynamics.forces(), 0.5);
    double weight = 0;
    for (const double m : system.state.mass) weight += m * g;
    const double height = mean_height(system);
    for (int k = 0; k < 16000; ++k) dynamics.advance(system, dt);
    EXPECT_LT(kinetic_energy(system).total(), 1e-12);
    Vec3 on_walls{};
    double floor = 0;
    for (const SiteForce<3>& wall : dynamics.evaluate_energies(system).wall) {
      on_walls += wall.force;
      if (direction_of(wall) == gradient) floor += wall.force[gradient];
    }
    EXPECT_NEAR(floor, weight, 1e-6 * weight);
    EXPECT_LT(norm(on_walls - Vec3{0, weight, 0}), 1e-6 * weight);
    EXPECT_LT(mean_height(system), height - 0.1);
  }
}

TEST(MovingSurface, FallsLikeABodyThatFalls) {
  System<3> system;
  system.box = {.length = {10, 10, 10}, .periodic = {false, false, false}};
  add_sphere_body(system, {5, 9, 2}, 0.3);
  system.state.velocity[0] = {1, 2, -0.5};
  ForceField<3> field = rough_surfaces();
  field.external().gravity = {0, -3, 0.25};
  Mover dynamics(std::move(field));
  for (int k = 0; k < 100; ++k) dynamics.advance(system, 0.02);
  EXPECT_LT(norm(system.state.position[0] - Vec3{5 + 2, 9 + 2 * 2 - 0.5 * 3 * 4, 2 - 1 + 0.5 * 0.25 * 4}),
            1e-12);
  EXPECT_LT(norm(system.state.velocity[0] - Vec3{1, 2 - 6, 0}), 1e-12);
}

/// U = (k/2) |x - anchor|^2: a sphere at a tether goes round an ellipse.
TEST(MovingSurface, AtATetherOscillates) {
  System<3> system;
  system.box = {.length = {10, 10, 10}, .periodic = {false, false, false}};
  add_sphere_body(system, {5.3, 5, 5}, 0.3);
  system.state.mass[0] = 2;
  system.state.velocity[0] = {0, 0.4, -0.2};
  ForceField<3> field = rough_surfaces();
  field.external().tethers.push_back({0, {5, 5, 5}, 8});
  Mover dynamics(std::move(field));
  const double omega = 2;
  for (int k = 0; k < 1000; ++k) {
    dynamics.advance(system, 0.002);
    const double phase = omega * system.time;
    const Vec3 expected =
        Vec3{5 + 0.3 * std::cos(phase), 5, 5} + std::sin(phase) / omega * Vec3{0, 0.4, -0.2};
    ASSERT_LT(norm(system.state.position[0] - expected), 1e-5) << k;
  }
}

TEST(MovingSurface, BouncesFromWallsAndLeavesFixedSitesInPlace) {
  System<3> system;
  system.box = {.length = {4, 3.5, 3}, .periodic = {false, false, false}};
  add_shell(system, 42, {1.2, 1.2, 1.2});
  add_shell(system, 12, {2.9, 2.2, 1.7});
  heat(system, 0.3);
  system.state.mobility[3] = Mobility::fixed;
  const Vec3 pinned = system.state.position[3];
  ForceField<3> field = rough_surfaces();
  field.set_walls({});
  Mover dynamics(std::move(field));
  const double dt = default_step(system, dynamics.forces(), 0.1);
  dynamics.advance(system, dt);
  const double before = total_energy(dynamics, system);
  bool pushed[3] = {};
  for (int k = 0; k < 2000; ++k) {
    dynamics.advance(system, dt);
    for (const SiteForce<3>& wall : dynamics.evaluate_energies(system).wall)
      pushed[direction_of(wall)] = true;
  }
  EXPECT_TRUE(pushed[0] && pushed[1] && pushed[2]);
  EXPECT_NEAR(total_energy(dynamics, system), before, 1e-3 * before);
  EXPECT_EQ(system.state.position[3], pinned);
  EXPECT_EQ(system.state.velocity[3], Vec3{});
}

/// Whatever the number of threads, and whenever the list of neighbours is made.
TEST(MovingSurface, HasTheSameBitsInOneAndTwoThreadsAndFromTheStateOn) {
  const System<3> start = [] {
    System<3> s = touching_shells(4);  // 768 sites: three chunks
    heat(s, 0.1);
    return s;
  }();
  const ShearRates rates{0.1, 0.1};
  const auto moved = [&](int threads, int restart_at) {
    const WithThreads some(threads);
    System<3> s = start;
    Mover dynamics(rough_surfaces(), 0.1);
    dynamics.set_plasticity(PlasticLaw{1, 0.01, 0.01, 0.01});
    for (int k = 0; k < 30; ++k) {
      if (k == restart_at) {
        s.pairs = {};
        s.pairs.width = 0;
        dynamics.invalidate();
      }
      dynamics.advance(s, 0.01);
    }
    for (int k = 0; k < 30; ++k) {
      dynamics.evaluate(s, rates);
      dynamics.advance(s, rates, 0.01, 0.999);
    }
    return s;
  };
  const System<3> one = moved(1, -1);
  for (const auto& [threads, restart] : {std::pair{2, -1}, {1, 17}}) {
    const System<3> other = moved(threads, restart);
    EXPECT_EQ(one.state.position, other.state.position) << threads << ' ' << restart;
    EXPECT_EQ(one.state.velocity, other.state.velocity);
    EXPECT_EQ(one.shape.rest_facet, other.shape.rest_facet);
    EXPECT_EQ(one.shape.rest_hinge, other.shape.rest_hinge);
  }
}

TEST(MovingSurface, ALeapfrogCompletedByHalfAKickIsVelocityVerlet) {
  System<3> lagging = touching_shells(3), whole = lagging;
  Mover leapfrog(rough_surfaces()), verlet(rough_surfaces());
  for (int k = 0; k < 50; ++k) {
    leapfrog.evaluate(lagging);
    leapfrog.advance(lagging, {}, 0.01, 1);
    verlet.advance(whole, 0.01);
  }
  ASSERT_EQ(lagging.lag, 0.01);
  std::vector<Vec3> velocity, spin;
  leapfrog.evaluate(lagging);
  leapfrog.bring_to_instant(lagging, 0, velocity, spin);
  EXPECT_GT(largest(lagging.state.velocity, whole.state.velocity), 1e-4);
  EXPECT_LT(largest(velocity, whole.state.velocity), 1e-13);
  EXPECT_EQ(spin, whole.state.spin);
}

TEST(MovingSurface, RefusesWhatItCannotDo) {
  System<3> system = touching_shells(3);
  Mover dynamics(rough_surfaces());
  system.state.velocity[7] = {0, 0, 1e308};
  try {
    dynamics.advance(system, 10);
    FAIL() << "a position that is not finite";
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::numerics);
    EXPECT_NE(std::string(e.what()).find("site 7"), std::string::npos) << e.what();
  }
  system = touching_shells(3);
  system.rigid.body = {2};
  dynamics.invalidate();
  EXPECT_THROW(dynamics.advance(system, 0.01), Error) << "it has no orientation";
  EXPECT_THROW(default_step(system, dynamics.forces()), Error);
  system = touching_shells(3);
  system.box.strain_rate = 0.1;
  EXPECT_THROW(dynamics.advance(system, 0.01), Error);
}

}  // namespace
}  // namespace supple
