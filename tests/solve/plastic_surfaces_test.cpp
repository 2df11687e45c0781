#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "supple/geometry/hinge.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/moving_surfaces.hpp"

namespace supple {
namespace {

/// An icosahedron of volume 1, stretched along x and turned in space far from the origin.
System<3> stretched_shell(double stretch) {
  System<3> system;
  system.box = {.length = {50, 50, 50}, .periodic = {false, false, false}};
  testing::add_shell(system, 12, {});
  for (Vec3& x : system.state.position) x = Vec3{stretch * x[0], x[1], x[2]} + Vec3{30, -20, 10};
  return system;
}

TriangleMesh mesh_now(const System<3>& system) { return {system.state.position, system.topology.facet}; }

std::vector<double> angles_of(const System<3>& system) {
  const std::vector<Vec3>& x = system.state.position;
  std::vector<double> angles;
  for (const auto& [a, b, left, right] : system.topology.hinge)
    angles.push_back(hinge_angle<double>({x[a], x[b], x[left], x[right]}));
  return angles;
}

/// Closed form of dx0/dt = (x - x0 (1 + s yield))/tau while x stays.
double flowed(double rest, double size, double yield, double time) {
  if (std::abs(size / rest - 1) <= yield) return rest;
  const double edge = size > rest ? 1 + yield : 1 - yield;
  return size / edge + (rest - size / edge) * std::exp(-edge * time);
}

TEST(PlasticSurfaces, HeldFixedAreApproachedAsStated) {
  for (const double stretch : {1.6, 0.55}) {
    const PlasticLaw law{2, 0.1, 0.05, 0.07};
    for (const int steps : {1, 7, 400}) {
      System<3> system = stretched_shell(stretch);
      const Shape before = system.shape;
      for (int k = 0; k < steps; ++k) advance(system, law, 3.0 / steps);
      const std::vector<double> areas = face_areas(mesh_now(system)), angles = angles_of(system);
      int flowing = 0, resting = 0;
      for (std::size_t f = 0; f < areas.size(); ++f) {
        EXPECT_NEAR(system.shape.rest_facet[f], flowed(before.rest_facet[f], areas[f], 0.1, 1.5), 1e-13) << f;
        ++(system.shape.rest_facet[f] == before.rest_facet[f] ? resting : flowing);
      }
      EXPECT_GT(flowing, 0);
      EXPECT_NEAR(system.shape.rest_volume[0], flowed(1, stretch, 0.05, 1.5), 1e-12);
      for (std::size_t e = 0; e < angles.size(); ++e) {
        const double bent = angles[e] - before.rest_hinge[e];
        const double flow =
            std::abs(bent) > 0.07 ? (bent - std::copysign(0.07, bent)) * (1 - std::exp(-1.5)) : 0;
        EXPECT_NEAR(system.shape.rest_hinge[e], before.rest_hinge[e] + flow, 1e-13) << e;
      }
      EXPECT_GT(*std::max_element(angles.begin(), angles.end()), before.rest_hinge[0] + 0.1);
      EXPECT_LT(*std::min_element(angles.begin(), angles.end()), before.rest_hinge[0] - 0.1);
    }
  }
}

TEST(PlasticSurfaces, BelowYieldOrWithoutStiffnessNothingFlows) {
  System<3> system = stretched_shell(1.2);
  Shape before = system.shape;
  for (const PlasticLaw& law : {PlasticLaw{1, 0.3, 0.25, 0.6}, PlasticLaw{1}}) {
    advance(system, law, 10);
    EXPECT_EQ(system.shape.rest_facet, before.rest_facet);
    EXPECT_EQ(system.shape.rest_volume, before.rest_volume);
    EXPECT_EQ(system.shape.rest_hinge, before.rest_hinge);
  }
  system.shape.stiffness[0] = {};
  before = system.shape;
  advance(system, {1, 0, 0, 0}, 10);
  EXPECT_EQ(system.shape.rest_facet, before.rest_facet);
  EXPECT_EQ(system.shape.rest_volume, before.rest_volume);
  EXPECT_EQ(system.shape.rest_hinge, before.rest_hinge);
}

/// Why no mean is taken away from angles, as it is in 2D: every uniform change of the preferred angles makes
/// forces; one in proportion to the lengths of the edges makes none (sum l_e d(theta_e) = 0).
TEST(PlasticSurfaces, PreferredAnglesActUnlessTheyChangeAsTheEdges) {
  System<3> system = stretched_shell(1.3);
  RandomStream draw(5, Purpose::test);
  for (Vec3& x : system.state.position)
    for (int d = 0; d < 3; ++d) x[d] += draw.uniform(-0.05, 0.05);
  const auto force = [&](const std::vector<double>& change) {
    System<3> copy = system;
    for (std::size_t e = 0; e < change.size(); ++e) copy.shape.rest_hinge[e] += change[e];
    ForceField<3> field = testing::rough_surfaces();
    Evaluation<3> out;
    field.evaluate(copy, Detail::forces, out);
    return out.force;
  };
  const std::size_t edges = system.topology.hinge.size();
  std::vector<double> lengths;
  for (const auto& hinge : system.topology.hinge)
    lengths.push_back(norm(system.state.position[hinge[1]] - system.state.position[hinge[0]]));
  const std::vector<Vec3> before = force(std::vector<double>(edges, 0));
  EXPECT_LT(testing::largest(force(lengths), before), 1e-13);
  EXPECT_GT(testing::largest(force(std::vector<double>(edges, 0.7)), before), 1e-3);
}

/// An icosahedron pulled by tethers, held, and released: without a law it comes back, with one it does not.
struct Pulled {
  System<3> system;
  double before = 0, held = 0, after = 0;

