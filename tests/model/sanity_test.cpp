#include "supple/model/sanity.hpp"

#include <gmock/gmock.h>

#include <functional>
#include <limits>

#include "supple/core/error.hpp"
#include "supple/model/bodies.hpp"
#include "supple/model/polygons.hpp"
#include "supple/model/rigid.hpp"

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
  EXPECT_THAT(error_of([](S& s) { s.box.length[1] = 0; }),
              HasSubstr("its height is 0 (it must be positive)"));
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
  for (const auto array :
       {&State<2>::radius, &State<2>::mass, &State<2>::angle, &State<2>::inertia, &State<2>::spin})
    EXPECT_THAT(error_of([&](System<2>& s) { (s.state.*array)[0] = nan; }), HasSubstr("of site 0 is nan"));
  for (const auto array : {&State<2>::position, &State<2>::velocity})
    EXPECT_THAT(error_of([&](System<2>& s) { (s.state.*array)[0][1] = nan; }), HasSubstr("of site 0 is nan"));
  EXPECT_THAT(error_of([&](System<2>& s) { s.box.strain = nan; }), HasSubstr("its strain is nan"));
  EXPECT_THAT(error_of([&](System<2>& s) { s.box.strain_rate = nan; }), HasSubstr("its strain rate is nan"));
  EXPECT_THAT(error_of([&](System<2>& s) { s.time = nan; }), HasSubstr("its time is nan"));
  EXPECT_THAT(error_of([&](System<2>& s) {
                s.pairs.history = {0, nan};
              }),
              HasSubstr("the elongation of contact 1 is nan"));
}

TEST(Sanity, EveryNumberOfAShapeIsLookedAt) {
  using K = ShapeStiffness;
  for (const auto stiffness : {&K::volume, &K::facet, &K::hinge, &K::tension})
    EXPECT_THAT(error_of([&](System<2>& s) { s.shape.stiffness[0].*stiffness = -1e61; }),
                HasSubstr("a stiffness of particle 0 is -1e+61"));
  EXPECT_THAT(error_of([](System<2>& s) { s.shape.rest_volume[0] = 1e-61; }),
              HasSubstr("the preferred area of particle 0 is 1e-61"));
  EXPECT_THAT(error_of([](System<2>& s) { s.shape.rest_facet[2] = -1; }),
              HasSubstr("the preferred length of edge 2 is -1 (it must be positive)"));
  EXPECT_THAT(error_of([](System<2>& s) { s.shape.rest_hinge[1] = 1e61; }),
              HasSubstr("the preferred angle of corner 1 is 1e+61"));
}

TEST(Sanity, EveryNumberOfARigidParticleIsLookedAt) {
  using R = RigidBodies;
  const auto error_of_rigid = [](const std::function<void(R&)>& spoil) {
    return error_of([&](System<2>& s) {
      make_rigid(s, 0);
      spoil(s.rigid);
    });
  };
  EXPECT_EQ(error_of_rigid([](R&) {}), "no error");
  EXPECT_THAT(error_of_rigid([](R& r) { r.mass.at(0) = 0; }), HasSubstr("the mass of rigid particle 0 is 0"));
  EXPECT_THAT(error_of_rigid([](R& r) { r.inertia.at(0) = -2; }),
              HasSubstr("the inertia of rigid particle 0 is -2"));
  for (const auto vectors : {&R::centre, &R::velocity, &R::offset})
    EXPECT_THAT(error_of_rigid([&](R& r) { (r.*vectors).at(0)[1] = 1e61; }),
                HasSubstr("a vector of rigid particle 0 is 1e+61"));
  for (const auto numbers : {&R::angle, &R::spin})
    EXPECT_THAT(error_of_rigid([&](R& r) { (r.*numbers).at(0) = 1e61; }),
                HasSubstr("an angle or spin of rigid particle 0 is 1e+61"));
}

/// The bounds are those that the messages name.
TEST(Sanity, WhatIsJustWithinItsBoundsPasses) {
  using S = System<2>;
  EXPECT_EQ(error_of([](S& s) { s.state.mass.assign(4, 1e60); }), "no error");
  EXPECT_EQ(error_of([](S& s) { s.state.mass.assign(4, 1e-60); }), "no error");
  EXPECT_EQ(error_of([](S& s) { s.box.length = {1e8, 1e8}; }), "no error") << "1e9 radii of 0.1";
  EXPECT_THAT(error_of([](S& s) { s.box.length[1] = 1.01e8; }), HasSubstr("its cell is 10 x 1.01e+08"));
  EXPECT_EQ(error_of([](S& s) { s.state.radius[3] = 1e6; }), "no error") << "1e7 radii of 0.1";
  EXPECT_THAT(error_of([](S& s) { s.state.radius[3] = 1.01e6; }), HasSubstr("radii are from 0.1"));
  EXPECT_EQ(error_of([](S& s) { s.box.strain = -9.9e6; }), "no error");
  EXPECT_THAT(error_of([](S& s) { s.box.strain = -1.01e7; }), HasSubstr("its strain is"));
  EXPECT_EQ(error_of([](S& s) { s.state.position[3] = {-9.9e7, 0}; }), "no error");
  EXPECT_THAT(error_of([](S& s) { s.state.position[3] = {-1.01e8, 0}; }), HasSubstr("site 3 lies at"));
  const auto moving = [](double speed) {
    return error_of([&](S& s) {
      s.state.mass[0] = 2;
      s.state.velocity[0] = {speed, 0};
    });
  };
  EXPECT_EQ(moving(0.99e30), "no error");
  EXPECT_THAT(moving(1.01e30), HasSubstr("its kinetic energy is 1.0201e+60"));
}

}  // namespace
}  // namespace supple
