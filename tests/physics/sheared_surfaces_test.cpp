/// Surfaces in a sheared cell of three dimensions: flow x, gradient y, vorticity z.
#include <gtest/gtest.h>

#include <cmath>

#include "supple/observe/body_stress.hpp"
#include "tests/support/moving_surfaces.hpp"

namespace supple {
namespace {

using testing::largest;
using testing::rough_surfaces;
using testing::smooth_surfaces;

/// Shells of 12 vertices and spheres that touch, in a periodic cell, in random motion with the flow.
System<3> sheared_packing(double rate) {
  System<3> system;
  system.box.length = {5.4, 5.2, 5.6};
  system.box.strain = 0.13;
  for (int k = 0; k < 27; ++k) {
    const Vec3 at{1.8 * (k % 3) + 0.23 * (k / 3 % 3), 1.73 * (k / 3 % 3), 1.86 * (k / 9)};
    if (k % 5 == 4) add_sphere_body(system, at, 0.9);
    else testing::add_shell(system, 12, at);
  }
  testing::heat(system, 0.1);
  for (int i = 0; i < system.state.size(); ++i)
    if (system.state.radius[i] == 0.9) system.state.spin[i] = {0.1, 0.2, -0.3};
  set_strain_rate(system, rate);
  return system;
}

struct Outcome {
  System<3> system;
  Mat<3> virial;
  double energy = 0;
};

constexpr int steps = 400;

Outcome sheared(System<3> system, const ForceField<3>& field) {
  Mover dynamics(field);
  const double rate = system.box.strain_rate;
  for (int k = 0; k < steps; ++k) {
    dynamics.evaluate(system, {rate, rate});
    dynamics.advance(system, {rate, rate}, 0.01, 0.9995);
  }
  const Evaluation<3>& out = dynamics.evaluate_energies(system, {rate, rate});
  return {system, out.virial, out.energy.stored()};
}

/// The same sites as in `expected`, up to whole cells, and the same stress.
void expect_same(const Outcome& a, const Outcome& expected, const Vec3& shift = {}) {
  double most = 0, virial = 0;
  for (int i = 0; i < a.system.state.size(); ++i)
    most = std::max(most, norm(a.system.box.displacement(a.system.state.position[i],
                                                         expected.system.state.position[i] + shift)));
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) virial = std::max(virial, std::abs(a.virial[i][j] - expected.virial[i][j]));
  EXPECT_LT(most, 1e-9);
  EXPECT_LT(virial, 1e-8 * std::abs(expected.virial[0][0]));
  EXPECT_NEAR(a.energy, expected.energy, 1e-9 * expected.energy);
}

TEST(ShearedSurfaces, ShiftOfTheOriginAndImagesOfStrainChangeNothing) {
  const System<3> start = sheared_packing(0.2);
  for (const bool rough : {true, false}) {
    const ForceField<3> field = rough ? rough_surfaces() : smooth_surfaces();
    const Outcome reference = sheared(start, field);
    const double strain = reference.system.box.strain - start.box.strain;
    EXPECT_GT(reference.energy, 0.01);

    const Vec3 shift{1.3, 2.1, -3.2};
    System<3> shifted = start;
    for (int i = 0; i < shifted.state.size(); ++i) {
      shifted.state.position[i] += shift;
      shifted.state.velocity[i][flow] += shift[gradient] * shifted.box.strain_rate;
    }
    wrap_bodies(shifted);
    expect_same(sheared(shifted, field), reference, shift + Vec3{shift[gradient] * strain, 0, 0});

    if (!rough) continue;
    for (const int images : {1, -3}) {
      System<3> again = start;
      again.box.strain += images * start.box.length[flow] / start.box.length[gradient];
      expect_same(sheared(again, field), reference);
    }
  }
}

/// Without drag, which is about the middle of the cell, a motion of all along any direction changes nothing.
TEST(ShearedSurfaces, AMotionOfAllChangesNothing) {
  const System<3> start = sheared_packing(0.2);
  const ForceField<3> field = rough_surfaces();
  const auto undamped = [&](System<3> system) {
    Mover dynamics(field);
    for (int k = 0; k < steps; ++k) {
      dynamics.evaluate(system, {0.2, 0.2});
      dynamics.advance(system, {0.2, 0.2}, 0.01, 1);
    }
    const Evaluation<3>& out = dynamics.evaluate_energies(system, {0.2, 0.2});
    return Outcome{system, out.virial, out.energy.stored()};
  };
  const Outcome reference = undamped(start);
  const Vec3 velocity{1.1, 1.4, -1.6};  // about a cell
  System<3> moving = start;
  for (Vec3& v : moving.state.velocity) v += velocity;
  expect_same(undamped(moving), reference, (0.01 * steps) * velocity);
}

/// Particles that do not meet fly on straight, with the rigid rotation of the flow, whatever boundaries they
/// cross: their shapes stay, and so do the velocities of the images.
TEST(ShearedSurfaces, FreeShellsCrossBoundariesUnchanged) {
  System<3> system;
  system.box.length = {6, 5, 7};
  testing::add_shell(system, 42, {1, 1, 1});
  set_strain_rate(system, 0.4);
  const Vec3 drift{0.3, 1.1, -0.8};
  for (Vec3& v : system.state.velocity) v += drift;
  const BodyMotion<3> before = body_motion(system, 0);
  EXPECT_LT(norm(before.spin - Vec3{0, 0, -0.2}), 1e-14);
  Mover dynamics(rough_surfaces());
  const double energy =
      testing::total_energy(dynamics, system) - 0.5 * before.mass * dot(before.velocity, before.velocity);
  double crossed = 0;
  std::vector<double> error;
  for (int k = 0; k < 4000; ++k) {
    dynamics.evaluate(system, {0.4, 0.4});
    dynamics.advance(system, {0.4, 0.4}, 0.005, 1);
    if (k % 100) continue;
    const double time = system.time, up = std::floor((1 + (before.velocity[1]) * time) / 5);
    const BodyMotion<3> now = body_motion(system, 0);
    // The image `up` cells below moves by up Ly rate less along the flow.
    EXPECT_LT(norm(now.velocity - before.velocity + Vec3{up * 5 * 0.4, 0, 0}), 1e-10) << time;
    Vec3 free = before.centre + time * before.velocity;
    EXPECT_LT(norm(system.box.displacement(free, now.centre)), 1e-9) << time;
    const Evaluation<3>& out = dynamics.evaluate_energies(system, {0.4, 0.4});
    const double inner = kinetic_energy(system, out).total() + out.energy.stored() -
                         0.5 * now.mass * dot(now.velocity, now.velocity);
    EXPECT_NEAR(inner, energy, 1e-4 * energy) << time;
    crossed = up;
  }
  EXPECT_GE(crossed, 4);
}

/// Work of the images, of the shear rate, losses by drag: what is left over, root mean square over the run,
/// is an error of second order.
TEST(ShearedSurfaces, EnergyBalanceClosesToSecondOrder) {
  const auto residual = [](int per_unit) {
    System<3> system = sheared_packing(0);
    Mover dynamics(rough_surfaces());
    EnergyBalance<3> balance;
    dynamics.set_account(&balance);
    const double dt = 1.0 / per_unit;
    const auto rate = [](double time) { return 0.3 * std::sin(2 * time); };
    balance.open(system, dynamics.evaluate(system, {0, rate(0.5 * dt)}));
    double squares = 0;
    EnergyFlows flows;
    for (int k = 0; k < 4 * per_unit; ++k) {
      const ShearRates rates{rate(k * dt), rate((k + 0.5) * dt)};
      const Evaluation<3>& out = dynamics.evaluate(system, rates);
      flows = balance.flows(system, out);
      squares += std::pow(balance.residual(system, out), 2) / (4 * per_unit);
      dynamics.advance(system, rates, dt, std::exp(-0.1 * dt));
    }
    EXPECT_GT(std::abs(flows.images), 1e-3);
    EXPECT_GT(flows.background, 1e-3);
    return std::sqrt(squares);
  };
  const double coarse = residual(50), fine = residual(100), finer = residual(200);
  EXPECT_NEAR(coarse / fine, 4, 0.6);
  EXPECT_NEAR(fine / finer, 4, 0.6);
}

/// The stress in the flow of a packing in a sheared cell is that of its images: it does not depend on which
/// of them are in the cell, its kinetic part is of velocities relative to the flow.
TEST(ShearedSurfaces, KineticStressIsRelativeToTheFlow) {
  System<3> system = sheared_packing(0.2);
  ForceField<3> field = rough_surfaces();
  const auto stresses = [&] {
    Evaluation<3> out;
    field.invalidate();
    field.evaluate(system, Detail::energies, out);
    return body_stresses(system, field, out);
  };
  const BodyStresses<3> before = stresses();
  const double peculiar = kinetic_energy(system).peculiar;
  EXPECT_NEAR(before.kinetic[0][0] + before.kinetic[1][1] + before.kinetic[2][2],
              2 * peculiar / system.box.volume(), 1e-12);
  for (int b = 0; b < 27; b += 2) {  // into other cells, in which the flow has another speed
    const Vec3 back = system.box.lattice().vector({1, -2, 3});
    for (int i = system.topology.body_begin(b); i < system.topology.body_end(b); ++i) {
      system.state.position[i] -= back;
      system.state.velocity[i] -= system.box.velocity_jump(-2);
    }
  }
  const BodyStresses<3> after = stresses();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      EXPECT_NEAR(after.kinetic[i][j], before.kinetic[i][j], 1e-13) << i << j;
      EXPECT_NEAR(after.virial()[i][j], before.virial()[i][j], 1e-12) << i << j;
    }
  EXPECT_NEAR(kinetic_energy(system).peculiar, peculiar, 1e-12);
}

}  // namespace
}  // namespace supple
