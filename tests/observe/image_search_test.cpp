#include <gtest/gtest.h>

#include <algorithm>

#include "supple/core/random.hpp"
#include "supple/model/polygons.hpp"
#include "supple/observe/body_images.hpp"

namespace supple {
namespace {

/// Discs and polygons, some as wide as `widest`, anywhere in and beside the cell.
System<2> scattered(double widest, bool periodic) {
  System<2> system;
  system.box.length = {40, 30};
  system.box.periodic = {periodic, periodic};
  system.box.strain = 0.3;
  RandomStream draw(3, Purpose::test);
  for (int b = 0; b < 120; ++b) {
    const double size = b % 40 == 0 ? widest : draw.uniform(0.2, 1);
    const double x = draw.uniform(-20, 60);
    const Vec2 centre{x, draw.uniform(-10, 40)};
    if (b % 2) add_disc_body(system, centre, size);
    else add_polygon(system, centre, size * size, 7, draw.uniform(0, 6), 1, {});
  }
  return system;
}

TEST(ImageSearch, FindsTheCopiesWhoseBoundsMeetFromLeftToRight) {
  for (const double widest : {1.0, 9.0})
    for (const bool periodic : {true, false}) {
      const System<2> system = scattered(widest, periodic);
      const std::vector<BodyShape> shapes = body_shapes(system, Outline::rough);
      std::vector<BodyImage> all = images_in(bounds_of(shapes), shapes, system.box), found;
      std::stable_sort(all.begin(), all.end(), [](const BodyImage& a, const BodyImage& b) {
        return a.bounds.low[0] < b.bounds.low[0];
      });
      const ImageSearch search(shapes, system.box);
      for (int body = 0; body < static_cast<int>(shapes.size()); ++body) {
        search.find(body, found);
        std::size_t k = 0;
        for (const BodyImage& image : all) {
          const bool itself = image.body == body && image.shift == Vec2{};
          if (itself || !image.bounds.meets(shapes[body].bounds)) continue;
          ASSERT_LT(k, found.size());
          EXPECT_EQ(found[k].body, image.body);
          EXPECT_EQ(found[k].shift, image.shift);
          ++k;
        }
        EXPECT_EQ(k, found.size());
      }
    }
}

}  // namespace
}  // namespace supple
