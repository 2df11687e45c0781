/// Bad input is refused with a message, the right exit code, and nothing written or overwritten.
#include <gmock/gmock.h>

#include "supple/io/run/run_file.hpp"
#include "tests/app/command.hpp"
#include "tests/paths.hpp"

namespace supple {
namespace {

using testing::HasSubstr;

class BadInput : public CommandTest {
 protected:
  /// `run` of this case must fail so, before anything is computed, and leave only the case.
  void expect_refused(const std::string& text, int code, const std::string& message) {
    write("c.toml", text);
    const Outcome run = supple("run c.toml");
    EXPECT_EQ(run.code, code) << run.err;
    EXPECT_THAT(run.err, HasSubstr(message));
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(entries(), 1);
  }
};

TEST_F(BadInput, MisspeltKey) {
  expect_refused("[material]\nfricton = 0.1\n", 2,
                 "c.toml:2:1: unknown key 'fricton' in [material]; did you mean 'friction'?");
}
TEST_F(BadInput, UnknownKey) {
  expect_refused("[material]\ncolour = 0.1\n", 2, "unknown key 'colour' in [material]");
}
TEST_F(BadInput, WrongType) {
  expect_refused("[particles]\nN = \"many\"\n", 2,
                 "c.toml:2:5: particles.N must be an integer, not a string");
}
TEST_F(BadInput, NegativeSize) {
  expect_refused("[box]\nwidth = -5e-4\n", 2, "c.toml:2:9: box.width = -0.0005 is out of range");
}
TEST_F(BadInput, NoDiscs) { expect_refused("[particles]\nN = 0\n", 2, "particles.N = 0 is out of range"); }
TEST_F(BadInput, NoPeriods) {
  expect_refused("[shear]\nperiods = 0\n", 2, "shear.periods = 0 is out of range");
}
TEST_F(BadInput, PackingThatCannotBeReached) {
  expect_refused("[particles]\nN = 4\n", 2,
                 "c.toml: particles.packing_fraction = 1.5 cannot be reached with N = 4");
}
TEST_F(BadInput, SyntaxError) { expect_refused("[material\n", 2, "c.toml:1:10: this is not valid TOML"); }
TEST_F(BadInput, MissingStateFile) { expect_refused("[initial]\nstate = \"none.json\"\n", 4, "none.json"); }
TEST_F(BadInput, TimeStepAboveTheStabilityLimit) {
  expect_refused("[time]\nstep = \"1 ms\"\n", 2, "above the stability limit");
}
TEST_F(BadInput, RateThatIsNoExpression) {
  expect_refused("experiment = \"dynamics\"\n[time]\nsteps = 10\n[shear]\nrate = \"10*cos(\"\n", 2, "rate");
}

TEST_F(BadInput, RatesThatAreNotFiniteNameTheFormulaAndTheTimeBeforeAnythingRuns) {
  for (const std::string rate : {"1/t", "1/0", "sqrt(t-1)"}) {
    const Outcome run = supple(
        "run " SUPPLE_SOURCE_DIR "/examples/dynamics_pair.toml -o r.h5 --set 'shear.rate=" + rate + "'");
    EXPECT_EQ(run.code, 2) << run.err;
    EXPECT_THAT(run.err, HasSubstr("[shear] rate \"" + rate + "\" is "));
    EXPECT_THAT(run.err, HasSubstr("at t = 0;"));
    EXPECT_EQ(entries(), 0);
  }
}

TEST_F(BadInput, FormulasWithADecimalCommaOrAnAssignmentAreRefused) {
  const std::string law = "[material]\nelastic_law = \"expression\"\nelastic_expression = ";
  expect_refused(law + "\"0,5*k*(d0-d)\"\n", 2, "decimals have a point: 0.5");
  expect_refused(law + "\"d=d0 ? 0 : k*(d0-d)\"\n", 2, "a single = sets a variable; == compares");
}

TEST_F(BadInput, LawsThatDivergeAttractOrAreNotFinite) {
  const std::string law = "[material]\nelastic_law = \"expression\"\nelastic_expression = ";
  expect_refused(law + "\"k*(d0-d)*d0/d\"\n", 2, "diverges: 3.26");
  expect_refused(law + "\"-k*(d0-d)\"\n", 2, "attracts at d = ");
  expect_refused(law + "\"k*log(d-d0)\"\n", 2, "c.toml: [material] elastic_expression \"k*log(d-d0)\" is ");
  expect_refused(law + "\"k*(d0-d\"\n", 2, "cannot be read (a bracket is opened and not closed)");
  expect_refused(law + "\"\"\n", 2, "without material.elastic_expression");
}

TEST_F(BadInput, ARunThatBlowsUpStopsAndKeepsWhatItHad) {
  const Outcome run =
      supple("run " SUPPLE_SOURCE_DIR
             "/examples/dynamics_pair.toml -o r.h5 --set 'shear.rate=min(exp(10*(t-0.5)^3*1e6), 1e300)'");
  EXPECT_EQ(run.code, 3) << run.err;
  EXPECT_THAT(run.err, testing::ContainsRegex("site [01] left a million cells behind"));
  EXPECT_THAT(run.err, HasSubstr("what was computed is in r.h5"));
  const RunFile file(path("r.h5").string());
  EXPECT_THAT(file.status(), testing::StartsWith("failed: site"));
  EXPECT_GT(file.frames(), 10);
}

TEST_F(BadInput, MissingCase) {
  const Outcome run = supple("run none.toml");
  EXPECT_EQ(run.code, 4);
  EXPECT_THAT(run.err, HasSubstr("cannot read the case 'none.toml'"));
}

TEST_F(BadInput, TruncatedStateFile) {
  write("state.json",
        "{\"params\": {\"size_x\": 500, \"size_y\": 500}, \"initial\": {\"spheres\": [{\"x\": 1");
  write("c.toml", "[initial]\nstate = \"state.json\"\n");
  const Outcome run = supple("run c.toml");
  EXPECT_EQ(run.code, 4) << run.err;
  EXPECT_THAT(run.err, HasSubstr("state.json"));
  EXPECT_EQ(entries(), 2);
}

TEST_F(BadInput, MissingOutputFolder) {
  write_small_case();
  const Outcome run = supple("run small.toml -o nowhere/run.h5");
  EXPECT_EQ(run.code, 4);
  EXPECT_THAT(run.err, HasSubstr("there is no folder nowhere); make the folder first"));
  EXPECT_EQ(entries(), 1);
}

TEST_F(BadInput, OutputFolderThatIsNotWritable) {
  write_small_case();
  std::filesystem::create_directory(path("sealed"));
  std::filesystem::permissions(path("sealed"), std::filesystem::perms(0555));
  if (geteuid() == 0) run_as_nobody();
  const Outcome run = supple("run small.toml -o sealed/run.h5");
  EXPECT_EQ(run.code, 4) << run.err;
  EXPECT_THAT(run.err, HasSubstr("cannot create sealed/run.h5 (folder sealed is not writable)"));
}

TEST_F(BadInput, AnExistingRunIsNotOverwritten) {
  write_small_case();
  write("small.h5", "precious");
  const Outcome run = supple("run small.toml");
  EXPECT_EQ(run.code, 4);
  EXPECT_THAT(run.err, HasSubstr("small.h5 exists"));
  EXPECT_EQ(read_text(path("small.h5")), "precious");
  EXPECT_EQ(entries(), 2);
}

TEST_F(BadInput, APictureBesideTheRunIsNotOverwritten) {
  write_small_case();
  write("small_cell.png", "precious");
  const Outcome run = supple("run small.toml --set output.snapshot=true");
  EXPECT_EQ(run.code, 4);
  EXPECT_THAT(run.err, HasSubstr("small_cell.png exists"));
  EXPECT_EQ(read_text(path("small_cell.png")), "precious");
  EXPECT_FALSE(exists("small.h5"));
}

TEST_F(BadInput, AnOldRunSurvivesABadCaseEvenWithForce) {
  write("c.toml", "[time]\nstep = 1\n");
  write("c.h5", "precious");
  EXPECT_EQ(supple("run c.toml --force").code, 2);
  EXPECT_EQ(read_text(path("c.h5")), "precious");
}

TEST_F(BadInput, RunsThatCannotBeRead) {
  write("broken.h5", "no run");
  for (const std::string command : {"show", "plot", "snapshot", "export"}) {
    EXPECT_EQ(supple(command + " none.h5").code, 4) << command;
    const Outcome broken = supple(command + " broken.h5");
    EXPECT_EQ(broken.code, 4) << command;
    EXPECT_THAT(broken.err, HasSubstr("broken.h5")) << command;
  }
  EXPECT_EQ(entries(), 1);
}

}  // namespace
}  // namespace supple
