/// Stress tensors of hand-made contacts: S1-16 to S1-25, which contacts count where, and exact zeros.
#include "supple/observe/stress.hpp"

#include <gtest/gtest.h>

namespace supple {
namespace {

constexpr double side = 100, area = side * side;

struct Scene {
  System<2> system;
  Evaluation<2> evaluation;

  int add_disc(Vec2 x, Vec2 v = {}, double radius = 5, Mobility mobility = Mobility::free) {
    State<2>& s = system.state;
    const int i = s.size();
    s.resize(i + 1);
    s.position[i] = x;
    s.velocity[i] = v;
    s.radius[i] = radius;
    s.mass[i] = 2;
    s.inertia[i] = s.mass[i] * radius * radius / 2;
    s.mobility[i] = mobility;
    evaluation.force.resize(i + 1);
    evaluation.torque.resize(i + 1);
    return i;
  }

  /// A contact of i < j with these forces; the total force and torque on each disc follow.
  void touch(int i, int j, double elastic, double viscous, double tangential) {
    const auto s = system.box.separation(system.state.position[i], system.state.position[j]);
    PairForce<2> p;
    p.distance = norm(s.r);
    p.normal = (1 / p.distance) * s.r;
    p.elastic = elastic;
    p.viscous = viscous;
    p.tangential = tangential;
    p.up = s.up;
    p.crosses = s.crosses;
    p.active = true;
    system.pairs.first.push_back(i);
    system.pairs.second.push_back(j);
    evaluation.pair.push_back(p);
    const Vec2 f = force_on_first(p);
    evaluation.force[i] += f;
    evaluation.force[j] -= f;
    const double sum = system.state.radius[i] + system.state.radius[j];
    evaluation.torque[i] += tangential * p.distance * system.state.radius[i] / sum;
    evaluation.torque[j] += tangential * p.distance * system.state.radius[j] / sum;
  }

