/// What --force may replace, what standard output gets, and what a run is without its pictures.
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>

#include <filesystem>

#include "tests/app/command.hpp"
#include "tests/paths.hpp"

namespace supple {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

class Force : public CommandTest {};

TEST_F(Force, ReplacesNoLinkPipeOrDevice) {
  write_small_case();
  write("kept", "kept");
  ASSERT_EQ(supple("run small.toml -o run.h5").code, 0);
  fs::create_symlink(path("kept"), path("link.h5"));
  fs::create_symlink(path("nowhere"), path("dangling.h5"));
  ASSERT_EQ(mkfifo(path("pipe.h5").c_str(), 0600), 0);
  fs::create_directory(path("folder.h5"));
  const bool device = mknod(path("device.h5").c_str(), S_IFCHR | 0600, makedev(1, 3)) == 0;  // root alone may
  std::vector<std::pair<std::string, std::string>> cases{{"link.h5", "it is a link"},
                                                         {"dangling.h5", "it is a link"},
                                                         {"pipe.h5", "it is a pipe"},
                                                         {"folder.h5", "it is a folder"}};
  if (device) cases.emplace_back("device.h5", "it is a device");
  for (const auto& [name, what] : cases)
    for (const std::string command : {"run small.toml", "export run.h5", "snapshot run.h5", "plot run.h5",
                                      "export run.h5 --to state", "init", "show run.h5"}) {
      const std::string ending =
          command.starts_with("snapshot") || command.starts_with("plot") ? ".png" : ".h5";
      const std::string as = fs::path(name).replace_extension(ending).string();
      if (!fs::exists(fs::symlink_status(path(as)))) fs::rename(path(name), path(as));
      const Outcome o = supple(command + " --force -o " + as);
      EXPECT_EQ(o.code, 4) << command << " -o " << as << "\n" << o.err;
      EXPECT_THAT(o.err, HasSubstr(what)) << command;
      fs::rename(path(as), path(name));
    }
  EXPECT_EQ(read_text(path("kept")), "kept");
  EXPECT_TRUE(fs::is_fifo(path("pipe.h5")));
}

TEST_F(Force, NeverReplacesWhatTheCommandReads) {
  write_small_case();
  const std::string text = read_text(path("small.toml"));
  EXPECT_EQ(supple("run small.toml --force -o small.toml").code, 4);
  EXPECT_EQ(read_text(path("small.toml")), text);
  ASSERT_EQ(supple("run small.toml").code, 0);
  const std::string run = read_text(path("small.h5"));
  fs::create_symlink(path("small.h5"), path("other.h5"));
  for (const std::string command :
       {"run small.toml --set initial.state=small.h5",
        "run small.toml -o ./small.h5 --set initial.state=other.h5", "export small.h5 -o ./small.h5",
        "export other.h5 --to xyz -o small.h5", "show small.h5 -o small.h5"}) {
    const Outcome o = supple(command + " --force");
    EXPECT_EQ(o.code, 4) << command;
    EXPECT_THAT(o.err, HasSubstr("it is the file that is read")) << command;
  }
  EXPECT_EQ(read_text(path("small.h5")), run);
}

/// A run that was killed is its segments.
TEST_F(Force, NeverReplacesSegmentsThatAreRead) {
  write_small_case();
  ASSERT_EQ(supple("run small.toml -o a.h5").code, 0);
  fs::create_directory(path("killed.h5.partial"));
  fs::rename(path("a.h5"), path("killed.h5.partial/segment-000000.h5"));
  EXPECT_EQ(supple("run small.toml --force -o killed.h5 --set initial.state=killed.h5").code, 4);
  EXPECT_EQ(supple("run small.toml --force -o killed.h5 --set initial.state=killed.h5.partial").code, 4);
  EXPECT_EQ(supple("export killed.h5 --force -o killed.h5").code, 4);
  EXPECT_EQ(supple("export killed.h5 --force -o killed.h5.partial/segment-000000.h5").code, 4);
  EXPECT_EQ(supple("show killed.h5").code, 0);
}

TEST_F(Force, RemovesNoFolderOfOthers) {
  write_small_case();
  fs::create_directory(path("small.h5.partial"));
  write("small.h5.partial/thesis.tex", "precious");
  const Outcome o = supple("run small.toml --force");
  EXPECT_EQ(o.code, 4);
  EXPECT_THAT(o.err, HasSubstr("it holds thesis.tex, which no run wrote"));
  EXPECT_EQ(read_text(path("small.h5.partial/thesis.tex")), "precious");
  fs::remove(path("small.h5.partial/thesis.tex"));
  write("small.h5.partial/segment-000000.h5", "of a run that was killed");
  EXPECT_EQ(supple("run small.toml --force").code, 0);
}

TEST_F(Force, LeavesNothingOfAnOlderRunInItsFolders) {
  write_small_case();
  const auto files_in = [&](const char* folder) {
    return std::distance(fs::directory_iterator(path(folder)), fs::directory_iterator());
  };
  ASSERT_EQ(supple("run small.toml --set output.frames=4 --set output.images=4").code, 0);
  ASSERT_EQ(supple("export small.h5 --to vtp -o small.pvd").code, 0);
  ASSERT_EQ(files_in("small_images"), 4);
  ASSERT_EQ(files_in("small_frames"), 4);
  write("small_images/notes.txt", "of the user");
  ASSERT_EQ(supple("run small.toml --set output.frames=2 --set output.images=2 --force").code, 0);
  ASSERT_EQ(supple("export small.h5 --to vtp -o small.pvd --force").code, 0);
  EXPECT_EQ(files_in("small_images"), 2 + 1) << "what is not of a run stays";
  EXPECT_EQ(files_in("small_frames"), 2);
  EXPECT_TRUE(exists("small_images/notes.txt"));
}

TEST_F(Force, FoldersThatAreNoneOrCannotBeChangedAreNamedInOurWords) {
  write_small_case();
  write("small_images", "a file");
  write("small_frames", "a file");
  const Outcome images = supple("run small.toml --set output.images=2 --force");
  EXPECT_EQ(images.code, 4);
  EXPECT_THAT(images.err, HasSubstr("supple: cannot make the folder small_images (File exists)"));
  const Outcome frames = supple("export small.h5 --to vtp -o small.pvd --force");
  EXPECT_EQ(frames.code, 4);
  EXPECT_THAT(frames.err, HasSubstr("supple: cannot make the folder small_frames (File exists)"));
  if (geteuid() == 0) run_as_nobody();
  fs::create_directory(path("small.h5.partial"));
  fs::permissions(path("small.h5.partial"), fs::perms::none);
  fs::permissions(path(""), fs::perms::all);
  const Outcome segments = supple("run small.toml --force");
  EXPECT_EQ(segments.code, 4);
  EXPECT_THAT(segments.err, HasSubstr("supple: cannot use small.h5.partial (Permission denied)"));
  fs::permissions(path("small.h5.partial"), fs::perms::owner_all);
}

TEST_F(Force, TheMessageOfWhatExistsNamesIt) {
  write_small_case();
  ASSERT_EQ(supple("run small.toml").code, 0);
  for (const std::string command : {"run small.toml", "show small.h5 -o small.toml", "init -o small.toml"})
    EXPECT_THAT(supple(command).err, HasSubstr("--force")) << command;
}

/// The run before is complete, this one ends before its first step.
TEST_F(Force, ARunThatFailsDoesNotPointAtAnOlderOne) {
  write_small_case();
  ASSERT_EQ(supple("run small.toml").code, 0);
  const std::string older = read_text(path("small.h5"));
  const Outcome o = supple("run small.toml --force --set preparation.max_time=1e-3");
  EXPECT_EQ(o.code, 3) << o.err;
  EXPECT_THAT(o.err, Not(HasSubstr("small.h5")));
  EXPECT_EQ(read_text(path("small.h5")), older);
}

class StandardOutput : public CommandTest {};

TEST_F(StandardOutput, TakesWhatTheFileWouldHold) {
  write_small_case();
  ASSERT_EQ(supple("run small.toml").code, 0);
  for (const std::string to : {"csv", "xyz", "state"}) {
    ASSERT_EQ(supple("export small.h5 -o file --force --to " + to).code, 0);
    const Outcome o = supple("export small.h5 -o - --to " + to);
    EXPECT_EQ(o.code, 0) << o.err;
    EXPECT_EQ(o.out, read_text(path("file"))) << to;
  }
  ASSERT_EQ(supple("snapshot small.h5 -o file.png").code, 0);
  EXPECT_THAT(supple("snapshot small.h5 -o -").out,
              testing::StartsWith(read_text(path("file.png")).substr(0, 1000)));
  EXPECT_EQ(supple("show small.h5 -o -").out, supple("show small.h5").out);
  ASSERT_EQ(supple("show small.h5 -o summary").code, 0);
  EXPECT_EQ(supple("show small.h5").out, read_text(path("summary")));
  EXPECT_FALSE(exists("-"));
}

TEST_F(StandardOutput, IsRefusedWhereFilesAndFoldersAreWritten) {
  write_small_case();
  ASSERT_EQ(supple("run small.toml").code, 0);
  EXPECT_THAT(supple("run small.toml -o -").err, HasSubstr("give a name"));
  EXPECT_THAT(supple("export small.h5 --to vtp -o -").err, HasSubstr("give a name"));
  EXPECT_FALSE(exists("-"));
}

TEST_F(StandardOutput, ThatIsFullIsFileTrouble) {
  write_small_case();
  ASSERT_EQ(supple("run small.toml").code, 0);
  for (const std::string command :
       {"export small.h5 -o -", "export small.h5 --to state -o -", "show small.h5", "show small.h5 --json",
        "snapshot small.h5 -o -", "plot small.h5 -o -", "check small.toml", "list", "init -o -", "--help",
        "run --help", "--version"}) {
    const Outcome o = supple(command, "/dev/full");
    EXPECT_EQ(o.code, 4) << command << "\n" << o.err;
    EXPECT_THAT(o.err, HasSubstr("No space left on device")) << command;
  }
}

class Pictures : public CommandTest {};

/// A figure of one row, a run without frames or rows: it is the picture that is missing, not the run.
TEST_F(Pictures, OfACompleteRunWarn) {
  for (const std::string steps : {"0", "1"}) {
    const Outcome o = supple("run " SUPPLE_SOURCE_DIR
                             "/examples/dynamics_pair.toml --force --set output.plot=true --set "
                             "output.snapshot=true --set output.images=2 --set time.steps=" +
                             steps);
    EXPECT_EQ(o.code, 0) << o.err;
    if (steps == "0") {
      EXPECT_THAT(o.err, HasSubstr("warning: dynamics_pair_stress.png not drawn"));
    }
    EXPECT_EQ(supple("show dynamics_pair.h5").code, 0);
  }
}

/// Of the same run, that is the same bits, in every format; one of another run needs --force.
TEST_F(Pictures, ReplaceThoseOfTheSameRunAlone) {
  write_small_case();
  ASSERT_EQ(supple("run small.toml").code, 0);
  ASSERT_EQ(supple("run small.toml -o other.h5 --set seed=2").code, 0);
  for (const std::string ending : {"png", "jpg", "svg", "pdf", "ps"}) {
    const std::string name = "cell." + ending;
    ASSERT_EQ(supple("snapshot small.h5 -o " + name).code, 0);
    EXPECT_EQ(supple("snapshot small.h5 -o " + name).code, 0) << ending;
    const std::string first = read_text(path(name));
    const Outcome other = supple("snapshot other.h5 -o " + name);
    EXPECT_EQ(other.code, 4) << ending;
    EXPECT_THAT(other.err, HasSubstr("overwrite it with --force"));
    EXPECT_EQ(read_text(path(name)), first) << ending;
    EXPECT_EQ(supple("plot other.h5 --force -o " + name).code, 0) << ending;
    EXPECT_EQ(supple("snapshot small.h5 -o " + name).code, 4) << ending;
  }
  write("cell.png", "a picture of somebody else");
  EXPECT_EQ(supple("snapshot small.h5 -o cell.png").code, 4);
}

}  // namespace
}  // namespace supple
