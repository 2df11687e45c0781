
#include "tests/support/sites_inside.hpp"

#include <gtest/gtest.h>

#include "tests/support/probe.hpp"

namespace supple {
namespace {

using namespace testing;

TEST(FindSitesInside, SeesThroughImagesAndIgnoresTheBodyItself) {
  System<2> system;
  system.box.length = {8, 9};
  system.box.strain = 0.3;
  add_body(system, square, 0.5);
  add_disc_body(system, {1.5 - 3 * 8 + 4 * 0.3 * 9, 2.9 + 4 * 9.0}, 0.5);
  add_disc_body(system, {1.5, 3.1}, 0.5);
  add_body(system, {{4, 1}, {6, 1}, {2.5, 1.5}}, 0.1);
  EXPECT_EQ(find_sites_inside(system), (std::vector<SiteInside>{{4, 0}, {8, 0}}));
  system.box.periodic = {false, false};
  EXPECT_EQ(find_sites_inside(system), (std::vector<SiteInside>{{8, 0}}));
}

}  // namespace
}  // namespace supple