  StressTensors tensors(double unit = 1) const { return stress_tensors(system, evaluation, unit); }
};

Scene empty_scene() {
  Scene scene;
  scene.system.box.length = {side, side};
  return scene;
}

void expect_near(const Mat2& a, const Mat2& b, double tolerance) {
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) EXPECT_NEAR(a[i][j], b[i][j], tolerance) << i << j;
}
void expect_zero(const Mat2& a) { expect_near(a, Mat2{}, 0); }
Mat2 matrix(double xx, double xy, double yx, double yy) { return {{{xx, xy}, {yx, yy}}}; }

TEST(Stress, CentralContactIsForceTimesLever) {
  Scene scene = empty_scene();
  scene.add_disc({40, 40}, {}, 5);
  scene.add_disc({46, 48}, {}, 7);  // distance 10, n = (0.6, 0.8)
  scene.touch(0, 1, 3, 1, 0);
  const StressTensors s = scene.tensors();
  const Mat2 expected = (4 * 10 / area) * matrix(0.36, 0.48, 0.48, 0.64);
  expect_near(s.love_weber, expected, 1e-17);
  expect_near(s.overall, expected, 1e-17);
  expect_near(s.linear_acceleration, expected, 1e-16);
  expect_near(s.virial, expected, 1e-17);
  expect_zero(s.external);
  expect_zero(s.internal_torque);
  EXPECT_EQ(s.pair_register, 8);
  EXPECT_EQ(s.external_register, 0);
}

TEST(Stress, CouplesMakeTheOverallTensorSymmetric) {
  Scene scene = empty_scene();
  scene.add_disc({40, 40}, {}, 5);
  scene.add_disc({46, 48}, {}, 7);
  scene.touch(0, 1, 0, 0, 2);
  scene.system.state.spin = {0.3, -0.2};
  const StressTensors s = scene.tensors();
  // F = 2 t on the first disc, t = (-0.8, 0.6), l = -(6, 8).
  expect_near(s.love_weber, (1 / area) * matrix(1.6 * 6, 1.6 * 8, -1.2 * 6, -1.2 * 8), 1e-17);
  expect_near(s.internal_torque, (1 / area) * matrix(0, -10, 10, 0), 1e-17);
  EXPECT_GT(std::abs(s.love_weber[0][1] - s.love_weber[1][0]), 1e-3);
  EXPECT_NEAR(s.overall[0][1], s.overall[1][0], 1e-15 * std::abs(s.love_weber[0][1]));
  const double energy = 0.5 * 25 * 0.09 + 0.5 * 49 * 0.04;
  expect_near(s.centrifugal, (1 / area) * matrix(-energy, 0, 0, -energy), 1e-17);
  expect_near(s.linear_acceleration, s.love_weber, 1e-16);
  EXPECT_NEAR(s.shear_periodic(), s.shear_internal(), 1e-17);
}

TEST(Stress, WhereAContactCounts) {
  // Across x, across y, with a plate, between two plate discs.
  Scene across_x = empty_scene();
  across_x.add_disc({2, 50});
  across_x.add_disc({97, 53});
  across_x.touch(0, 1, 3, 0, 1);
  StressTensors s = across_x.tensors();
  expect_zero(s.love_weber);
  expect_zero(s.overall);
  expect_zero(s.internal_torque);
  expect_near(s.external + s.linear_acceleration, Mat2{}, 1e-16);
  EXPECT_NE(s.tangential_torque[0][1], 0);
  expect_near(s.love_weber_periodic, s.virial, 0);
  EXPECT_GT(s.virial[0][0], 0);
  EXPECT_EQ(s.external_register, 8);

  Scene across_y = empty_scene();
  across_y.system.box.strain = 0.04;
  across_y.add_disc({50, 2});
  across_y.add_disc({50, 97});
  across_y.touch(0, 1, 3, 0, 1);
  s = across_y.tensors();
  expect_zero(s.love_weber);
  expect_zero(s.love_weber_periodic);
  EXPECT_GT(s.virial[1][1], 0);
  EXPECT_GT(s.external[1][1], 0);
  EXPECT_EQ(s.external_register, 8);

  Scene plate = empty_scene();
  plate.add_disc({50, 4}, {}, 5, Mobility::lower_plate);
  plate.add_disc({56, 12});
  plate.touch(0, 1, 3, 0, 1);
  s = plate.tensors();
  expect_zero(s.love_weber);
  // Force (0.6, 0.8) 3 - (-0.8, 0.6) on the free disc at (6, -38) from the centre.
  expect_near(s.external, (-1 / area) * matrix(2.6 * 6, -2.6 * 38, 1.8 * 6, -1.8 * 38), 1e-16);
  expect_near(s.linear_acceleration, -1 * s.external, 1e-16);
  EXPECT_EQ(s.external_register, 4);

  Scene plates = empty_scene();
  plates.add_disc({50, 4}, {}, 5, Mobility::lower_plate);
  plates.add_disc({58, 4}, {}, 5, Mobility::fixed);
  plates.touch(0, 1, 3, 0, 1);
  s = plates.tensors();
  expect_zero(s.external);
  expect_zero(s.linear_acceleration);
  EXPECT_EQ(s.external_register, 0);
  EXPECT_NEAR(s.virial[0][0], 24 / area, 1e-17);
}

TEST(Stress, KineticTermIsRelativeToTheFlow) {
  Scene scene = empty_scene();
  scene.system.box.strain_rate = 0.5;
  scene.add_disc({40, 80}, {15 + 3, 4});  // the flow there: (80 - 50) 0.5 = 15
  const StressTensors s = scene.tensors();
  expect_near(s.otsuki, (-2 / area) * matrix(9, 12, 12, 16), 1e-17);
  expect_zero(s.overall);
  expect_zero(s.external);
  expect_zero(s.linear_acceleration);
}

TEST(Stress, UnitScalesEveryTensor) {
  Scene scene = empty_scene();
  scene.add_disc({2, 50}, {1, 2});
  scene.add_disc({97, 53}, {3, 4});
  scene.add_disc({6, 56}, {3, 4});
  scene.system.state.spin = {1, 2, 3};
  scene.touch(0, 1, 3, 0, 1);
  scene.touch(0, 2, 3, 0, 1);
  const StressTensors one = scene.tensors(), two = scene.tensors(2);
  for (Mat2 StressTensors::*m :
       {&StressTensors::love_weber, &StressTensors::external, &StressTensors::linear_acceleration,
        &StressTensors::otsuki, &StressTensors::tangential_torque, &StressTensors::internal_torque,
        &StressTensors::centrifugal, &StressTensors::overall, &StressTensors::love_weber_periodic,
        &StressTensors::virial}) {
    expect_near(two.*m, 2 * one.*m, 1e-17);
    EXPECT_NE((one.*m)[0][0] + (one.*m)[0][1], 0);
  }
}

TEST(Stress, TensorsThatDoNotDependOnTheCut) {
  // Three discs in a row around x = 0; moving the cut by a quarter of the cell changes the published split
  // only.
  Scene cut = empty_scene(), moved = empty_scene();
  for (const double x : {95.0, 3.0, 11.0}) {
    cut.add_disc({x, 50 + 0.2 * x});
    moved.add_disc({std::fmod(x + 25, side), 50 + 0.2 * x});
  }
  cut.system.state.position[0][1] = moved.system.state.position[0][1] = 47;
  for (Scene* scene : {&cut, &moved}) {
    scene->touch(0, 1, 3, 0, 1);
    scene->touch(1, 2, 2, 0.5, -1);
  }
  const StressTensors a = cut.tensors(), b = moved.tensors();
  expect_near(a.love_weber_periodic, b.love_weber_periodic, 1e-16);
  expect_near(a.virial, b.virial, 1e-16);
  EXPECT_GT(std::abs(a.love_weber[0][0] - b.love_weber[0][0]), 1e-4);
  EXPECT_GT(std::abs(a.shear_external() - b.shear_external()), 1e-5);
}

TEST(Stress, PlatesPullByTheForceOverTheWidth) {
  // Free discs held between an upper and a lower plate: the force along the flow is the same on both sides of
  // each.
  Scene scene = empty_scene();
  scene.system.box.length = {side, 2 * side};
  scene.add_disc({50, 3}, {}, 5, Mobility::lower_plate);
  scene.add_disc({55, 11});
  scene.add_disc({45, 192});
  scene.add_disc({50, 198}, {}, 5, Mobility::upper_plate);
  scene.touch(0, 1, 3, 1, 0.5);
  scene.touch(2, 3, 7, 0, -0.25);
  const Vec2 on_lower = -1 * force_on_first(scene.evaluation.pair[0]),
             on_upper = force_on_first(scene.evaluation.pair[1]);
  EXPECT_NEAR(scene.tensors(10).plates, 10 * 0.5 * (on_upper[flow] - on_lower[flow]) / side, 1e-15);
}

TEST(Stress, APlateReachesItsSampleOverTheBoundary) {
  // The upper plate meets a disc at the lower side through the period: it is part of the plate there.
  Scene scene = empty_scene();
  scene.add_disc({50, 6});
  scene.add_disc({53, 99}, {}, 5, Mobility::upper_plate);
  scene.touch(0, 1, 4, 0, 0);
  EXPECT_NEAR(scene.tensors().plates, -0.5 * force_on_first(scene.evaluation.pair[0])[flow] / side, 1e-15);
  scene.add_disc({50, 2}, {}, 5,
                 Mobility::lower_plate);  // plates between themselves carry nothing for the sample
  scene.touch(1, 2, 9, 0, 1);
  EXPECT_NEAR(scene.tensors().plates, -0.5 * force_on_first(scene.evaluation.pair[0])[flow] / side, 1e-15);
}

}  // namespace
}  // namespace supple
