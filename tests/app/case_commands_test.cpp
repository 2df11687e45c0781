#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "supple/core/version.hpp"
#include "tests/app/command.hpp"

namespace supple {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using CaseCommands = CommandTest;

TEST_F(CaseCommands, WithoutArgumentsTheHelpIsShown) {
  const Outcome nothing = supple("");
  EXPECT_EQ(nothing.code, 2);
  EXPECT_THAT(nothing.err, HasSubstr("supple init oscillatory_shear"));
  const Outcome help = supple("run --help");
  EXPECT_EQ(help.code, 0);
  EXPECT_THAT(help.out, HasSubstr("--set"));
  EXPECT_THAT(help.out, HasSubstr("Exit codes"));
  EXPECT_THAT(supple("--version").out, HasSubstr(std::string("supple ") + version()));
}

TEST_F(CaseCommands, UnknownCommandsAndOptionsAreBadInput) {
  EXPECT_EQ(supple("simulate").code, 2);
  EXPECT_EQ(supple("check --wrong case.toml").code, 2);
}

TEST_F(CaseCommands, InitWritesACaseThatIsSound) {
  const Outcome init = supple("init");
  EXPECT_EQ(init.code, 0) << init.err;
  EXPECT_THAT(read_text(path("oscillatory_shear.toml")), HasSubstr("\nfriction = 0.01"));
  const Outcome check = supple("check oscillatory_shear.toml");
  EXPECT_EQ(check.code, 0) << check.err;
  EXPECT_THAT(check.out, HasSubstr("oscillatory_shear.toml: sound"));
}

TEST_F(CaseCommands, InitOverwritesNothing) {
  write("mine.toml", "precious");
  const Outcome init = supple("init dynamics -o mine.toml");
  EXPECT_EQ(init.code, 4);
  EXPECT_THAT(init.err, HasSubstr("mine.toml exists"));
  EXPECT_EQ(read_text(path("mine.toml")), "precious");
  EXPECT_EQ(supple("init dynamics -o mine.toml --force").code, 0);
  EXPECT_THAT(read_text(path("mine.toml")), HasSubstr("experiment = \"dynamics\""));
}

TEST_F(CaseCommands, InitSuggestsTheExperiment) {
  const Outcome init = supple("init dynamic");
  EXPECT_EQ(init.code, 2);
  EXPECT_THAT(init.err, HasSubstr("there is no experiment 'dynamic'; did you mean 'dynamics'?"));
}

TEST_F(CaseCommands, CheckPrintsDerivedNumbersAndWarnings) {
  write("c.toml", "[material]\nplateau_slope = 0.2\n");
  const Outcome text = supple("check c.toml");
  EXPECT_THAT(text.out, HasSubstr("time_step"));
  EXPECT_THAT(text.out, HasSubstr("spring_constant"));
  EXPECT_THAT(text.out, HasSubstr("warning: material.plateau_slope has no effect"));
  const json j = json::parse(supple("check c.toml --json").out);
  EXPECT_NEAR(j["derived"]["spring_constant"]["value"], 3.14159265358979 / 8 * 8000, 1e-9);
  EXPECT_GT(j["derived"]["steps"]["value"], 100);
  EXPECT_GT(j["estimated_seconds"], 0);
  EXPECT_EQ(j["warnings"].size(), 1u);
}

TEST_F(CaseCommands, SetAndThreadsReachTheCase) {
  write("c.toml", "");
  const json j =
      json::parse(supple("check c.toml --json --set material.young_modulus='16 kPa' --threads 2").out);
  EXPECT_NEAR(j["derived"]["spring_constant"]["value"], 3.14159265358979 / 8 * 16000, 1e-9);
  const Outcome wrong = supple("check c.toml --set material.fricton=0.3");
  EXPECT_EQ(wrong.code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("--set material.fricton=0.3: unknown key 'fricton'"));
}

TEST_F(CaseCommands, ListKnowsEverySection) {
  const Outcome all = supple("list");
  EXPECT_EQ(all.code, 0);
  EXPECT_THAT(all.out, HasSubstr("oscillatory_shear     G'"));
  EXPECT_THAT(all.out, HasSubstr("young_modulus = 8000"));
  const Outcome one = supple("list time");
  EXPECT_THAT(one.out, HasSubstr("step_factor"));
  EXPECT_THAT(one.out, Not(HasSubstr("young_modulus")));
  EXPECT_THAT(supple("list general").out, HasSubstr("seed = 1"));
  const json j = json::parse(supple("list --json").out);
  EXPECT_EQ(j["parameters"]["material"][0]["name"], "young_modulus");
  EXPECT_EQ(j["parameters"]["material"][0]["unit"], "Pa");
  const Outcome wrong = supple("list tim");
  EXPECT_EQ(wrong.code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("did you mean 'time'?"));
}

}  // namespace
}  // namespace supple
