#include <gmock/gmock.h>
#include <signal.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "supple/io/run/run_file.hpp"
#include "tests/app/command.hpp"
#include "tests/paths.hpp"

namespace supple {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class Run : public CommandTest {
 protected:
  json results(const std::string& run) {
    return json::parse(supple("show " + run + " --json").out)["results"];
  }
  /// Runs small.toml with these settings, stderr in "log", and sends the signals when that says `phase`: the
  /// exit code.
  int code_after_signals(const std::vector<std::string>& settings, const std::string& phase,
                         const std::vector<int>& signals) {
    const pid_t child = fork();
    if (child == 0) {
      std::filesystem::current_path(path(""));
      std::freopen("log", "w", stderr);
      std::vector<const char*> words{"supple", "run", "small.toml"};
      for (const std::string& setting : settings) words.insert(words.end(), {"--set", setting.c_str()});
      words.push_back(nullptr);
      execv(SUPPLE_COMMAND, const_cast<char* const*>(words.data()));
      _exit(1);
    }
    for (int i = 0; i < 1000 && read_text(path("log")).find(phase) == std::string::npos; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    for (const int signal : signals) kill(child, signal);
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
};

TEST_F(Run, LeavesARunAndPrintsItsModuli) {
  write_small_case();
  const Outcome run = supple("run small.toml");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("G'"));
  EXPECT_THAT(run.err, HasSubstr("oscillatory shear"));
  EXPECT_EQ(entries(), 2);
  const RunFile file(path("small.h5").string());
  EXPECT_EQ(file.status(), "complete");
  EXPECT_EQ(file.resolved_case().particles.discs, 24);
  EXPECT_GT(results("small.h5")["storage_modulus_internal"]["value"], 0);
}

TEST_F(Run, TheSameCaseGivesTheSameBits) {
  write_small_case();
  ASSERT_EQ(supple("run small.toml -o a.h5").code, 0);
  ASSERT_EQ(supple("run small.toml -o b.h5 --threads 2").code, 0);
  const RunFile a(path("a.h5").string()), b(path("b.h5").string());
  EXPECT_EQ(a.column("stress", a.columns("stress").back().name),
            b.column("stress", b.columns("stress").back().name));
}

TEST_F(Run, ForceReplacesAnOldRun) {
  write_small_case();
  write("small.h5", "old");
  ASSERT_EQ(supple("run small.toml --force").code, 0);
  EXPECT_EQ(RunFile(path("small.h5").string()).status(), "complete");
}

TEST_F(Run, ImagesAreDrawnOnRequest) {
  write_small_case();
  ASSERT_EQ(supple("run small.toml --set output.images=3 --set output.image_format=svg").code, 0);
  EXPECT_TRUE(exists("small_images/image0000000.svg"));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(path("small_images")), {}), 3);
}

TEST_F(Run, SnapshotsInEveryFormat) {
  write_small_case();
  ASSERT_EQ(supple("run small.toml").code, 0);
  for (const std::string ending : {"png", "jpg", "svg", "pdf", "ps"}) {
    EXPECT_EQ(supple("snapshot small.h5 -o cell." + ending).code, 0);
    EXPECT_GT(std::filesystem::file_size(path("cell." + ending)), 1000u);
  }
  const Outcome wrong = supple("snapshot small.h5 --frame 99 -o x.png");
  EXPECT_EQ(wrong.code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("has no frame 99; give 0 to 3, or -1 for the last"));
  EXPECT_EQ(supple("snapshot small.h5 -o x.bmp").code, 2);
}

TEST_F(Run, PlotsAndExports) {
  write_small_case();
  ASSERT_EQ(supple("run small.toml --set output.plot=true --set output.text=true").code, 0);
  EXPECT_TRUE(exists("small_stress.png"));
  EXPECT_THAT(read_text(path("small.txt")), HasSubstr("Output data"));
  EXPECT_EQ(supple("plot small.h5 -o loop.svg").code, 0);
  EXPECT_THAT(read_text(path("loop.svg")), HasSubstr("<svg"));
  EXPECT_EQ(supple("export small.h5").code, 0);
  EXPECT_THAT(read_text(path("small.csv")), testing::StartsWith("t [s],strain,strain_rate [1/s],"));
  EXPECT_EQ(supple("export small.h5").code, 4);
}

