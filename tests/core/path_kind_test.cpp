#include "supple/core/path_kind.hpp"

#include <gmock/gmock.h>

#include <filesystem>

#include "supple/core/error.hpp"
#include "supple/core/new_file.hpp"
#include "supple/io/run/run_file.hpp"
#include "supple/io/state/packing_file.hpp"
#include "supple/io/state/state_file.hpp"
#include "supple/io/text/case_file.hpp"
#include "tests/io/temporary_folder.hpp"

namespace supple {
namespace {

using ::testing::HasSubstr;

class PathKinds : public testing::TemporaryFolder {};

/// Every reader of a file must refuse it as a file error that holds `message`.
void expect_refused(const std::string& path, const std::string& message) {
  const auto refuses = [&](const char* reader, auto&& read) {
    const std::string said = testing::file_error_of(read);
    EXPECT_THAT(said, HasSubstr(message)) << reader;
    EXPECT_NE(said, "") << reader << " takes " << path;
  };
  refuses("case", [&] { read_case(path); });
  refuses("packing", [&] { read_packing_json(path); });
  refuses("state", [&] { read_state(path); });
  refuses("run", [&] { RunFile run(path); });
}

TEST_F(PathKinds, ADeviceIsNoFile) { expect_refused("/dev/zero", "it is a device, not a file"); }

TEST_F(PathKinds, ANameThatIsTooLongIsAFileError) {
  expect_refused(std::string(5000, 'x'), "File name too long");
  EXPECT_THROW(check_can_create(std::string(5000, 'x'), Existing::refuse), Error);
}

TEST_F(PathKinds, WhatIsNotThereIsAFileError) {
  expect_refused(in_folder("none"), "none");
  expect_refused("", "");
}

TEST_F(PathKinds, AFolderIsNoFile) { expect_refused(folder(), ""); }

TEST_F(PathKinds, ALoopOfLinksIsAFileError) {
  std::filesystem::create_symlink(in_folder("b"), in_folder("a"));
  std::filesystem::create_symlink(in_folder("a"), in_folder("b"));
  expect_refused(in_folder("a"), "symbolic link");
}

TEST_F(PathKinds, AWholeFileIsReadUpToALength) {
  testing::write_content(in_folder("text"), "0123456789");
  EXPECT_EQ(read_whole_file(in_folder("text"), "the case", 10), "0123456789");
  EXPECT_THROW(read_whole_file(in_folder("text"), "the case", 9), Error);
}

}  // namespace
}  // namespace supple
