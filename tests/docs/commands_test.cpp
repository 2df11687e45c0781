/// Every command that the documents tell a reader to type, in their order and word for word. A `supple` in
/// front of the real one makes `run` cheap: fewer particles, fewer steps, by --set.
#include <gmock/gmock.h>

#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "supple/experiment/experiments.hpp"
#include "tests/app/command.hpp"

namespace supple {
namespace {

namespace fs = std::filesystem;

/// The size of a run by its experiment, which the last --set experiment=..., or else the case, says.
constexpr auto cheap_supple = R"sh(#!/bin/sh
[ "$1" = run ] || exec "$REAL" "$@"
kind=$(sed -n 's/^experiment = "\(.*\)".*/\1/p' "$2")
for word in "$@"; do case $word in experiment=*) kind=${word#experiment=} ;; esac; done
deformable=$(grep -c '^physics = "deformable"' "$2")
given=$(grep -c '^state = ' "$2")
bodies="--set bodies.N=9 --set bodies.vertices=8"
if grep -q '^\[\[species\]\]' "$2"; then
  bodies=
  for k in $(seq $(grep -c '^\[\[species\]\]' "$2")); do
    bodies="$bodies --set species.$k.N=3 --set species.$k.vertices=8"
  done
fi
fraction=0.4
if grep -q '^dim = 3' "$2"; then
  bodies="--set bodies.N=4 --set bodies.vertices=12"
  fraction=0.05
fi
jam="$bodies --set jamming.packing_fraction=$fraction --set jamming.step=0.02 --set jamming.pressure=1e-3"
case $kind$deformable$given in
  preparation*) more="--set particles.N=40 --set particles.cut_lines=0" ;;
  oscillatory_shear1*) more="$jam --set shear.periods=2 --set shear.relative_frequency=0.2" ;;
  oscillatory_shear*) more="--set particles.N=40 --set particles.cut_lines=0 --set shear.periods=4"
    more="$more --set shear.relative_frequency=0.2" ;;
  dynamics00) more="--set particles.N=40 --set particles.cut_lines=0 --set time.steps=50" ;;
  dynamics10) more="$bodies --set time.steps=50" ;;
  jamming*) more="$jam" ;;
  compression*) more="$jam --set compression.per_decade=2" ;;
  uniaxial*) more="$bodies --set uniaxial.strain=0.03 --set uniaxial.pressure=2e-3" ;;
  friction*) more="--set sliding.step=0.1" ;;
  slump*) more="$bodies --set slump.settle_time=5 --set slump.spread_time=5 --set slump.width=4" ;;
esac
exec "$REAL" "$@" $more
)sh";

std::string document(const std::string& name) { return read_text(fs::path(SUPPLE_SOURCE_DIR) / name); }

/// Commands in the blocks of shell of a text, and in spans of code that name files, none twice.
std::vector<std::string> commands_of(const std::string& markdown) {
  std::vector<std::string> commands;
  std::set<std::string> seen;
  const std::regex span("`(supple [^`]*)`"), placeholder(R"((^|[ \[])[A-Z]{3,}\b)");
  bool block = false, shell = false;
  std::istringstream lines(markdown);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("```")) {
      block = !block;
      shell = block && line == "```sh";
      continue;
    }
    std::vector<std::string> found;
    if (shell && line.starts_with("supple ")) found.push_back(line.substr(0, line.find(" #")));
    if (!block && !line.starts_with("|"))
      for (std::sregex_iterator m(line.begin(), line.end(), span), end; m != end; ++m)
        if ((*m)[1].str().find('.') != std::string::npos && !std::regex_search((*m)[1].str(), placeholder))
          found.push_back((*m)[1]);
    for (std::string& command : found) {
      command.erase(command.find_last_not_of(' ') + 1);
      if (seen.insert(command).second) commands.push_back(command);
    }
  }
  return commands;
}

class Documents : public CommandTest {
 protected:
  void SetUp() override {
    CommandTest::SetUp();
    fs::create_directories(path("bin"));
    write("bin/supple", cheap_supple);
    fs::permissions(path("bin/supple"), fs::perms::owner_all);
    fs::create_directories(path("here"));
    fs::create_directory_symlink(fs::path(SUPPLE_SOURCE_DIR) / "examples", path("here/examples"));
  }
  void expect_to_work(const std::string& command) {
    const std::string line = "cd '" + path("here").string() + "' && export REAL='" SUPPLE_COMMAND "' PATH='" +
                             path("bin").string() + "':\"$PATH\" && { " + command + "\n} >../log 2>&1";
    EXPECT_EQ(std::system(line.c_str()), 0) << command << "\n" << read_text(path("log"));
  }
  void start_anew() {
    fs::remove_all(path("here"));
    fs::create_directories(path("here"));
    fs::create_directory_symlink(fs::path(SUPPLE_SOURCE_DIR) / "examples", path("here/examples"));
  }
};

TEST_F(Documents, ReadmeAndGuideInOneFolder) {
  std::vector<std::string> commands = commands_of(document("README.md"));
  EXPECT_GT(commands.size(), 12u);
  for (const std::string& command : commands_of(document("docs/guide.md"))) commands.push_back(command);
  EXPECT_GT(commands.size(), 20u);
  for (const std::string& command : commands) expect_to_work(command);
  EXPECT_TRUE(exists("here/first.pdf") && exists("here/end.pdf") && exists("here/gel.csv") &&
              exists("here/jamming_cell.png"));
}

TEST_F(Documents, HeadsOfTheExamples) {
  int commands = 0;
  for (const fs::directory_entry& example :
       fs::directory_iterator(fs::path(SUPPLE_SOURCE_DIR) / "examples")) {
    if (example.path().extension() != ".toml") continue;
    start_anew();
    std::istringstream lines(read_text(example.path()));
    for (std::string line; std::getline(lines, line) && line.starts_with("#");)
      if (line.starts_with("#   supple ")) expect_to_work(line.substr(4)), ++commands;
  }
  EXPECT_GT(commands, 7);
}

TEST_F(Documents, WhatInitSaysNext) {
  for (const Experiment& e : experiments()) {
    start_anew();
    Case plain;
    plain.general.experiment = e.name;
    const bool is_first = &experiment_of(plain) == &e;
    expect_to_work("supple init " + e.name +
                   (is_first ? "" : " --physics " + std::string(e.matter->physics)));
    const std::string said = read_text(path("log"));
    const auto at = said.find("next: ");
    ASSERT_NE(at, said.npos) << said;
    expect_to_work(said.substr(at + 6, said.find('\n', at) - at - 6));
    EXPECT_TRUE(exists("here/" + e.name + ".h5"));
    EXPECT_EQ(read_text(path("log")).find("warning: " + e.name), said.npos) << read_text(path("log"));
  }
}

}  // namespace
}  // namespace supple
