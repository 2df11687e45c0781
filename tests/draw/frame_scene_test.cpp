#include "supple/draw/scene/frame_scene.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "supple/core/error.hpp"
#include "tests/io/body_run.hpp"
#include "tests/io/sample_run.hpp"

namespace supple {
namespace {

using testing::body_frame;
using testing::body_info;

TEST(FrameScene, HasTheBodiesOfTheRunInTheCellOfTheFrame) {
  const Scene scene = scene_of(body_info(), body_frame(2));
  EXPECT_EQ(scene.begin, (std::vector<std::int32_t>{0, 4, 5, 8}));
  EXPECT_EQ(scene.box.length, (Vec2{10, 9.5}));
  EXPECT_EQ(scene.time, 0.5);
  EXPECT_EQ(scene.position, body_frame(2).position);
  EXPECT_EQ(scene.radius, body_info().radius);
  EXPECT_EQ(scene.of_bodies.size(), 3u);
  EXPECT_NO_THROW(check_scene(scene, "a.png"));
}

TEST(FrameScene, ContactsBearTheSizeOfTheirForce) {
  const Scene scene = scene_of(body_info(), body_frame(0));
  ASSERT_EQ(scene.contacts.size(), 2u);
  EXPECT_EQ(scene.contacts[1].first, 4);
  EXPECT_EQ(scene.contacts[1].second, 6);
  EXPECT_DOUBLE_EQ(scene.contacts[1].force, 0.5);
}

TEST(FrameScene, ContactsOfSitesThatAreNotThereAreRefused) {
  Scene scene = scene_of(body_info(), body_frame(0));
  EXPECT_NO_THROW(check_scene(scene, "a.png"));
  scene.contacts[1].second = 8;
  EXPECT_THROW(check_scene(scene, "a.png"), Error);
}

TEST(FrameScene, FractionAndPressureOfTheCellAreSumsOverItsBodies) {
  const CellNumbers cell = cell_numbers(scene_of(body_info(), body_frame(4)));
  EXPECT_DOUBLE_EQ(cell.packing_fraction, 20 / 90.0);
  EXPECT_DOUBLE_EQ(cell.pressure, (10 * 4e-3 + 5 * 2e-3 + 5 * 3e-3) / 90);
  Frame<2> frame = body_frame(4);
  frame.body.clear();
  EXPECT_TRUE(std::isnan(cell_numbers(scene_of(body_info(), frame)).packing_fraction));
}

TEST(FrameScene, DiscsKeepTheirCellTheirSpinAndTheirParticle) {
  RunInfo<2> info = testing::sample_info(6);
  Frame<2> frame = testing::sample_frame(6, 3);
  info.body_begin.clear();
  frame.length = {};
  frame.body.clear();
  const Scene scene = scene_of(info, frame);
  EXPECT_EQ(scene.bodies(), 6);
  EXPECT_EQ(scene.box.length, (Vec2{500, 400}));
  EXPECT_EQ(scene.box.strain, std::sin(3));
  ASSERT_EQ(scene.of_sites.size(), 6u);
  EXPECT_EQ(std::get<std::vector<std::int32_t>>(scene.of_sites[5].values), info.particle);
}

}  // namespace
}  // namespace supple
