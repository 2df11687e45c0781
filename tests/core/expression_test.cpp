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

/// What is wrong, what was meant, and no words of the library that reads formulas.
TEST(Expression, SpellingsOfOtherLanguagesAreAnsweredWithOurs) {
  const std::pair<const char*, const char*> cases[] = {
      {"t**2", "(there is no '**'); a power is written x^y"},
      {"t > 1 and t < 2", "(there is no 'and'); write a && b"},
      {"t > 1 or 1", "write a || b"},
      {"not t", "write a == 0"},
      {"True * t", "(there is no 'True'); write 1"},
      {"2*t if t > 1 else 0", "(there is no 'if'); write condition ? a : b"},
      {"pow(t, 2)", "a power is written x^y"},
      {"fabs(t)", "did you mean 'abs'?"},
      {"math.sin(t)", "functions have no module: sin(x)"},
      {"2*[t+1]", "write ( ) around"},
      {"t\u22121", "write a plain minus"},
      {"2\u00d7t", "write * for times"},
      {"2 t", "(nothing stands before 't'); write * for times"},
      {"t(1+t)", "(nothing stands between 't' and its bracket); write * for times"},
      {"2*(t+1", "(a bracket is opened and not closed)"},
      {"2*t+", "it ends too early"},
      {"t > 1 ? 2", "write condition ? a : b"},
      {"2*T", "(there is no 'T'); did you mean 't'?"},
      {"tnah(t)", "did you mean 'tanh'?"},
      {"sin t", "write sin(x)"},
      {"", "(it is empty); it may use t, pi"},
      {"2 % t", "('%' cannot stand there); it may use t, pi"},
      {"sin(t, 2)", "a function has too few or too many values"},
  };
  for (const auto& [text, answer] : cases) {
    const std::string error = error_of(text);
    EXPECT_THAT(error, HasSubstr(answer)) << text;
    EXPECT_THAT(error, testing::Not(testing::HasSubstr("nexpected"))) << text;
  }
}

TEST(Expression, AValueThatIsNotFiniteNamesTheFormulaAndTheTime) {
  EXPECT_THAT(error_of("1/t"), HasSubstr("[shear] rate \"1/t\" is infinite at t = 0"));
  EXPECT_THAT(error_of("-1/t"), HasSubstr("is minus infinite at t = 0"));
  EXPECT_THAT(error_of("sqrt(t-1)", 0.5), HasSubstr("is not a number at t = 0.5"));
  EXPECT_EQ(value("1/t"), 4);
}

}  // namespace
}  // namespace supple
