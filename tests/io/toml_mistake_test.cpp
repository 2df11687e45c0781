/// Lines that are not TOML are answered with what was meant.
#include "supple/io/text/toml_mistake.hpp"

#include <gmock/gmock.h>

#include "supple/core/error.hpp"
#include "supple/io/text/case_file.hpp"

namespace supple {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::string error_of(const std::string& text) {
  try {
    read_case_text(text, "c.toml");
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::input);
    return e.what();
  }
  return "no error";
}

TEST(TomlMistake, ValuesOfOtherLanguagesAreAnsweredWithOurs) {
  const std::pair<const char*, const char*> cases[] = {
      {"amplitude = .1", "write amplitude = 0.1"},
      {"amplitude = 1.", "write amplitude = 1.0"},
      {"amplitude = 0,2", "(decimals have a point, not a comma); write amplitude = 0.2"},
      {"amplitude = 1,000", "write amplitude = 1.000 or 1000"},
      {"amplitude = \u22120.2", "write amplitude = -0.2"},
      {"amplitude = 20 %", "(a number with a unit stands between quotes); write amplitude = \"20 %\""},
      {"amplitude = 500um", "write amplitude = \"500 um\""},
      {"amplitude = 500 µm # wide", "write amplitude = \"500 µm\""},
      {"amplitude = 0,5 mm", "write amplitude = \"0.5 mm\""},
      {"amplitude = 0.2;", "(nothing ends a line); write amplitude = 0.2"},
      {"amplitude = 0.2 // strain", "(a comment begins with #); write amplitude = 0.2"},
      {"amplitude = 0.2 0.3", "'0.3' stands behind the number"},
      {"amplitude = ", "'amplitude' has no value"},
      {"amplitude 0.2", "(a key and its value have = between them); write amplitude = 0.2"},
      {"amplitude: 0.2", "write amplitude = 0.2"},
      {"rate = ”1”", "typographic quotes"},
      {"rate = \"1", "(a quote is opened and not closed); write \" where the text ends"},
      {"rate = \"D:\\data\"", "a backslash between \" \" begins an escape"},
      {"rate = cos(t)", "(text stands between quotes); write rate = \"cos(t)\""},
      {"links = True", "('True' is neither true nor false); write links = true"},
      {"links = yes", "write links = true"},
      {"links = OFF", "write links = false"},
      {"N = 010", "write N = 10"},
      {"N = 18446744073709551615", "integers go up to 9223372036854775807"},
      {"my key = 3", "it has a space in it"},
  };
  for (const auto& [line, answer] : cases) {
    const std::string error = error_of("[shear]\n" + std::string(line) + "\n");
    EXPECT_THAT(error, StartsWith("c.toml:2:")) << line;
    EXPECT_THAT(error, HasSubstr(answer)) << line;
    EXPECT_THAT(error, Not(HasSubstr("rror while parsing"))) << line;
  }
}

TEST(TomlMistake, SectionsAndKeysThatStandTwiceNameTheFirst) {
  EXPECT_THAT(error_of("[shear]\namplitude = 0.1\n\namplitude = 0.2\n"),
              HasSubstr("('amplitude' stands already in line 2); keep one of the two"));
  EXPECT_THAT(error_of("[shear]\namplitude = 0.1\n[box]\n[shear]\nperiods = 5\n"),
              HasSubstr("([shear] stands already in line 1); put its keys there"));
}

TEST(TomlMistake, HeadersAndOtherFormats) {
  EXPECT_THAT(error_of("[shear\namplitude = 1\n"), HasSubstr("write [shear] on a line of its own"));
  EXPECT_THAT(error_of("[shear] amplitude = 1\n"), HasSubstr("write [shear] on a line of its own"));
  EXPECT_THAT(error_of("{\"shear\": {}}\n"), HasSubstr("looks like JSON"));
}

TEST(TomlMistake, ListsAndTablesAreNoValues) {
  for (const char* text :
       {"[shear]\nrate = [1, 2\n", "[shear]\nrate = [1,\n2 3]\n", "[shear]\nrate = {a = 1\n",
        "[shear]\nrate = [[1, 2],\n[3 4]]\nperiods = 5\n", "[shear]\nrate = [1 # one\n"}) {
    EXPECT_THAT(error_of(text), HasSubstr("(no key of a case takes a list or a table); give it one value"));
    EXPECT_THAT(error_of(text), Not(HasSubstr("reader of TOML"))) << text;
  }
  EXPECT_THAT(error_of("[shear]\nrate = \"a[\"\nmy key = 3\n"), HasSubstr("it has a space in it"));
}

TEST(TomlMistake, LinesThatDoNotExistTellNothing) {
  EXPECT_EQ(find_toml_mistake("a = 1\n", 7).why, "");
  EXPECT_EQ(find_toml_mistake("", 0).why, "");
}

}  // namespace
}  // namespace supple
