#include "supple/core/expression.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "supple/core/error.hpp"

namespace supple {
namespace {

using testing::HasSubstr;

double value(const std::string& text, double t = 0.25) { return Expression(text, {"t"}, "[shear] rate")(t); }

std::string error_of(const std::string& text, double t = 0) {
  try {
    value(text, t);
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::input);
    return e.what();
  }
  return "no error";
}

TEST(Expression, BothNamesOfPiAreExact) {
  EXPECT_EQ(value("pi"), std::numbers::pi);
  EXPECT_EQ(value("_pi"), std::numbers::pi);
}

TEST(Expression, FollowsTheGrammarOfTheGuide) {
  EXPECT_EQ(value("2^3^2"), 512);
  EXPECT_EQ(value("-2^2"), -4);
  EXPECT_EQ(value("t < 0.5 && t != 0.1 ? 2 : 3"), 2);
  EXPECT_EQ(value("t == 0.25"), 1);
  EXPECT_EQ(value("min(3, 2, 1)"), 1);
  EXPECT_DOUBLE_EQ(value("log(10)"), std::log(10));
}

TEST(Expression, SeveralResultsAreRefused) {
  EXPECT_THAT(error_of("0,5*t"), HasSubstr("[shear] rate \"0,5*t\" cannot be read (it is 2 formulas"));
  EXPECT_THAT(error_of("min(1,2),3"), HasSubstr("2 formulas"));
}

TEST(Expression, AssignmentIsRefused) {
  for (const char* text : {"t=3", "t = 3 ? 1 : 2", "=t", "t===1", "1+(t=2)"})
    EXPECT_THAT(error_of(text), HasSubstr("a single = sets a variable")) << text;
}

TEST(Expression, AValueThatIsNotFiniteNamesTheFormulaAndTheTime) {
  EXPECT_THAT(error_of("1/t"), HasSubstr("[shear] rate \"1/t\" is infinite at t = 0"));
  EXPECT_THAT(error_of("-1/t"), HasSubstr("is minus infinite at t = 0"));
  EXPECT_THAT(error_of("sqrt(t-1)", 0.5), HasSubstr("is not a number at t = 0.5"));
  EXPECT_EQ(value("1/t"), 4);
}

}  // namespace
}  // namespace supple
