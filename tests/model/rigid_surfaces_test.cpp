/// Rigid bodies in 3D.
#include <gmock/gmock.h>

#include "supple/core/error.hpp"
#include "supple/core/rotation.hpp"
#include "supple/model/bodies.hpp"
#include "supple/model/convert.hpp"
#include "supple/model/rigid.hpp"
#include "supple/model/sanity.hpp"
#include "tests/support/surfaces.hpp"

namespace supple {
namespace {

using ::testing::HasSubstr;

/// Convex, pitted and spiky surfaces, a sphere among them (body 3), of sites of unequal masses that move.
System<3> moving_surfaces() {
  System<3> system = testing::random_surfaces(6, 30, 5);
  RandomStream draw(9, Purpose::test);
  for (double& m : system.state.mass) m = draw.uniform(0.5, 2);
  for (Vec3& v : system.state.velocity)
    for (int d = 0; d < 3; ++d) v[d] = draw.uniform(-1, 1);
  return system;
}

Vec3 momentum(const System<3>& s) {
  Vec3 sum{};
  for (int i = 0; i < s.state.size(); ++i) sum += s.state.mass[i] * s.state.velocity[i];
  return sum;
}
Vec3 angular_momentum(const System<3>& s) {
  Vec3 sum{};
  for (int i = 0; i < s.state.size(); ++i)
    sum += s.state.mass[i] * cross(s.state.position[i], s.state.velocity[i]);
  return sum;
}

TEST(RigidSurfaces, OfGeodesicSpheresHaveTheInertiaOfAShellOfPoints) {
  System<3> system;
  testing::add_mesh(system, geodesic_icosahedron(42, 3), 0.1, {4, -5, 6});
  const std::vector<Vec3> before = system.state.position;
  make_rigid(system, 0);
  const RigidBodiesOf<3>& rigid = system.rigid;
  ASSERT_EQ(rigid.size(), 1);
  EXPECT_LT(norm(rigid.centre[0] - Vec3{4, -5, 6}), 1e-14);
  EXPECT_EQ(rigid.mass[0], 42);
  double square = 0;
  for (const Vec3& x : before) square += dot(x - rigid.centre[0], x - rigid.centre[0]);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      EXPECT_NEAR(rigid.inertia[0][i][j], i == j ? 2.0 / 3 * square : 0, 1e-13 * square);
  EXPECT_NEAR(gyration_radius(rigid, 0), std::sqrt(2.0 / 3 * square / 42), 1e-14);
  for (std::size_t i = 0; i < before.size(); ++i)
    EXPECT_LT(norm(system.state.position[i] - before[i]), 4e-15);
}

TEST(RigidSurfaces, KeepMomentumAndAngularMomentumOfTheirSites) {
  System<3> system = moving_surfaces();
  const Vec3 linear = momentum(system), turning = angular_momentum(system);
  for (const int b : {4, 0, 5, 2}) make_rigid(system, b);
  EXPECT_EQ(system.rigid.body, (std::vector<std::int32_t>{0, 2, 4, 5}));
  EXPECT_EQ(rigid_index(system, 4), 2);
  EXPECT_EQ(rigid_index(system, 1), -1);
  EXPECT_LT(norm(momentum(system) - linear), 1e-12 * norm(linear));
  EXPECT_LT(norm(angular_momentum(system) - turning), 1e-12 * norm(turning));
  EXPECT_GT(norm(system.rigid.spin[1]), 1e-3);
}

TEST(RigidSurfaces, PlaceTheirSitesByCentreAndAngle) {
  System<3> system = moving_surfaces();
  const int first = system.topology.begin[1], end = system.topology.begin[2];
  const std::vector<Vec3> before = system.state.position;
  make_rigid(system, 1);
  const Vec3 old = system.rigid.centre[0];
  RigidBodiesOf<3>& rigid = system.rigid;
  rigid.centre[0] = {-7, 22, 5};
  rigid.angle[0] = {0, 0, 0.5 * std::numbers::pi};
  rigid.velocity[0] = {1, -2, 3};
  rigid.spin[0] = {0.5, 0.1, -0.2};
  place_sites(system);
  for (int i = first; i < end; ++i) {
    const Vec3 o = before[i] - old, arm{-o[1], o[0], o[2]};
    EXPECT_LT(norm(system.state.position[i] - rigid.centre[0] - arm), 2e-14);
    EXPECT_LT(norm(system.state.velocity[i] - rigid.velocity[0] - cross(rigid.spin[0], arm)), 2e-14);
  }
}

/// Velocities that lag are those of the straight steps that sites made.
TEST(RigidSurfaces, SitesThatLagHaveTheVelocityOfTheirStep) {
  System<3> now = moving_surfaces();
  make_rigid(now, 1);
  now.rigid.angle[0] = {0.3, -1.2, 0.8};
  now.rigid.spin[0] = {2, -1, 3};
  System<3> before = now;
  now.lag = 0.2;
  place_sites(now);
  before.rigid.centre[0] -= now.lag * now.rigid.velocity[0];
  before.rigid.angle[0] = combined(now.rigid.angle[0], -now.lag * now.rigid.spin[0]);
  place_sites(before);
  for (int i = now.topology.begin[1]; i < now.topology.begin[2]; ++i) {
    const Vec3 step = now.state.position[i] - before.state.position[i];
    EXPECT_LT(norm(1 / now.lag * step - now.state.velocity[i]), 1e-13);
  }
}

TEST(RigidSurfaces, AddUpTheForcesOnTheirSites) {
  System<3> system = moving_surfaces();
  make_rigid(system, 2);
  const int first = system.topology.begin[2];
  std::vector<Vec3> force(system.state.position.size());
  force[0] = {5, 5, 5};
  force[first] = {1, 2, 3};
  force[first + 3] = {-4, 0.5, 1};
  const RigidForceOf<3> sum = force_on_rigid(system, force, 0);
  EXPECT_EQ(sum.force, (Vec3{-3, 2.5, 4}));
  const auto arm = [&](int i) { return system.state.position[i] - system.rigid.centre[0]; };
  EXPECT_LT(norm(sum.torque - cross(arm(first), force[first]) - cross(arm(first + 3), force[first + 3])),
            1e-14);
}

/// Without torque the angular momentum stays, and the spin does not, unless the body is round.
TEST(RigidSurfaces, SpinsChangeByEulersEquations) {
  System<3> system = moving_surfaces();
  make_rigid(system, 2);
  system.rigid.angle[0] = {0.4, 0.9, -0.5};
  system.rigid.spin[0] = {1, -0.7, 0.4};
  const Vec3 torque{0.3, 0.1, -2}, change = spin_change(system, 0, torque);
  ASSERT_GT(norm(spin_change(system, 0, Vec3{})), 1e-3);
  const auto angular_at = [&](double t) {
    System<3> then = system;
    then.rigid.centre[0] = then.rigid.velocity[0] = {};
    then.rigid.spin[0] += t * change;
    then.rigid.angle[0] = combined(then.rigid.angle[0], t * system.rigid.spin[0]);
    const Mat<3> inertia = turned(then.rigid.inertia[0], rotation(then.rigid.angle[0]));
    return inertia * then.rigid.spin[0];
  };
  const double h = 1e-5;
  const Vec3 rate = 1 / (2 * h) * (angular_at(h) - angular_at(-h));
  EXPECT_LT(norm(rate - torque), 1e-8 * norm(angular_at(0)));
}

TEST(RigidSurfaces, MoveAsWholesWithTheirCell) {
  System<3> system = moving_surfaces();
  for (double& m : system.state.mass) m = 1;  // the mean of the sites is the centre
  make_rigid(system, 1);
  system.rigid.angle[0] = {0.4, 0.9, -0.5};
  place_sites(system);
  const std::vector<Vec3> before = system.state.position;
  const Vec3 centre = system.rigid.centre[0], length = system.box.length;
  scale_cell(system, Vec3{1.1, 1.2, 0.9});
  EXPECT_LT(norm(system.rigid.centre[0] - Vec3{1.1 * centre[0], 1.2 * centre[1], 0.9 * centre[2]}), 1e-13);
  EXPECT_NEAR(system.box.length[2], 0.9 * length[2], 1e-14);
  for (int i = system.topology.begin[1]; i < system.topology.begin[2]; ++i)
    EXPECT_LT(norm(system.state.position[i] - before[i] - (system.rigid.centre[0] - centre)), 2e-14);
}

TEST(RigidSurfaces, RefuseWhatCannotBeOne) {
  System<3> system = moving_surfaces();
  make_rigid(system, 1);
  for (const int b : {-1, 1, 3, 6}) EXPECT_THROW(make_rigid(system, b), Error) << b;
  const int first = system.topology.begin[2];
  for (int i = first; i < system.topology.begin[3]; ++i)
    system.state.position[i] = Vec3{1, 2, 3} + static_cast<double>(i - first) * Vec3{1, -0.3, 0.7};
  EXPECT_THROW(make_rigid(system, 2), Error) << "on one line";
  EXPECT_EQ(system.rigid.size(), 1);
  EXPECT_EQ(system.rigid.begin.size(), 2U);
}

TEST(RigidSurfaces, HaveTheSamePlacesInOtherUnits) {
  System<3> system = moving_surfaces();
  make_rigid(system, 1);
  system.rigid.angle[0] = {0.4, 0.9, -0.5};
  place_sites(system);
  const double inertia = system.rigid.inertia[0][0][1];
  const Units other{"other", 3, 5, 7};
  convert(system, si_units(), other);
  EXPECT_NEAR(system.rigid.inertia[0][0][1], inertia / other.of(unit::inertia), 1e-14 * std::abs(inertia));
  const std::vector<Vec3> where = system.state.position;
  place_sites(system);
  for (std::size_t i = 0; i < where.size(); ++i) EXPECT_LT(norm(system.state.position[i] - where[i]), 1e-14);
}

TEST(RigidSurfaces, OfNumbersThatCannotBeAreRefused) {
  using R = RigidBodiesOf<3>;
  const auto error_of = [](auto&& spoil) {
    System<3> system = moving_surfaces();
    make_rigid(system, 1);
    spoil(system.rigid);
    try {
      require_sane(system, "this state");
    } catch (const Error& e) {
      return std::string(e.what());
    }
    return std::string("no error");
  };
  EXPECT_EQ(error_of([](R&) {}), "no error");
  EXPECT_THAT(error_of([](R& r) { r.inertia[0][2][2] = 0; }),
              HasSubstr("the inertia of rigid particle 0 is 0"));
  EXPECT_THAT(error_of([](R& r) { r.inertia[0][2][0] = 1e61; }),
              HasSubstr("the inertia of rigid particle 0 is 1e+61"));
  for (const auto vectors : {&R::angle, &R::spin})
    EXPECT_THAT(error_of([&](R& r) { (r.*vectors)[0][1] = 1e61; }),
                HasSubstr("an angle or spin of rigid particle 0 is 1e+61"));
}

}  // namespace
}  // namespace supple
