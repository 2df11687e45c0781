#include "supple/core/new_file.hpp"

#include <gmock/gmock.h>

#include "supple/core/error.hpp"
#include "tests/io/temporary_folder.hpp"

namespace supple {
namespace {

using testing::content_of;
using testing::file_error_of;
using testing::write_content;

class NewFiles : public testing::TemporaryFolder {};

TEST_F(NewFiles, AppearWhenTheyAreCompleteOrNotAtAll) {
  {
    NewFile file(in_folder("a"), Existing::refuse);
    file.write("half");
    EXPECT_FALSE(std::filesystem::exists(in_folder("a")));
  }
  EXPECT_EQ(files(), 0u);
  NewFile file(in_folder("a"), Existing::refuse);
  file.write("whole");
  file.commit();
  EXPECT_EQ(content_of(in_folder("a")), "whole");
  EXPECT_EQ(files(), 1u);
}

TEST_F(NewFiles, KeepAFileThatAppearsWhileTheyAreWritten) {
  {
    NewFile file(in_folder("a"), Existing::refuse);
    file.write("new");
    write_content(in_folder("a"), "precious");
    EXPECT_THAT(file_error_of([&] { file.commit(); }), ::testing::HasSubstr("exists"));
  }
  EXPECT_EQ(content_of(in_folder("a")), "precious");
  EXPECT_EQ(files(), 1u);
  NewFile file(in_folder("a"), Existing::replace);
  file.write("new");
  file.commit();
  EXPECT_EQ(content_of(in_folder("a")), "new");
}

TEST_F(NewFiles, ThatAreNumberedAreRemovedAndNothingElse) {
  for (const char* name : {"frame0000001.vtp", "frame0000020.svg", "frame1.vtp", "frame0000001vtp",
                           "frame00000001.vtp", "frame0000001.", "image0000001.vtp", "frame000000a.vtp", "f"})
    write_content(in_folder(name), name);
  std::filesystem::create_directory(in_folder("frame0000003.vtp"));
  remove_numbered_files(folder(), "frame");
  EXPECT_EQ(files(), 8u);
  EXPECT_FALSE(std::filesystem::exists(in_folder("frame0000001.vtp")));
  EXPECT_FALSE(std::filesystem::exists(in_folder("frame0000020.svg")));
  EXPECT_NO_THROW(remove_numbered_files(in_folder("none"), "frame"));
}

}  // namespace
}  // namespace supple
