/// The package's draw of a suspension.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "supple/compat/particleshear/protocol.hpp"

namespace supple {
namespace {

TEST(PackageDiscs, HaveItsRadiiMassesAndWholePositions) {
  Box<2> box;
  box.length = {500, 500};
  const DiscSpec spec{4000, 1.5, 1.4, 50};
  const System<2> system = package_discs(box, spec, 5);
  const double b = 1.4, unit_square = 250000 * 1.5 / 4000 / std::numbers::pi / (b + 1 / b) * 2,
               mean_mass = 50 * 250000 * 1.5 / 4000;
  int large = 0;
  for (int i = 0; i < spec.count; ++i) {
    const double r = system.state.radius[i];
    large += r * r > unit_square;
    EXPECT_NEAR(r * r / unit_square, r * r > unit_square ? b : 1 / b, 1e-12);
    EXPECT_NEAR(system.state.mass[i], mean_mass * r * r / unit_square, 1e-9 * mean_mass);
    EXPECT_EQ(system.state.position[i],
              (Vec2{std::floor(system.state.position[i][0]), std::floor(system.state.position[i][1])}));
  }
  EXPECT_NEAR(large, 2000, 5 * std::sqrt(1000.0));
  EXPECT_NE(large, 2000);  // independent draws, not an exact split
}

}  // namespace
}  // namespace supple
