#include "supple/io/text/progress.hpp"

#include <gmock/gmock.h>

#include <sstream>

#include "supple/core/duration.hpp"

namespace supple {
namespace {

using testing::HasSubstr;
using Style = ProgressLine::Style;

TEST(Progress, ABarIsRedrawnInPlace) {
  std::ostringstream out;
  double now = 0;
  ProgressLine progress(out, Style::bar, [&] { return now; });
  progress.update("shear", 0, 1000);
  now = 1;
  progress.update("shear", 250, 1000);
  EXPECT_THAT(out.str(),
              HasSubstr("\rshear        [######------------------]  25 %  250 of 1000  250/s  3 s left"));
  EXPECT_EQ(out.str().find('\n'), std::string::npos);
  now = 4;
  progress.update("shear", 1000, 1000);
  progress.finish();
  EXPECT_THAT(out.str(), HasSubstr("100 %  1000 of 1000  250/s "));
  EXPECT_EQ(out.str().back(), '\n');
}

TEST(Progress, ABarIsNotRedrawnForEveryStep) {
  std::ostringstream out;
  double now = 0;
  ProgressLine progress(out, Style::bar, [&] { return now; });
  for (int i = 0; i < 1000; ++i, now += 1e-5) progress.update("shear", i, 100000);
  EXPECT_LT(out.str().size(), 200u);
}

TEST(Progress, LogsGetALineForEveryTenth) {
  std::ostringstream out;
  double now = 0;
  ProgressLine progress(out, Style::lines, [&] { return now; });
  for (int i = 0; i <= 1000; ++i, now += 1e-3) progress.update("shear", i, 1000);
  const std::string text = out.str();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 11);
  EXPECT_EQ(text.find('\r'), std::string::npos);
}

TEST(Progress, MessagesStandOnLinesOfTheirOwn) {
  std::ostringstream out;
  ProgressLine progress(out, Style::bar, [] { return 0.0; });
  progress.update("relax", 0, 10);
  progress.message("warning: x");
  EXPECT_THAT(out.str(), HasSubstr("\nwarning: x\n"));
}

TEST(Progress, TimesInWords) {
  EXPECT_EQ(describe_seconds(3), "3 s");
  EXPECT_EQ(describe_seconds(0.123), "0.12 s");
  EXPECT_EQ(describe_seconds(200), "3 min 20 s");
  EXPECT_EQ(describe_seconds(7500), "2 h 5 min");
  EXPECT_EQ(describe_seconds(5 * 86400), "5 days");
  EXPECT_EQ(describe_seconds(1e8), "3 years");
  EXPECT_EQ(describe_seconds(1e300), "over 1000 years");
}

/// A search says where it is each time; in a log that is no new phase.
TEST(Progress, WhatIsSaidOfTheMomentMakesNoNewLines) {
  std::ostringstream out;
  double now = 0;
  ProgressLine progress(out, Style::lines, [&] { return now; });
  for (int i = 0; i <= 1000; ++i, now += 0.01) progress.update("jam: phi = " + std::to_string(i), i, 1000);
  const std::string text = out.str();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 11);
  EXPECT_THAT(text, HasSubstr("jam: phi = 500"));
  EXPECT_THAT(text, HasSubstr("5 s left"));
}

}  // namespace
}  // namespace supple
