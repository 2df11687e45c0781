/// Numbers that a state has beside its system have the ranges of the keys that they stand for.
#include <gmock/gmock.h>

#include <limits>

#include "supple/contact/laws/harmonic.hpp"
#include "supple/core/error.hpp"
#include "supple/experiment/adopt_state.hpp"

namespace supple {
namespace {

using ::testing::HasSubstr;
using M = MaterialConstants;

/// A disc at rest, with numbers as runs leave them.
InitialState sound_state() {
  InitialState initial;
  System<2>& system = system_of<2>(initial);
  system.box.length = {10, 10};
  system.state.resize(1);
  system.state.position = {{5, 5}};
  system.state.radius = system.state.mass = system.state.inertia = {1};
  initial.material = {20, 0.7, 0, 0, 0, 1, 0.5, 0, true};
  initial.protocol = {
      {"dt", 0.01},     {"cool_factor", 1}, {"steps", 0},           {"f", 0},
      {"amplitude", 0}, {"pre", 0},         {"removed_stress", -3}, {"account_opening", -1e-70}};
  return initial;
}

std::string error_of(const InitialState& initial) {
  Case c;
  c.general.experiment = "dynamics";
  try {
    adopt_state(c, &initial);
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::input);
    return e.what();
  }
  return "no error";
}

TEST(NumbersOfAState, AsRunsLeaveThemPass) { EXPECT_EQ(error_of(sound_state()), "no error"); }

/// dt = -1 ran until a disc was lost; mu = -1 ran to its end.
TEST(NumbersOfAState, OutOfTheirRangeAreRefusedByName) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto constant = [](std::optional<double> M::*member, double x) {
    InitialState initial = sound_state();
    initial.material.*member = x;
    return error_of(initial);
  };
  EXPECT_THAT(constant(&M::k, 0), HasSubstr("the state to start from cannot be computed with: its k is 0 (it "
                                            "must be above 0); look for a wrong unit or a damaged number"));
  EXPECT_THAT(constant(&M::nu, -1), HasSubstr("its nu is -1 (it must be at least 0)"));
  EXPECT_THAT(constant(&M::k_t, -1), HasSubstr("its k_t is -1"));
  EXPECT_THAT(constant(&M::nu_t, -1), HasSubstr("its nu_t is -1"));
  EXPECT_THAT(constant(&M::mu, -1), HasSubstr("its mu is -1"));
  EXPECT_THAT(constant(&M::mu, 1e61), HasSubstr("its mu is 1e+61 (numbers are from 1e-60 to 1e+60 here)"));
  EXPECT_THAT(constant(&M::central_repulsion_coefficient, 1.5),
              HasSubstr("its central_repulsion_coefficient is 1.5 (it must be from 0 to 1)"));
  EXPECT_THAT(constant(&M::permanent_ratio_central, nan), HasSubstr("its permanent_ratio_central is nan"));
  EXPECT_THAT(constant(&M::permanent_ratio_tangential, -2),
              HasSubstr("its permanent_ratio_tangential is -2"));
  const auto number = [](const std::string& name, double x) {
    InitialState initial = sound_state();
    initial.protocol[name] = x;
    return error_of(initial);
  };
  EXPECT_THAT(number("dt", -1), HasSubstr("its dt is -1 (it must be above 0)"));
  EXPECT_THAT(number("dt", 0), HasSubstr("its dt is 0"));
  EXPECT_THAT(number("dt", nan), HasSubstr("its dt is nan"));
  EXPECT_THAT(number("cool_factor", 1.01),
              HasSubstr("its cool_factor is 1.01 (it must be above 0, at most 1)"));
  EXPECT_THAT(number("cool_factor", 0), HasSubstr("its cool_factor is 0"));
  for (const char* name : {"steps", "f", "amplitude", "pre", "periods", "post"})
    EXPECT_THAT(number(name, -1), HasSubstr(std::string("its ") + name + " is -1"));
}

TEST(NumbersOfAState, ContactsOfBodiesHaveAStiffness) {
  InitialState initial = sound_state();
  initial.contact = Harmonic{-1, true};
  EXPECT_THAT(error_of(initial), HasSubstr("its contact_stiffness is -1 (it must be above 0)"));
}

}  // namespace
}  // namespace supple