TEST_F(Run, TheFinalStateStartsAnotherRun) {
  write_small_case();
  ASSERT_EQ(supple("run small.toml").code, 0);
  const Outcome next = supple("run small.toml -o next.h5 --set initial.state=small.h5");
  EXPECT_EQ(next.code, 0) << next.err;
  ASSERT_EQ(supple("export small.h5 --to state -o state.json").code, 0);
  EXPECT_EQ(supple("run small.toml -o json.h5 --set initial.state=state.json").code, 0);
}

/// Ctrl-C, a polite kill, and a terminal that closes (which the shell and the kernel both tell).
class Stops : public Run, public testing::WithParamInterface<std::vector<int>> {};
INSTANTIATE_TEST_SUITE_P(Run, Stops,
                         testing::Values(std::vector{SIGINT}, std::vector{SIGTERM},
                                         std::vector{SIGHUP, SIGHUP}));

TEST_P(Stops, ASignalKeepsWhatWasComputed) {
  write_small_case();
  EXPECT_EQ(code_after_signals({"shear.periods=100000"}, "oscillatory", GetParam()), 128 + GetParam()[0]);
  EXPECT_THAT(read_text(path("log")),
              HasSubstr("what was computed is in small.h5; go on with: supple resume small.h5"));
  EXPECT_EQ(RunFile(path("small.h5").string()).status(), "interrupted");
}

TEST_F(Run, ASignalIsHeededBetweenImages) {
  write_small_case();
  EXPECT_EQ(code_after_signals({"output.frames=400", "output.images=400"}, "draw images", {SIGINT}), 130);
  EXPECT_THAT(read_text(path("log")),
              HasSubstr("of 400 images are drawn (the run was asked to stop); small.h5 is complete"));
  EXPECT_EQ(RunFile(path("small.h5").string()).status(), "complete");
}

TEST_F(Run, ARunFromAPreparedSuspensionIsTheRunThatPreparesIt) {
  write_small_case();
  ASSERT_EQ(supple("run small.toml").code, 0);
  const Outcome prepared = supple("run small.toml --set experiment=preparation -o rest.h5");
  ASSERT_EQ(prepared.code, 0) << prepared.err;
  EXPECT_FALSE(std::filesystem::exists(path("rest_stress.png")));
  const Outcome continued = supple("run small.toml --set initial.state=rest.h5 -o again.h5");
  ASSERT_EQ(continued.code, 0) << continued.err;
  const RunFile a(path("small.h5").string()), b(path("again.h5").string());
  for (const char* column :
       {"t", "strain", "shear_stress_plates", "shear_stress_virial", "shear_stress_internal"})
    EXPECT_EQ(a.column("stress", column), b.column("stress", column)) << column;
  EXPECT_EQ(supple("run small.toml --set experiment=preparation --set initial.state=rest.h5 -o no.h5").code,
            2);
}

TEST_F(Run, ExamplesAreSound) {
  for (const std::string name : {"microgel", "preparation", "dynamics_pair", "jamming", "compression",
                                 "uniaxial_compression", "plate_compression", "slump", "deformable_gel",
                                 "adhesive_gel", "mixture", "sticky_kinds", "friction"}) {
    const Outcome check = supple("check " SUPPLE_SOURCE_DIR "/examples/" + name + ".toml");
    EXPECT_EQ(check.code, 0) << check.err;
  }
  ASSERT_EQ(supple("run " SUPPLE_SOURCE_DIR "/examples/dynamics_pair.toml").code, 0);
  EXPECT_EQ(RunFile(path("dynamics_pair.h5").string()).frames(), 201) << "first and last included";
  const Outcome pair = supple("run " SUPPLE_SOURCE_DIR "/examples/friction.toml");
  ASSERT_EQ(pair.code, 0) << pair.err;
  EXPECT_NEAR(RunFile(path("friction.h5").string()).value("results", "friction_max"), 0.537, 0.04);
  EXPECT_TRUE(std::filesystem::exists(path("friction_friction.png")));
}

}  // namespace
}  // namespace supple
