#include "supple/draw/solid/view.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "supple/core/error.hpp"

namespace supple {
namespace {

TEST(View, NamedOnesShowTheseAxesToTheRightAndUp) {
  const auto expect = [](const char* name, const Vec3& right, const Vec3& up) {
    const ViewAxes axes = axes_of(view_of(name));
    EXPECT_EQ(axes.right, right) << name;
    EXPECT_EQ(axes.up, up) << name;
    EXPECT_EQ(axes.towards, cross(right, up)) << name;
  };
  expect("x", {0, 1, 0}, {0, 0, 1});
  expect("y", {1, 0, 0}, {0, 0, 1});
  expect("z", {1, 0, 0}, {0, 1, 0});
}

TEST(View, AxesAreUnitVectorsAtRightAnglesWithZUp) {
  for (const View view : {View{}, View{33, -71}, View{-200, 90}, View{720.5, -89}}) {
    const ViewAxes axes = axes_of(view);
    EXPECT_NEAR(norm(axes.right), 1, 1e-15);
    EXPECT_NEAR(norm(axes.up - cross(axes.towards, axes.right)), 0, 1e-15);
    EXPECT_NEAR(dot(axes.right, axes.towards), 0, 1e-15);
    EXPECT_EQ(axes.right[2], 0);
    EXPECT_GE(axes.up[2], 0);
    EXPECT_NEAR(axes.towards[2], std::sin(view.elevation * std::acos(-1) / 180), 1e-15);
  }
}

TEST(View, TheCornerShowsXToTheRightYIntoThePictureAndZUp) {
  const ViewAxes axes = axes_of(view_of("corner"));
  EXPECT_GT(axes.right[0], 0.5);
  EXPECT_LT(axes.towards[1], -0.5);
  EXPECT_GT(axes.up[2], 0.5);
}

TEST(View, AnglesMayBeGivenAsText) {
  EXPECT_EQ(view_of("-60,25"), view_of("corner"));
  EXPECT_EQ(view_of("1e2,-12.5"), (View{100, -12.5}));
}

TEST(View, RefusesWhatIsNone) {
  for (const char* text : {"", "w", "1,2,3", "10", "10,", ",10", "10,91", "nan,0", "0,inf", " 1,2"}) try {
      view_of(text);
      FAIL() << text;
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), ErrorKind::input);
      EXPECT_THAT(e.what(), ::testing::AnyOf(::testing::HasSubstr("'corner', 'x', 'y', 'z'"),
                                             ::testing::HasSubstr("from -90 to 90")));
    }
  try {
    view_of("corned");
  } catch (const Error& e) {
    EXPECT_THAT(e.what(), ::testing::HasSubstr("did you mean 'corner'?"));
  }
}

}  // namespace
}  // namespace supple
