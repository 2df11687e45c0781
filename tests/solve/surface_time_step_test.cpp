#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <string>

#include "supple/solve/degrees.hpp"
#include "tests/support/moving_surfaces.hpp"

namespace supple {
namespace {

/// Largest squared frequency by all eigenvalues of the mass-weighted Hessian.
double largest_square(System<3>& system, ForceField<3>& field) {
  const BodyDegrees<3> degrees(system);
  HessianBlocks<3> blocks;
  field.add_hessian(system, blocks);
  const std::vector<double> mass = degrees.masses(system);
  const auto n = static_cast<Eigen::Index>(mass.size());
  Eigen::MatrixXd h = Eigen::MatrixXd::Zero(n, n);
  for (const MatrixEntry& e : degrees.hessian(system, blocks, system.state.velocity)) {
    const double value = e.value() / std::sqrt(mass[e.row()] * mass[e.col()]);
    h(e.row(), e.col()) += value;
    if (e.row() != e.col()) h(e.col(), e.row()) += value;
  }
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(h, Eigen::EigenvaluesOnly).eigenvalues()[n - 1];
}

/// 8 k/m of the site where this is most: k = 1/sigma^2 of contacts relative to the diameter, and the wall.
double further_contacts(const System<3>& system, double wall) {
  double most = 0;
  for (int i = 0; i < system.state.size(); ++i) {
    const double sigma = 2 * system.state.radius[i];
    most = std::max(most, (8 / (sigma * sigma) + wall) / system.state.mass[i]);
  }
  return most;
}

struct Shells {
  const char* name;
  ShapeSpec shape;
};

/// Shells of 42 vertices in contact, shaken, some vertices lighter or held.
System<3> shaken(const ShapeSpec& shape, std::uint64_t seed) {
  System<3> system;
  system.box.length = {6, 6, 6};
  RandomStream draw(seed, Purpose::test);
  for (const Vec3& centre : {Vec3{2, 2, 2}, Vec3{3.4, 2.1, 1.9}, Vec3{2.6, 3.3, 2}}) {
    TriangleMesh mesh = geodesic_icosahedron(42);
    for (Vec3& x : mesh.vertex) x += centre;
    add_surface(system, mesh, 1, shape);
  }
  for (Vec3& x : system.state.position)
    for (int d = 0; d < 3; ++d) x[d] += draw.uniform(-0.03, 0.03);
  system.state.mass[5] = 0.3;
  system.state.mobility[60] = Mobility::fixed;
  return system;
}

TEST(SurfaceTimeStep, BoundIsAboveTheLargestFrequencyAndNear) {
  for (const auto& [name, shape] :
       {Shells{"shell", {.area = 1, .length = 1, .bending = 0.05}},
        Shells{"bending", {.area = 1, .length = 0.1, .bending = 1}},
        Shells{"volume", {.area = 50, .length = 0.1, .bending = 0.01}},
        Shells{"floppy", {.area = 1, .length = 1, .bending = 0, .tension = 0, .shape_parameter = 1.04}},
        Shells{"droplet", {.area = 1, .length = 0.1, .bending = 0, .tension = 0.2}}})
    for (const bool rough : {true, false}) {
      System<3> system = shaken(shape, 3);
      ForceField<3> field = rough ? testing::rough_surfaces() : testing::smooth_surfaces();
      Evaluation<3> out;
      field.evaluate(system, Detail::energies, out);
      EXPECT_GT(out.energy.elastic, 0) << name;
      const double square = largest_square(system, field), bound = frequency_bound(system, field);
      const double present = std::sqrt(bound * bound - further_contacts(system, 0)),
                   exact = std::sqrt(square);
      EXPECT_GE(present, exact * (1 - 1e-12)) << name;
      EXPECT_LE(present, 1.3 * exact) << name;
      EXPECT_DOUBLE_EQ(default_step(system, field, 0.5), 1 / bound);
    }
}

/// One shell alone, as it is made: nothing is under stress.
TEST(SurfaceTimeStep, BoundOfAnUndeformedShell) {
  System<3> system;
  system.box = {.length = {9, 9, 9}, .periodic = {false, false, false}};
  testing::add_shell(system, 42, {4, 4, 4});
  ForceField<3> field = testing::rough_surfaces();
  field.set_walls({.repulsion = Harmonic{3, false}});
  const double exact = std::sqrt(largest_square(system, field)), bound = frequency_bound(system, field);
  const double present = std::sqrt(bound * bound - further_contacts(system, 3));
  EXPECT_GE(present, exact * (1 - 1e-12));
  EXPECT_LE(present, 1.3 * exact);
  EXPECT_LE(bound, 2 * exact) << "with contacts and a wall that may come";
}

/// 8 k/m is the largest squared frequency of a face-centred cubic crystal of spheres that touch.
TEST(SurfaceTimeStep, FurtherContactsAreThoseOfTheDensestCrystal) {
  System<3> system;
  const double edge = std::sqrt(2.0) * 0.999;
  system.box.length = {3 * edge, 3 * edge, 4 * edge};
  for (int x = 0; x < 3; ++x)
    for (int y = 0; y < 3; ++y)
      for (int z = 0; z < 4; ++z)
        for (const Vec3& at : {Vec3{0, 0, 0}, Vec3{0.5, 0.5, 0}, Vec3{0.5, 0, 0.5}, Vec3{0, 0.5, 0.5}})
          add_sphere_body(system, edge * (Vec3{1.0 * x, 1.0 * y, 1.0 * z} + at), 0.5);
  ForceField<3> field{RoughContacts<3>(Harmonic{1, false})};
  const double square = largest_square(system, field);
  EXPECT_LE(square, 8);
  EXPECT_GT(square, 7.9);
  System<3> alone;
  alone.box.length = {9, 9, 9};
  add_sphere_body(alone, {1, 1, 1}, 0.5);
  field.invalidate();
  EXPECT_DOUBLE_EQ(frequency_bound(alone, field), std::sqrt(8.0));
}

}  // namespace
}  // namespace supple
