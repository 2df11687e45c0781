/// Stress of bodies: closed forms of two squares, the virial of the force field, and parts that add up.
#include "supple/observe/body_stress.hpp"

#include <gtest/gtest.h>

#include "supple/contact/rough_contacts.hpp"
#include "supple/model/rigid.hpp"
#include "supple/observe/shape_measures.hpp"
#include "supple/observe/summary.hpp"
#include "supple/solve/mover.hpp"
#include "tests/support/polygons.hpp"

namespace supple {
namespace {

using testing::polygon_field;
using testing::random_polygons;

void expect_near(const Mat2& a, const Mat2& b, double tolerance) {
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) EXPECT_NEAR(a[i][j], b[i][j], tolerance) << i << j;
}

Mat2 diagonal(double xx, double yy) { return {{{xx, 0}, {0, yy}}}; }

Mat2 sum_of(const std::vector<Mat2>& parts) {
  Mat2 sum;
  for (const Mat2& part : parts) sum += part;
  return sum;
}

constexpr double side = 10, k_a = 3, k_c = 5;

/// Unit squares side by side, `gap` between facing vertices of these radii, across the period of the cell;
/// preferred areas 0.9 and 1.2.
System<2> two_squares(double gap, double left, double right) {
  System<2> system;
  system.box.length = {side, side};
  const std::vector<double> one(4, 1), none(4, 0);
  double x = 8.7;
  for (const auto& [radius, rest] : {std::pair{left, 0.9}, {right, 1.2}}) {
    add_ring(system, {{x, 3}, {x + 1, 3}, {x + 1, 4}, {x, 4}}, radius, {k_a, 1, 0, 0}, rest, one, none);
    x += 1 + gap;
  }
  return system;
}

struct Evaluated {
  Evaluation<2> evaluation;
  BodyStresses<2> stress;
};

Evaluated evaluate(System<2>& system, const Harmonic& law, const WallLaw<2>* walls = nullptr) {
  ForceField<2> field = polygon_field(RoughContacts<2>(law));
  if (walls) field.set_walls(*walls);
  Evaluated out;
  field.evaluate(system, Detail::energies, out.evaluation);
  out.stress = body_stresses(system, field, out.evaluation);
  return out;
}

TEST(BodyStress, TwoSquares) {
  const double gap = 0.19, force = k_c * (0.2 - gap);
  System<2> system = two_squares(gap, 0.1, 0.1);
  system.state.velocity[2] = {0.5, -0.25};
  const BodyStresses<2> s = evaluate(system, {k_c, false}).stress;
  const double area = side * side;
  // Tension where the preferred area is larger than 1 would push outward: -(1/A) dU/d(strain) = -k_a (a - a0)
  // a.
  expect_near(s.shape, (1 / area) * diagonal(-k_a * (0.1 - 0.2), -k_a * (0.1 - 0.2)), 1e-16);
  expect_near(s.contact, (1 / area) * diagonal(2 * force * gap, 0), 1e-16);
  expect_near(s.wall, Mat2{}, 0);
  expect_near(s.kinetic, (1 / area) * Mat2{{{0.25, -0.125}, {-0.125, 0.0625}}}, 1e-16);
  expect_near(s.total(), s.kinetic + s.shape + s.contact, 1e-17);
  expect_near(s.moment[0], diagonal(-0.3 + force * gap, -0.3), 1e-14);
  expect_near(s.moment[1], diagonal(0.6 + force * gap, 0.6), 1e-14);
  EXPECT_NEAR(pressure(s.contact), force * gap / area, 1e-17);
  EXPECT_EQ(pressure(diagonal(1, 3)), 2);
  EXPECT_EQ(shear_stress(Mat2{{{0, 2}, {4, 0}}}), -3);
  const auto of_bodies = s.of_bodies(std::vector<double>{2, 4});
  EXPECT_NEAR(of_bodies[0][1][1], -0.15, 1e-15);
  EXPECT_NEAR(of_bodies[1][1][1], 0.15, 1e-15);
  EXPECT_THROW(s.of_bodies(std::vector<double>{2}), Error);
}

/// The contact line of circles of radius 0.15 and 0.05 at distance 0.19 is 0.19/2 + (0.15^2 - 0.05^2)/(2
/// 0.19) from the larger one.
TEST(BodyStress, LargerVerticesHaveMoreOfTheContact) {
  const double gap = 0.19, moment = 2 * k_c * (0.2 - gap) * gap;
  System<2> system = two_squares(gap, 0.15, 0.05);
  const BodyStresses<2> s = evaluate(system, {k_c, false}).stress;
  const double h = 0.5 * gap + (0.15 * 0.15 - 0.05 * 0.05) / (2 * gap);
  EXPECT_NEAR(s.moment[0][0][0] - s.moment[0][1][1], moment * h / gap, 1e-14);
  EXPECT_NEAR(s.moment[1][0][0] - s.moment[1][1][1], moment * (1 - h / gap), 1e-14);
}

TEST(BodyStress, IsTheVirialAndAddsUp) {
  for (const bool relative : {false, true}) {
    System<2> system = random_polygons();
    for (int i = 0; i < system.state.size(); ++i) system.state.velocity[i] = {0.1 * (i % 3), 0.2 * (i % 5)};
    system.box.strain_rate = 0.3;
    const auto [evaluation, s] = evaluate(system, {7, relative});
    const double area = system.box.volume(), scale = std::abs(evaluation.virial[0][0]) / area;
    EXPECT_GT(std::abs(pressure(s.contact)), 1e-3);
    expect_near(s.virial(), (1 / area) * evaluation.virial, 1e-13 * scale);
    expect_near((1 / area) * sum_of(s.moment), s.virial(), 1e-13 * scale);
    for (const Mat2& part : {s.kinetic, s.shape, s.contact, s.total()})
      EXPECT_NEAR(part[0][1], part[1][0], 1e-13 * scale);
    for (const Mat2& moment : s.moment) EXPECT_NEAR(moment[0][1], moment[1][0], 1e-12 * area * scale);
    // Weighted by any areas, the stresses of bodies are that of the cell.
    const std::vector<double> areas = measure_shapes(system).volume;
    const std::vector<Mat2> of_bodies = s.of_bodies(areas);
    Mat2 weighted;
    for (std::size_t b = 0; b < areas.size(); ++b) weighted += (areas[b] / area) * of_bodies[b];
    expect_near(weighted, s.virial(), 1e-13 * scale);
  }
}

/// What keeps a rigid body together carries the force of a contact to its centre: F times the distance of the
/// centres.
TEST(BodyStress, RigidSquares) {
  const double gap = 0.19, force = k_c * (0.2 - gap);
  System<2> system = two_squares(gap, 0.1, 0.1);
  make_rigid(system, 0);
  make_rigid(system, 1);
  const BodyStresses<2> s = evaluate(system, {k_c, false}).stress;
  const double area = side * side;
  expect_near(s.contact, (1 / area) * diagonal(2 * force * gap, 0), 1e-16);
  expect_near(s.shape, (1 / area) * diagonal(2 * force, 0), 1e-16);
  expect_near(s.moment[0], diagonal(force * (1 + gap), 0), 1e-14);
  expect_near(s.moment[1], diagonal(force * (1 + gap), 0), 1e-14);
}

/// -dU/d(strain) where rigid bodies move with their centres and neither turn nor stretch.
TEST(BodyStress, PressureOfRigidBodiesIsTheSlopeOfTheEnergy) {
  System<2> system = random_polygons();
  for (int b = 0; b < 9; ++b) make_rigid(system, b);
  for (double& spin : system.rigid.spin) spin = 0;
  const auto [evaluation, s] = evaluate(system, {7, false});
  EXPECT_NEAR(s.virial()[0][1], s.virial()[1][0], 1e-13 * pressure(s.virial()));
  EXPECT_GT(std::abs(pressure(s.shape)), 0.1 * pressure(s.contact));
  EXPECT_NEAR(pressure(evaluation.virial) / system.box.volume(), pressure(s.virial()),
              1e-13 * pressure(s.virial()));
  const auto energy_at = [&](double e) {
    System<2> strained = system;
    strained.box.length = (1 + e) * system.box.length;
    for (Vec2& centre : strained.rigid.centre) centre *= 1 + e;
    place_sites(strained);
    return evaluate(strained, {7, false}).evaluation.energy.stored();
  };
  const double step = 1e-6, slope = (energy_at(step) - energy_at(-step)) / (2 * step);
  EXPECT_NEAR(2 * pressure(s.virial()) * system.box.volume(), -slope, 1e-8 * std::abs(slope));
  const auto spun = [&](double spin) {
    for (double& w : system.rigid.spin) w = spin;
    place_sites(system);
    return evaluate(system, {7, false}).stress;
  };
  // Rotation is motion at no pressure: what it adds to the kinetic part the centripetal forces take away.
  const BodyStresses<2> at_rest = spun(0), turning = spun(2);
  EXPECT_NEAR(pressure(turning.total()), pressure(at_rest.total()), 1e-12 * pressure(turning.kinetic));
  EXPECT_GT(pressure(turning.kinetic), 1);
  EXPECT_NEAR(pressure(turning.kinetic) * system.box.volume(), kinetic_energy(system).spin,
              1e-12 * kinetic_energy(system).spin);
}

TEST(BodyStress, WallsPressToo) {
  System<2> system = random_polygons();
  system.box.strain = 0;
  system.box.periodic = {false, false};
  for (Vec2& x : system.state.position) x += Vec2{0.9, 0.9};
  WallLaw<2> walls;
  walls.floor_friction = 0.3;
  system.floor_contact.assign(static_cast<std::size_t>(system.state.size()), 2.0);
  const auto [evaluation, s] = evaluate(system, {7, false}, &walls);
  const double area = system.box.volume(), scale = std::abs(evaluation.virial[0][0]) / area;
  EXPECT_GT(std::abs(s.wall[0][0]), 1e-3);
  EXPECT_GT(std::abs(s.wall[1][1]), 1e-3);
  expect_near(s.virial(), (1 / area) * evaluation.virial, 1e-13 * scale);
  expect_near((1 / area) * sum_of(s.moment), s.virial(), 1e-13 * scale);
}

TEST(BodyStress, KineticTermIsRelativeToTheFlow) {
  System<2> system;
  system.box.length = {side, side};
  system.box.strain_rate = 0.5;
  add_disc_body(system, {4, 8}, 1);
  system.state.velocity[0] = {1.5 + 3, 4};  // the flow there: (8 - 5) 0.5
  const BodyStresses<2> s = evaluate(system, {1, false}).stress;
  expect_near(s.kinetic, (1 / (side * side)) * Mat2{{{9, 12}, {12, 16}}}, 1e-16);
  expect_near(s.virial(), Mat2{}, 0);
}

TEST(BodyStress, NeedsAFieldOfBodies) {
  System<2> system = two_squares(1, 0.1, 0.1);
  ForceField<2> discs{DiscContacts{}};
  EXPECT_THROW(body_stresses(system, discs, Evaluation<2>{}), Error);
}

}  // namespace
}  // namespace supple
