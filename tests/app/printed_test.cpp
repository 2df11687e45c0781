/// What commands print: on a page of 80 columns, once, and with the names of the files.
#include <gmock/gmock.h>

#include "supple/core/text_columns.hpp"
#include "tests/app/command.hpp"

namespace supple {
namespace {

using testing::HasSubstr;
using testing::Not;

class Printed : public CommandTest {
 protected:
  static void expect_on_page(const std::string& text) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(text_width(line), page_width) << line;
  }
  static int count(const std::string& text, const std::string& word) {
    int found = 0;
    for (auto at = text.find(word); at != text.npos; at = text.find(word, at + 1)) ++found;
    return found;
  }
};

TEST_F(Printed, WarningsOfARunArePrintedOnceAndKept) {
  write_small_case();
  const Outcome run = supple("run small.toml");
  ASSERT_EQ(run.code, 0) << run.err;
  ASSERT_GT(count(run.err, "warning: "), 0) << "this case should warn";
  EXPECT_EQ(count(run.out, "warning: "), 0);
  EXPECT_GT(count(supple("show small.h5").out, "warning: "), 0);
}

TEST_F(Printed, ARunNamesEveryFileThatItWrote) {
  write_small_case();
  const Outcome run = supple(
      "run small.toml --set output.plot=true --set output.snapshot=true --set output.text=true --set "
      "output.images=2");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out,
              HasSubstr("wrote small.h5, small_stress.png, small_cell.png, small.txt, small_images/\n"));
  for (const auto& entry : std::filesystem::directory_iterator(path("")))
    if (entry.path().extension() != ".toml") {
      EXPECT_THAT(run.out, HasSubstr(entry.path().filename().string()));
    }
  const Outcome json = supple("run small.toml -o b.h5 --json");
  EXPECT_THAT(json.out, Not(HasSubstr("wrote")));
  EXPECT_THAT(json.err, HasSubstr("wrote b.h5\n"));
}

TEST_F(Printed, LinesFitThePageAndColumnsAreAligned) {
  write_small_case();
  ASSERT_EQ(supple("run small.toml").code, 0);
  const std::string show = supple("show small.h5").out;
  expect_on_page(show);
  EXPECT_THAT(show, HasSubstr("\n  stress "));
  write("jam.toml", "experiment = \"jamming\"\n[bodies]\nN = 6\nvertices = 8\n[jamming]\npressure = 1e-3\n");
  expect_on_page(supple("check small.toml").out);
  expect_on_page(supple("check jam.toml").out);
  expect_on_page(supple("list").out);
  expect_on_page(supple("init jamming -o -").out);
  ASSERT_EQ(supple("run jam.toml").code, 0);
  expect_on_page(supple("show jam.h5").out);
}

}  // namespace
}  // namespace supple
