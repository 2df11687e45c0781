#include "supple/io/state/json_node.hpp"

#include <gmock/gmock.h>

#include "tests/io/temporary_folder.hpp"

namespace supple {
namespace {

using ::testing::HasSubstr;

class JsonFile : public testing::TemporaryFolder {};

/// In our words, with the place, not in those of the library that reads JSON.
TEST_F(JsonFile, WhatIsNoJsonIsSaidToBeWhatItIs) {
  const std::pair<std::string, std::string> cases[] = {
      {"", "(it is empty)"},
      {"hello", "(it is not JSON, which begins with {)"},
      {"\x89HDF\r\n", "(it is a run, not JSON); a run is named by initial.state"},
      {"{\"a\": 1,\n  \"b\": NaN}", "(line 2, column 8: JSON has no nan and no infinity)"},
      {"{\"a\": -inf}", "(line 1, column 8: JSON has no nan and no infinity"},
      {"{\"a\": 1,}",
       "(line 1, column 9: something is missing before the bracket, or a comma is one too many)"},
      {"{\"a\": 1,,}", "(line 1, column 9: ',' cannot stand there)"},
      {"{'a': 1}", "(line 1, column 2: text stands between \" \")"},
      {"{\"a\": [1, 2\n", "(it ends too early, in line "},
      {"{\"a\": 1e999}", "(a number in it is too large)"},
  };
  for (const auto& [text, answer] : cases) {
    const std::string path = in_folder("broken.json");
    testing::write_content(path, text);
    const std::string error = testing::file_error_of([&] { parse_json(path, "a state"); });
    EXPECT_THAT(error, HasSubstr("cannot use " + path + " as a state " + answer)) << text;
    EXPECT_THAT(error, ::testing::Not(HasSubstr("exception"))) << text;
  }
}

}  // namespace
}  // namespace supple
