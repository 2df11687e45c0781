#include "supple/draw/canvas/superscript.hpp"

#include <gtest/gtest.h>

#include "supple/draw/canvas/canvas.hpp"
#include "supple/draw/canvas/ticks.hpp"
#include "tests/io/temporary_folder.hpp"

namespace supple {
namespace {

TEST(Superscript, WritesExponentsAndShortNumbers) {
  EXPECT_EQ(superscript(-17), "\u207b\u00b9\u2077");
  EXPECT_EQ(short_number(0.25), "0.25");
  EXPECT_EQ(short_number(-12), "\u221212");
  EXPECT_EQ(short_number(0), "0");
  EXPECT_EQ(short_number(5e-7), "5\u00b710\u207b\u2077");
  EXPECT_EQ(short_number(-1.234e8), "\u22121.23\u00b710\u2078");
}

TEST(Superscript, RaisesWhatTheFontLacks) {
  const std::vector<TextRun> runs = text_runs("(10\u207b\u00b9\u2077 m)");
  ASSERT_EQ(runs.size(), 3u);
  EXPECT_EQ(runs[0].text, "(10");
  EXPECT_EQ(runs[1].text, "\u221217");
  EXPECT_EQ(runs[2].text, " m)");
  EXPECT_TRUE(!runs[0].raised && runs[1].raised && !runs[2].raised);
}

TEST(Superscript, LeavesTextThatTheFontHasAlone) {
  const std::vector<TextRun> runs = text_runs("p\u00b2/4\u03c0a");
  ASSERT_EQ(runs.size(), 1u);
  EXPECT_EQ(runs[0].text, "p\u00b2/4\u03c0a");
  EXPECT_FALSE(runs[0].raised);
}

class SuperscriptOnPage : public testing::TemporaryFolder {};

TEST_F(SuperscriptOnPage, IsNarrowerThanTheSameTextOnTheLine) {
  const Canvas canvas(in_folder("a.png"), 100, 100);
  EXPECT_LT(canvas.text_width("10\u2077"), canvas.text_width("107"));
  EXPECT_GT(canvas.text_width("10\u2077"), canvas.text_width("10"));
}

TEST(Superscript, StandsForTheUnitOfSmallAndLargeNumbers) {
  const auto shown = [](const std::string& unit, double largest) {
    const ShownUnit s = shown_unit(unit, largest);
    return std::pair(s.factor, s.text);
  };
  EXPECT_EQ(shown("", 0.3), std::pair(1.0, std::string()));
  EXPECT_EQ(shown("", 0), std::pair(1.0, std::string()));
  EXPECT_DOUBLE_EQ(shown("", -3e-7).first, 1e-7);
  EXPECT_EQ(shown("", -3e-7).second, "10\u207b\u2077");
  EXPECT_EQ(shown("%", 0.3), std::pair(0.01, std::string("%")));
  EXPECT_EQ(shown("Pa", 2e4), std::pair(1e3, std::string("kPa")));
  EXPECT_EQ(shown("1/s", 2e4), std::pair(1.0, std::string("1/s")));
  EXPECT_EQ(shown("k_a a0", 2), std::pair(1.0, std::string("k_a a0")));
  EXPECT_DOUBLE_EQ(shown("k_a a0", 3e-7).first, 1e-7);
  EXPECT_EQ(shown("k_a a0", 3e-7).second, "10\u207b\u2077\u00a0k_a a0");
}

}  // namespace
}  // namespace supple
