#include "supple/draw/scene/layout.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace supple {
namespace {

/// Triangles of the same shape, their first vertex at these places.
Scene triangles(const std::vector<Vec2>& places, double strain) {
  Scene scene;
  scene.box.length = {10, 8};
  scene.box.strain = strain;
  scene.begin = {0};
  for (const Vec2& x : places) {
    for (const Vec2& corner : {Vec2{0, 0}, {1, 0}, {0.5, 0.8}}) scene.position.push_back(x + corner);
    scene.begin.push_back(scene.sites());
  }
  scene.radius.assign(scene.position.size(), 0.2);
  return scene;
}

TEST(Layout, ShowsABodyInTheMiddleOnceAndOneAtACornerFourTimes) {
  const std::vector<DrawnBody> images = lay_out_bodies(triangles({{5, 4}, {9.6, 7.7}}, 0), 0);
  ASSERT_EQ(images.size(), 5u);
  EXPECT_EQ(images[0].lies, Lies::inside);
  EXPECT_EQ(std::count_if(images.begin(), images.end(), [](const DrawnBody& i) { return i.body == 1; }), 4);
  for (const DrawnBody& image : images)
    if (image.body == 1) {
      EXPECT_EQ(image.lies, Lies::across);
    }
}

TEST(Layout, MovesWholeBodiesByLatticeVectorsAlone) {
  for (const double strain : {0.0, 0.3, -1.4}) {
    const Scene scene = triangles({{-31, 29}, {9.6, 7.7}, {0.1, -0.3}}, strain);
    for (const DrawnBody& image : lay_out_bodies(scene, 0.5))
      EXPECT_NEAR(norm(scene.box.displacement({0, 0}, image.shift)), 0, 1e-12) << image.shift[0];
  }
}

TEST(Layout, DrawsContactsBetweenTheImagesThatTouch) {
  for (const double strain : {0.0, 0.3, -1.4}) {
    // Across the flow period; and one above the other across the sheared one.
    Scene scene = triangles({{9.5, 4}, {0.9, 4}, {3 + 8 * strain, 7.1}, {3, 0.3}}, strain);
    scene.contacts = {{1, 3, 1}, {8, 9, 2}};
    const std::vector<ContactImage> images = lay_out_contacts(scene, 0.5);
    ASSERT_GE(images.size(), 4u);  // each shows at both sides
    for (const ContactImage& image : images) {
      const Vec2 expected = image.contact == 0 ? Vec2{0.4, 0} : Vec2{-0.5, 0.4};
      EXPECT_NEAR(norm(image.to - image.from - expected), 0, 1e-9) << image.contact;
    }
  }
}

TEST(Layout, DrawsAContactWithAnEdgeToThePointOnTheEdge) {
  Scene scene = triangles({{3, 3}, {3, 4.1}}, 0);
  scene.contacts = {{2, 3, 1, 0.25}, {0, 5, 1, 0.5}};  // the last edge goes from site 5 back to site 3
  const std::vector<ContactImage> images = lay_out_contacts(scene, 0);
  ASSERT_EQ(images.size(), 2u);
  EXPECT_NEAR(norm(images[0].to - Vec2{3.25, 4.1}), 0, 1e-12);
  EXPECT_NEAR(norm(images[1].to - Vec2{3.25, 4.5}), 0, 1e-12);
}

TEST(Layout, RepeatsNothingAlongADirectionThatIsNotPeriodic) {
  Scene scene = triangles({{9.6, 7.7}}, 0);
  scene.box.periodic = {true, false};
  EXPECT_EQ(lay_out_bodies(scene, 0).size(), 2u);
  scene.box.periodic = {false, false};
  EXPECT_EQ(lay_out_bodies(scene, 0).size(), 1u);
}

}  // namespace
}  // namespace supple
