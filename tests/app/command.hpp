/// Runs the real command in a folder of its own.
#pragma once
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "tests/paths.hpp"

namespace supple {

/// What a command left: exit code, stdout, stderr.
struct Outcome {
  int code = -1;
  std::string out, err;
};

inline std::string read_text(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

/// An empty folder in which commands run; it is removed at the end of the test.
class CommandTest : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    std::string name = test->name();  // the name of a parameter follows a slash
    std::replace(name.begin(), name.end(), '/', '_');
    folder_ = std::filesystem::temp_directory_path() / ("supple_" + name + "_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_ / "work");
  }
  void TearDown() override {
    std::filesystem::permissions(path(""), std::filesystem::perms::owner_all);
    std::filesystem::remove_all(folder_);
  }

  /// Runs `supple ARGUMENTS` in the folder of the test. With a `device`, stdout goes there and is not read.
  Outcome supple(const std::string& arguments, const std::string& device = "") {
    const std::string out = device.empty() ? (folder_ / "out").string() : device,
                      err = (folder_ / "err").string();
    const std::string line = "cd '" + path("").string() + "' && " + prefix_ + "'" SUPPLE_COMMAND "' " +
                             arguments + " >'" + out + "' 2>'" + err + "'";
    const int status = std::system(line.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, device.empty() ? read_text(out) : "",
            read_text(err)};
  }
  std::filesystem::path path(const std::string& name) const { return folder_ / "work" / name; }
  void write(const std::string& name, const std::string& text) { std::ofstream(path(name)) << text; }
  bool exists(const std::string& name) const { return std::filesystem::exists(path(name)); }
  /// Number of files and folders that commands left in the folder.
  int entries() const {
    return static_cast<int>(std::distance(std::filesystem::directory_iterator(path("")), {}));
  }

  /// A case that runs in well under a second.
  void write_small_case(const std::string& name = "small.toml") {
    write(name,
          "[particles]\nN = 24\ncut_lines = 0\n[shear]\npre_periods = 0.5\nperiods = 2\npost_periods = 0.5\n"
          "[output]\nframes = 4\nplot = false\nsnapshot = false\n");
  }

  /// Root may write anywhere, so tests of permissions run their commands as another user.
  /// What the shell reads before the command, with a space behind it.
  void set_prefix(const std::string& prefix) { prefix_ = prefix; }
  void run_as_nobody() { prefix_ = "setpriv --reuid=65534 --regid=65534 --clear-groups "; }

 private:
  std::filesystem::path folder_;
  std::string prefix_;
};

}  // namespace supple
