/// Command lines that cannot be read are answered with what was meant, in our words, and exit code 2.
#include <gmock/gmock.h>

#include "tests/app/command.hpp"

namespace supple {
namespace {

using testing::HasSubstr;

class CommandLine : public CommandTest {
 protected:
  void expect_answer(const std::string& arguments, const std::string& answer) {
    const Outcome outcome = supple(arguments);
    EXPECT_EQ(outcome.code, 2) << arguments;
    EXPECT_EQ(outcome.out, "") << arguments;
    EXPECT_EQ(outcome.err, "supple: " + answer + "\n");
  }
};

TEST_F(CommandLine, MisspeltCommandsAndOptionsNameTheNearest) {
  write("e.toml", "");
  expect_answer("rnu e.toml", "there is no command 'rnu'; did you mean 'run'?");
  expect_answer(
      "simulate e.toml",
      "there is no command 'simulate'; the commands are init, check, run, resume, list, show, export, "
      "snapshot, plot");
  expect_answer("check e.toml --theads 2", "supple check has no option --theads; did you mean --threads?");
  expect_answer("check --theads=2", "supple check has no option --theads; did you mean --threads?");
  expect_answer(
      "show r.h5 --frame 3",
      "supple show has no option --frame; its options are -h, --help, --json, -o, --output, --force");
  EXPECT_THAT(supple("export r.h5 --to cvs").err,
              HasSubstr("supple: --to cvs: not a choice; did you mean csv? It must be one of csv, "));
  expect_answer("init dynamics --physics deformabel",
                "--physics deformabel: not a choice; did you mean deformable? It must be one of documented, "
                "particleshear-1.0.2, deformable");
}

TEST_F(CommandLine, WordsThatAreMissingOrTooMany) {
  write("e.toml", "");
  expect_answer("run", "supple run needs a CASE.toml; write supple run CASE.toml");
  expect_answer("show", "supple show needs a RUN.h5; write supple show RUN.h5");
  expect_answer("check e.toml f.toml",
                "'f.toml' is one word too many (supple check takes one CASE.toml); see supple check --help");
  expect_answer("check e.toml --set", "--set needs a value; write --set SECTION.KEY=VALUE");
  expect_answer("--json", "supple has no option --json; its options are -h, --help, --version");
}

TEST_F(CommandLine, OptionsThatStandTwiceOrTakeNoValue) {
  expect_answer("show r.h5 -o a -o b", "--output stands more than once; keep one of them");
  expect_answer("export r.h5 --to csv --to xyz", "--to stands more than once; keep one of them");
  expect_answer("run e.toml -o", "--output needs a value; write --output FILE");
  expect_answer("show r.h5 --force=maybe", "--force takes no value; leave it away");
}

TEST_F(CommandLine, NumbersAreDecimalDigits) {
  write("e.toml", "");
  expect_answer("check e.toml --threads 010", "--threads 010: not a whole number; write --threads 10");
  expect_answer("check e.toml --threads ''",
                "--threads '': not a whole number; give a whole number from 1 to 1024");
  expect_answer("check e.toml --threads two",
                "--threads two: not a whole number; give a whole number from 1 to 1024");
  expect_answer("check e.toml --threads 0", "--threads 0: out of range; give a whole number from 1 to 1024");
  expect_answer("check e.toml --threads 99999999999",
                "--threads 99999999999: out of range; give a whole number from 1 to 1024");
  expect_answer("snapshot r.h5 --frame 010", "--frame 010: not a whole number; write --frame 10");
}

TEST_F(CommandLine, HelpIsACommandToo) {
  const Outcome help = supple("help"), of_run = supple("help run");
  EXPECT_EQ(help.code, 0);
  EXPECT_EQ(help.out, supple("--help").out);
  EXPECT_EQ(of_run.code, 0);
  EXPECT_EQ(of_run.out, supple("run --help").out);
  EXPECT_THAT(of_run.out, HasSubstr("--threads"));
  expect_answer("help rnu", "there is no command 'rnu'; did you mean 'run'?");
}

TEST_F(CommandLine, CasesAndRunsThatAreSwappedAreSaidToBe) {
  write("e.toml", "");
  write("r.h5", "\x89HDF\r\n\x1a\n");
  expect_answer("run r.h5",
                "'r.h5' is a run, not a case (a case is a text of keys and values); supple show r.h5 prints "
                "what it holds");
  const Outcome show = supple("show e.toml");
  EXPECT_EQ(show.code, 4);
  EXPECT_EQ(show.err,
            "supple: e.toml is not an HDF5 file (runs are); supple run e.toml makes a run of this case\n");
}

}  // namespace
}  // namespace supple