  explicit Pulled(const PlasticLaw* law) {
    system.box = {.length = {20, 20, 20}, .periodic = {false, false, false}};
    testing::add_shell(system, 12, {10, 10, 10});
    before = width();
    ForceField<3> field = testing::rough_surfaces();
    for (int i : {0, opposite()})
      field.external().tethers.push_back(
          {i, Vec3{10, 10, 10} + 1.4 * (system.state.position[i] - Vec3{10, 10, 10}), 100});
    Mover dynamics(std::move(field), 2);
    if (law) dynamics.set_plasticity(*law);
    const double dt = default_step(system, dynamics.forces(), 0.3);
    run(dynamics, dt, 60);
    held = width();
    dynamics.forces().external().tethers.clear();
    run(dynamics, dt, 300);
    after = width();
  }
  int opposite() const {
    int found = 1;
    const auto distance = [&](int i) { return norm(system.state.position[i] - system.state.position[0]); };
    for (int i = 2; i < 12; ++i)
      if (distance(i) > distance(found)) found = i;
    return found;
  }
  double width() const { return norm(system.state.position[opposite()] - system.state.position[0]); }
  void run(Mover<3>& dynamics, double dt, double time) {
    const double end = system.time + time;
    while (system.time < end) dynamics.advance(system, dt);
  }
};

TEST(PlasticSurfaces, PulledShellKeepsItsNewShapeAndReturnsWithoutALaw) {
  const PlasticLaw law{2, 0.05, 0.02, 0.05};
  const Pulled elastic(nullptr), plastic(&law);
  EXPECT_GT(elastic.held, 1.3 * elastic.before);
  EXPECT_NEAR(elastic.after, elastic.before, 1e-6);
  EXPECT_GT(plastic.after, plastic.before + 0.6 * (plastic.held - plastic.before));
  const std::vector<double> areas = face_areas(mesh_now(plastic.system));
  for (std::size_t f = 0; f < areas.size(); ++f)
    EXPECT_LE(std::abs(areas[f] / plastic.system.shape.rest_facet[f] - 1), 0.05 + 1e-4);
}

}  // namespace
}  // namespace supple
