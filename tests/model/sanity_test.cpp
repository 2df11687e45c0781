#include "supple/model/sanity.hpp"

#include <gmock/gmock.h>

#include <functional>
#include <limits>

#include "supple/core/error.hpp"
#include "supple/model/bodies.hpp"
#include "supple/model/polygons.hpp"

namespace supple {
namespace {

using testing::HasSubstr;

System<2> triangle_and_disc() {
  System<2> system;
  system.box.length = {10, 10};
  const std::vector<double> lengths(3, 1.0), angles(3, 2.0);
  add_ring(system, {{1, 1}, {2, 1}, {1.5, 1.9}}, 0.1, {1, 1, 1, 0}, 0.5, lengths, angles);
  add_disc_body(system, {5, 5}, 0.5);
  return system;
}

std::string error_of(const std::function<void(System<2>&)>& spoil) {
  System<2> system = triangle_and_disc();
  spoil(system);
  try {
    require_sane(system, "this sample");
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::input);
    return e.what();
  }
  return "no error";
}

TEST(Sanity, OrdinarySystemsPass) {
  EXPECT_EQ(error_of([](System<2>&) {}), "no error");
}

TEST(Sanity, NumbersBeyondAllUseAreRefusedByName) {
  using S = System<2>;
  EXPECT_THAT(error_of([](S& s) { s.state.position[3][0] = 1e200; }),
              HasSubstr("the position of site 3 is 1e+200"));
  EXPECT_THAT(error_of([](S& s) { s.state.position[2][1] = -1e30; }),
              HasSubstr("site 2 lies at (1.5, -1e+30)"));
  EXPECT_THAT(error_of([](S& s) { s.state.radius[0] = 1e308; }), HasSubstr("the radius of site 0 is 1e+308"));
  EXPECT_THAT(error_of([](S& s) { s.state.radius[3] = 1e20; }), HasSubstr("radii are from 0.1 to 1e+20"));
  EXPECT_THAT(error_of([](S& s) { s.state.mass[1] = 0; }), HasSubstr("the mass of site 1 is 0"));
  EXPECT_THAT(error_of([](S& s) { s.state.mass[1] = 1e-200; }), HasSubstr("the mass of site 1 is 1e-200"));
  EXPECT_THAT(error_of([](S& s) { s.box.length[0] = 1e300; }), HasSubstr("its width is 1e+300"));
  EXPECT_THAT(error_of([](S& s) { s.box.length[1] = 1e20; }), HasSubstr("its cell is 10 x 1e+20"));
  EXPECT_THAT(error_of([](S& s) { s.box.strain = 1e12; }), HasSubstr("its strain is 1e+12"));
  EXPECT_THAT(error_of([](S& s) { s.state.velocity[0] = {1e45, 0}; }), HasSubstr("its kinetic energy is"));
  EXPECT_THAT(error_of([](S& s) { s.shape.rest_facet[1] = 0; }),
              HasSubstr("the preferred length of edge 1 is 0"));
  EXPECT_THAT(error_of([](S& s) { s.shape.stiffness[0].hinge = 1e100; }),
              HasSubstr("a stiffness of particle 0"));
  EXPECT_THAT(error_of([](S& s) {
                s = {};
                s.box.length = {1, 1};
              }),
              HasSubstr("it holds no particle"));
}

TEST(Sanity, NotANumberIsFoundEverywhere) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const auto array : {&State<2>::radius, &State<2>::mass, &State<2>::angle, &State<2>::inertia})
    EXPECT_THAT(error_of([&](System<2>& s) { (s.state.*array)[0] = nan; }), HasSubstr("of site 0 is nan"));
  for (const auto array : {&State<2>::position, &State<2>::velocity})
    EXPECT_THAT(error_of([&](System<2>& s) { (s.state.*array)[0][1] = nan; }), HasSubstr("of site 0 is nan"));
  EXPECT_THAT(error_of([&](System<2>& s) { s.box.strain = nan; }), HasSubstr("its strain is nan"));
  EXPECT_THAT(error_of([&](System<2>& s) { s.time = nan; }), HasSubstr("its time is nan"));
}

}  // namespace
}  // namespace supple
