/// Runs that are killed, as by the kernel or a scheduler, and go on by `supple resume`.
#include <gmock/gmock.h>

#include <fmt/format.h>

#include <csignal>
#include <cstring>
#include <random>
#include <thread>

#include "supple/io/run/run_file.hpp"
#include "tests/app/command.hpp"
#include "tests/io/same_frame.hpp"

namespace supple {
namespace {

using ::testing::HasSubstr;
using testing::same_bits;

#if defined(__SANITIZE_ADDRESS__)
const std::string sanitized = "ASAN_OPTIONS=verify_asan_link_order=0:detect_leaks=0 ";
#else
const std::string sanitized;
#endif

/// Every number of two runs but the processor time they took.
void expect_same_files(const std::string& one, const std::string& other) {
  const RunFile a(one), b(other);
  EXPECT_EQ(a.status(), b.status());
  ASSERT_EQ(a.tables(), b.tables());
  for (const std::string& table : a.tables())
    for (const Column& column : a.columns(table))
      EXPECT_TRUE(same_bits(a.column(table, column.name), b.column(table, column.name)))
          << table << "/" << column.name;
  ASSERT_EQ(a.frames(), b.frames());
  for (std::int64_t k = 0; k < a.frames(); ++k) testing::expect_same(a.frame(k), b.frame(k));
  std::vector<std::string> groups = a.value_groups(), others = b.value_groups();
  std::sort(groups.begin(), groups.end());
  std::sort(others.begin(), others.end());
  ASSERT_EQ(groups, others);
  for (const std::string& group : groups) {
    std::map<std::string, std::pair<double, double>> first, second;
    for (const RunValue& v : a.values(group)) first[v.name.name] = {v.value, v.error};
    for (const RunValue& v : b.values(group)) second[v.name.name] = {v.value, v.error};
    first.erase("cpu_time");
    second.erase("cpu_time");
    EXPECT_EQ(first, second) << group;
  }
  EXPECT_EQ(a.warnings(), b.warnings());
  testing::expect_same(a.final_state().first, b.final_state().first);
}

struct Named {
  std::string name, text;
};
void PrintTo(const Named& one, std::ostream* to) { *to << one.name; }

class Resume : public CommandTest {
 protected:
  /// Runs the command and dies at the n-th call that makes a file durable or visible.
  int die_at(long n, const std::string& arguments) {
    set_prefix(sanitized + "LD_PRELOAD='" SUPPLE_DIE_AT "' DIE_AT=" + std::to_string(n) + " ");
    const Outcome o = supple(arguments);
    set_prefix("");
    if (o.code != 0 && o.code != 137) ADD_FAILURE() << o.code << ": " << o.err;
    return o.code;
  }
  void write_discs(const std::string& more = "") {
    write("case.toml",
          "experiment = \"oscillatory_shear\"\n[particles]\nN = 45\n[preparation]\nstress_tolerance = "
          "1\n[shear]\nrelative_frequency = 0.2\npre_periods = 0\nperiods = 400\npost_periods = "
          "0\n[output]\nframes = 5\nenergies = true\nplot = false\nsnapshot = false\n" +
              more);
  }
};

class Killed : public Resume, public ::testing::WithParamInterface<Named> {};

/// At writes, syncs and renames of segments, checkpoints and the merged file, later and later in its life;
/// the run must come to its end with every number of the run that was left alone.
TEST_P(Killed, AtEveryCallThatTouchesAFileItGoesOn) {
  write("case.toml", GetParam().text + "[output]\nplot = false\nsnapshot = false\n");
  const Outcome whole = supple("run case.toml -o whole.h5");
  ASSERT_EQ(whole.code, 0) << whole.err;
  int deaths = 0;
  long n = 1;
  // A checkpoint at every safe point.
  int code = die_at(n, "run case.toml -o case.h5 --checkpoint 0.000001");
  for (; code != 0 && deaths < 100; n += n / 4 + 1) {
    ++deaths;
    if (!exists("case.h5.partial/start.h5")) {  // killed before there was anything
      std::filesystem::remove_all(path("case.h5.partial"));
      code = die_at(n, "run case.toml -o case.h5 --checkpoint 0.000001");
    } else {
      code =
          die_at(n, "resume case.h5 --checkpoint 0.000001" + std::string(deaths % 2 ? " --threads 2" : ""));
    }
  }
  ASSERT_EQ(code, 0);
  EXPECT_GE(deaths, 8);
  expect_same_files(path("whole.h5").string(), path("case.h5").string());
  EXPECT_FALSE(exists("case.h5.partial"));
}

INSTANTIATE_TEST_SUITE_P(
    Runs, Killed,
    ::testing::Values(
        Named{"discs",
              "experiment = \"oscillatory_shear\"\n[particles]\nN = 45\n[preparation]\nstress_tolerance = "
              "1\n[shear]\nrelative_frequency = 0.2\npre_periods = 0\nperiods = 1\npost_periods = 0\n"},
        Named{"jam", "experiment = \"jamming\"\n[bodies]\nN = 6\nvertices = 8\n[jamming]\npressure = 1e-4\n"},
        Named{"compression",
              "experiment = \"compression\"\n[bodies]\nN = 6\nvertices = 8\n[jamming]\npressure = "
              "1e-3\n[compression]\nhighest_pressure = 1e-2\nper_decade = 2\n"},
        Named{"uniaxial",
              "experiment = \"uniaxial_compression\"\n[bodies]\nN = 6\nvertices = "
              "8\n[uniaxial]\nstrain = 0.1\nstep = 0.005\n"},
        Named{"slump",
              "experiment = \"slump\"\n[bodies]\nN = 5\nvertices = 8\n[slump]\nsettle_time = "
              "0.4\nspread_time = 0.4\n"},
        Named{"shells",
              "experiment = \"oscillatory_shear\"\nphysics = \"deformable\"\n[bodies]\nN = 6\nvertices = "
              "8\n[jamming]\npressure = 1e-3\n[material]\nfriction = 0.3\n[shear]\nrelative_frequency = "
              "0.5\npre_periods = 0\nperiods = 1\npost_periods = 0\n"}),
    [](const auto& one) { return one.param.name; });

TEST_F(Resume, AStoppedRunShowsWhatItHasAndGoesOn) {
  write_discs();
  ASSERT_EQ(supple("run case.toml -o whole.h5").code, 0);
  const Outcome stopped = supple("run case.toml -o case.h5 --time-limit 0.05");
  ASSERT_EQ(stopped.code, 130) << stopped.err;
  EXPECT_THAT(stopped.err, HasSubstr("go on with: supple resume case.h5"));
  std::string shown;  // of the first stop within the shear: before the preparation has ended there is no file
  int stops = 1;
  for (Outcome o = stopped; o.code != 0 && stops < 50; ++stops) {
    o = supple(fmt::format("resume case.h5 --time-limit {}", 0.1 * stops));  // a busy machine needs more
    ASSERT_THAT(o.code, ::testing::AnyOf(0, 130)) << o.err;
    const bool later = o.code == 130 && exists("case.h5");
    if (later && shown.find("oscillatory shear\n") == shown.npos) shown = supple("show case.h5").out;
  }
  EXPECT_GT(stops, 2);
  EXPECT_THAT(shown, HasSubstr(", interrupted\n"));
  EXPECT_THAT(shown, HasSubstr("warning: interrupted"));
  EXPECT_THAT(shown, HasSubstr("oscillatory shear\n"));
  expect_same_files(path("whole.h5").string(), path("case.h5").string());
  const Outcome again = supple("resume case.h5");
  EXPECT_EQ(again.code, 4);
  EXPECT_THAT(again.err, HasSubstr("it is complete"));
}

/// The whole cycles that a run has are demodulated as if it had been asked for no more.
TEST_F(Resume, AnInterruptedRunHasTheModuliOfItsCycles) {
  for (const std::string physics : {"documented", "deformable"}) {
    write("case.toml",
          "experiment = \"oscillatory_shear\"\nphysics = \"" + physics + "\"\n" +
              (physics == "documented" ? "[particles]\nN = 45\n"
                                       : "[bodies]\nN = 6\nvertices = 8\n[jamming]\npressure = "
                                         "1e-3\n") +
              "[shear]\namplitude = 0.02\nrelative_frequency = 0.2\npre_periods = 0.5\nperiods = "
              "100000\npost_periods = 0\n[output]\nplot = false\nsnapshot = false\nframes = 3\n");
    const std::string file = physics + ".h5";
    int cycles = 0;
    for (int seconds = 1; cycles < 2 && seconds < 100; seconds *= 3) {  // a slow machine needs more
      const Outcome stopped =
          supple(fmt::format("run case.toml -o {} --force --time-limit {}", file, seconds));
      ASSERT_EQ(stopped.code, 130) << stopped.err;
      if (!exists(file)) continue;  // it was still being prepared
      cycles = static_cast<int>(RunFile(path(file).string()).find_value("results", "cycles").value_or(0));
    }
    ASSERT_GE(cycles, 2);
    const RunFile run(path(file).string());
    const Outcome fewer =
        supple("run case.toml -o fewer.h5 --force --set shear.periods=" + std::to_string(cycles + 1));
    ASSERT_EQ(fewer.code, 0) << fewer.err;
    const RunFile whole(path("fewer.h5").string());
    for (const char* modulus : {"storage_modulus_virial", "loss_modulus_virial"})
      EXPECT_NEAR(run.value("results", modulus), whole.value("results", modulus),
                  1e-9 * std::abs(whole.value("results", modulus)))
          << physics << ", " << modulus;
  }
}

/// The file that a run started from may be gone by then.
TEST_F(Resume, GoesOnWithoutTheFileThatItStartedFrom) {
  write_discs();
  ASSERT_EQ(supple("run case.toml -o first.h5 --set shear.periods=2").code, 0);
  const std::string from = "run case.toml --set initial.state=first.h5 --set shear.amplitude=0.3 -o ";
  ASSERT_EQ(supple(from + "whole.h5").code, 0);
  ASSERT_EQ(supple(from + "case.h5 --time-limit 0.05").code, 130);
  std::filesystem::remove(path("first.h5"));
  EXPECT_EQ(supple("resume case.h5").code, 0);
  expect_same_files(path("whole.h5").string(), path("case.h5").string());
}

/// A run that is told to checkpoint goes on, and can be resumed from there after a kill.
TEST_F(Resume, ASignalAsksForACheckpoint) {
  write_discs();
  ASSERT_EQ(supple("run case.toml -o whole.h5").code, 0);
  write("signal.sh", "'" SUPPLE_COMMAND
                     "' run case.toml -o case.h5 --checkpoint 0 2>log & pid=$!\n"
                     "until grep -q 'oscillatory' log; do sleep 0.01; done\nkill -USR1 $pid\n"
                     "until ls case.h5.partial/checkpoint-* >/dev/null 2>&1 || ! kill -0 $pid; do sleep "
                     "0.01; done\nkill -KILL $pid\nwait $pid\n[ $? = 137 ]\n");
  ASSERT_EQ(std::system(("cd '" + path("").string() + "' && sh signal.sh 2>/dev/null").c_str()), 0);
  EXPECT_EQ(supple("resume case.h5").code, 0);
  expect_same_files(path("whole.h5").string(), path("case.h5").string());
}

TEST_F(Resume, SaysWhatIsWrong) {
  EXPECT_THAT(supple("resume none.h5").err, HasSubstr("there is no run none.h5"));
  write_discs();
  for (const char* time : {"", "abc", "-3", "1:2", "1-30"})
    EXPECT_EQ(supple("run case.toml --time-limit '" + std::string(time) + "'").code, 2) << time;
}

TEST_F(Resume, NamesWithSpacesAreQuoted) {
  write_discs();
  const Outcome stopped = supple("run case.toml -o 'a run.h5' --time-limit 0.05");
  EXPECT_THAT(stopped.err, HasSubstr("supple resume 'a run.h5'"));
  EXPECT_EQ(supple("resume 'a run.h5'").code, 0);
}

}  // namespace
}  // namespace supple
