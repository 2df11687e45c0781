/// Plates that hold vertices and rigid bodies of a sheared cell.
#include <gtest/gtest.h>

#include "supple/observe/energy_balance.hpp"
#include "supple/solve/mover.hpp"
#include "tests/support/moving_bodies.hpp"

namespace supple {
namespace {

using testing::shell_field;

/// Shells at rest in a periodic cell, three of them rigid; rows of bodies lie across y = 0.
System<2> suspension() {
  System<2> system = testing::warm_shells(9, 3, 0);
  system.box.length[0] *= 1.3;
  system.box.strain = 0;
  return system;
}

/// What is at a plate, in words of the definition: a vertex within its radius of y = 0 or y = Ly.
Mobility by_definition(const System<2>& s, int i) {
  const double y = s.state.position[i][gradient], top = s.box.length[gradient], r = s.state.radius[i];
  if (std::abs(y) < r) return Mobility::lower_plate;
  return std::abs(y - top) < r ? Mobility::upper_plate : Mobility::free;
}

TEST(BodyPlates, TakeVerticesThatTouchThemAndWholeRigidBodies) {
  System<2> s = suspension();
  capture_at_boundaries(s, Plates::none);
  EXPECT_FALSE(has_plates(s.state));
  capture_at_boundaries(s, Plates::capture);
  int held_rigid = 0, partly = 0;
  for (int b = 0; b < 9; ++b) {
    int taken = 0, touching = 0;
    for (int i = s.topology.begin[b]; i < s.topology.begin[b + 1]; ++i) {
      taken += s.state.mobility[i] != Mobility::free;
      touching += by_definition(s, i) != Mobility::free;
      if (rigid_index(s, b) < 0) EXPECT_EQ(s.state.mobility[i], by_definition(s, i));
    }
    if (rigid_index(s, b) < 0) partly += taken > 0 && taken < s.topology.body_size(b);
    else EXPECT_EQ(taken, touching > 0 ? s.topology.body_size(b) : 0);
    held_rigid += rigid_index(s, b) >= 0 && taken > 0;
  }
  EXPECT_GT(partly, 0);
  EXPECT_GT(held_rigid, 0);
  leave_plates(s);
  EXPECT_FALSE(has_plates(s.state));
}

TEST(BodyPlates, WhatTheyHoldMovesWithThemAndDoesNotTurn) {
  System<2> s = suspension();
  wrap_bodies(s);
  Mover mover(shell_field());
  mover.set_plates(Plates::capture);
  capture_at_boundaries(s, Plates::capture);
  const System<2> start = s;
  const double rate = 0.01, dt = 0.05;
  for (int k = 0; k < 200; ++k) {
    mover.evaluate(s);
    mover.advance(s, {rate, rate}, dt, 0.999);
  }
  const double way = 200 * dt * rate * 0.5 * s.box.length[gradient];
  for (int i = 0; i < s.state.size(); ++i) {
    const Mobility m = start.state.mobility[i];
    if (m == Mobility::free) continue;
    const Vec2 gone = s.box.displacement(start.state.position[i], s.state.position[i]);
    EXPECT_NEAR(gone[flow], m == Mobility::upper_plate ? way : -way, 1e-12);
    EXPECT_NEAR(gone[gradient], 0, 1e-12);
    EXPECT_EQ(s.state.mobility[i], m);
  }
}

/// Its lower plate is the upper one of the next cell.
TEST(BodyPlates, ABodyThatCrossesABoundaryIsHeldByTheOtherPlate) {
  System<2> s = suspension();
  capture_at_boundaries(s, Plates::capture);
  System<2> moved = s;
  const double shift = 0.6 * s.box.length[gradient];
  for (Vec2& x : moved.state.position) x[gradient] -= shift;
  for (Vec2& x : moved.rigid.centre) x[gradient] -= shift;
  const System<2> before = moved;
  wrap_bodies(moved);
  int changed = 0;
  for (int i = 0; i < s.state.size(); ++i) {
    const double up = moved.state.position[i][gradient] - before.state.position[i][gradient];
    if (!is_plate(before.state.mobility[i])) {
      EXPECT_EQ(moved.state.mobility[i], before.state.mobility[i]);
    } else if (std::abs(up) > 1) {
      EXPECT_NE(moved.state.mobility[i], before.state.mobility[i]);
      EXPECT_TRUE(is_plate(moved.state.mobility[i]));
      ++changed;
    } else {
      EXPECT_EQ(moved.state.mobility[i], before.state.mobility[i]);
    }
  }
  EXPECT_GT(changed, 0);
}

/// What plates and images exert is the slope of the energy where the strain moves them alone.
TEST(BodyPlates, TheirForceIsTheSlopeOfTheEnergyOfWhatTheyMove) {
  System<2> s = suspension();
  capture_at_boundaries(s, Plates::capture);
  ForceField<2> field = shell_field();
  Evaluation<2> e;
  const auto energy = [&](double strain) {  // only plates and images move
    System<2> moved = s;
    moved.box.strain += strain;
    const double way = 0.5 * strain * s.box.length[gradient];
    for_sites_apart(moved, [&](int i) {
      if (const Mobility m = moved.state.mobility[i]; is_plate(m))
        moved.state.position[i][flow] += m == Mobility::upper_plate ? way : -way;
    });
    for (int r = 0; r < moved.rigid.size(); ++r) {
      const Mobility m = moved.state.mobility[moved.topology.begin[moved.rigid.body[r]]];
      if (is_plate(m)) moved.rigid.centre[r][flow] += m == Mobility::upper_plate ? way : -way;
    }
    place_sites(moved);
    field.evaluate(moved, Detail::energies, e);
    return e.energy.stored();
  };
  const double h = 1e-6, slope = (energy(h) - energy(-h)) / (2 * h);
  field.evaluate(s, Detail::energies, e);
  EXPECT_GT(std::abs(plate_moment(s, e)), 1e-4);
  EXPECT_NEAR(plate_moment(s, e) + image_moment(s, e), slope, 1e-8);
}

}  // namespace
}  // namespace supple
