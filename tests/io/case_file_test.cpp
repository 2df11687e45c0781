#include "supple/io/text/case_file.hpp"

#include <gmock/gmock.h>

#include <cstdio>
#include <filesystem>
#include <fstream>

#include "supple/core/error.hpp"
#include "supple/core/text_columns.hpp"

namespace supple {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// What reading `text` as the file c.toml says is wrong.
std::string error_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    read_case_text(text, "c.toml", overrides);
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::input);
    return e.what();
  }
  return "no error";
}

TEST(CaseFile, ReadsEveryTypeAndRecordsWhatWasGiven) {
  const Case c = read_case_text(
      "seed = 7\n[material]\nfriction = 0.3\nslip = \"reset\"\ndensity = 50\n"
      "[particles]\nN = 45\npermanent_links = false\n[box]\nwidth = \"250 um\"\n",
      "c.toml");
  EXPECT_EQ(c.general.seed, 7);
  EXPECT_EQ(c.material.friction, 0.3);
  EXPECT_EQ(c.material.slip, "reset");
  EXPECT_EQ(c.material.density, 50.0);
  EXPECT_EQ(c.particles.discs, 45);
  EXPECT_FALSE(c.particles.permanent_links);
  EXPECT_EQ(c.box.width, 250e-6);
  EXPECT_EQ(c.box.height, 500e-6);
  EXPECT_EQ(c.origin, "c.toml");
  EXPECT_EQ(c.given, (std::set<std::string>{"seed", "material.friction", "material.slip", "material.density",
                                            "particles.N", "particles.permanent_links", "box.width"}));
}

TEST(CaseFile, MisspeltKey) {
  EXPECT_EQ(error_of("[material]\nyoung_modulus = 1\nfricton = 0.1\n"),
            "c.toml:3:1: unknown key 'fricton' in [material]; did you mean 'friction'?");
  EXPECT_EQ(error_of("sed = 3"), "c.toml:1:1: unknown key 'sed' above any section; did you mean 'seed'?");
}

TEST(CaseFile, KeyInTheWrongSection) {
  EXPECT_EQ(error_of("[particles]\nfriction = 0.1\n"),
            "c.toml:2:1: unknown key 'friction' in [particles]; 'friction' belongs in [material]");
  EXPECT_EQ(error_of("friction = 0.1\n"),
            "c.toml:1:1: unknown key 'friction' above any section; 'friction' belongs in [material]");
  EXPECT_EQ(error_of("[box]\nseed = 1\n"),
            "c.toml:2:1: unknown key 'seed' in [box]; 'seed' belongs above any section");
  EXPECT_EQ(error_of("[box]\nfricton = 1\n"),
            "c.toml:2:1: unknown key 'fricton' in [box]; did you mean 'material.friction'?");
}

TEST(CaseFile, UnknownKeyWithNothingLikeItListsTheKeys) {
  EXPECT_EQ(error_of("[preparation]\nzzzzzzzz = 1\n"),
            "c.toml:2:1: unknown key 'zzzzzzzz' in [preparation]; the keys here are stress_tolerance, "
            "max_time");
}

TEST(CaseFile, UnknownSection) {
  EXPECT_EQ(error_of("[materials]\nfriction = 0.1\n"),
            "c.toml:1:1: unknown section [materials]; did you mean [material]?");
  EXPECT_THAT(error_of("[thermostat]\n"), HasSubstr("the sections are material, particles, box"));
  EXPECT_THAT(error_of("material = 3\n"), HasSubstr("'material' is a section, not a key"));
}

TEST(CaseFile, WrongType) {
  EXPECT_EQ(error_of("[particles]\nN = 150.0\n"),
            "c.toml:2:5: particles.N must be an integer, not a number with a decimal point (150) (number of "
            "discs); "
            "write 150");
  EXPECT_THAT(error_of("[particles]\nN = \"150\"\n"),
              HasSubstr("must be an integer, not a string (\"150\") (number of discs); write 150"));
  EXPECT_THAT(error_of("[particles]\npermanent_links = 1\n"),
              HasSubstr("must be true or false, not an integer (1)"));
  EXPECT_THAT(error_of("[particles]\npermanent_links = \"True\"\n"), HasSubstr("; write true"));
  EXPECT_THAT(error_of("", {"particles.permanent_links=No"}), HasSubstr("; write false"));
  EXPECT_THAT(error_of("", {"seed=18446744073709551615"}),
              HasSubstr("; integers go up to 9223372036854775807"));
  EXPECT_THAT(error_of("[shear]\namplitude = \"0,2\"\n"), HasSubstr("; write 0.2, without quotes"));
  EXPECT_THAT(error_of("[material]\nslip = 1\n"), HasSubstr("must be a string, not an integer (1)"));
  EXPECT_THAT(error_of("[material]\nfriction = [1]\n"), HasSubstr("must be a number, not a list"));
  EXPECT_THAT(error_of("[material]\nfriction = true\n"),
              HasSubstr("must be a number, not true or false (true)"));
  EXPECT_THAT(error_of("[material]\nfriction = \"high\"\n"),
              HasSubstr("material.friction: \"high\" is not a number"));
}

TEST(CaseFile, OutOfRangeSaysTheRangeAndTheUnit) {
  EXPECT_EQ(error_of("[box]\nwidth = -5e-4\n"),
            "c.toml:2:9: box.width = -0.0005 is out of range (length along the flow); it must be above 0 m");
  EXPECT_EQ(
      error_of("[box]\nwidth = \"-5 um\"\n"),
      "c.toml:2:9: box.width = \"-5 um\" is out of range (length along the flow); it must be above 0 m");
  EXPECT_EQ(error_of("[particles]\nN = 0\n"),
            "c.toml:2:5: particles.N = 0 is out of range (number of discs); it must be from 1 to 10000000");
  EXPECT_EQ(error_of("[shear]\nperiods = 0\n"),
            "c.toml:2:11: shear.periods = 0 is out of range (periods of shear); it must be above 0");
  EXPECT_THAT(error_of("[material]\nfriction = nan\n"), HasSubstr("it must be finite"));
  EXPECT_THAT(error_of("[particles]\nN = 9000000000\n"), HasSubstr("out of range"));
}

/// Every parameter that counts with an int: one more than it holds is refused, not wrapped to something
/// small.
TEST(CaseFile, IntegersDoNotWrap) {
  int tried = 0;
  Case defaults;
  for_each_section(defaults, [&](std::string_view section, auto& parameters) {
    using P = std::decay_t<decltype(parameters)>;
    for (const auto& field : fields<P>()) {
      if (!std::holds_alternative<int P::*>(field.member)) continue;
      ++tried;
      const std::string name = (section.empty() ? "" : std::string(section) + ".") + std::string(field.name);
      for (const char* value : {"4294967297", "2147483648", "-4294967295"})
        EXPECT_THAT(error_of("", {name + "=" + value}), HasSubstr(name + " = " + value + " is out of range"));
    }
  });
  EXPECT_GT(tried, 8);
  EXPECT_THAT(error_of("[particles]\nmax_cut_tries = 4294967297\n"),
              HasSubstr("it must be from 1 to 2147483647"));
}

TEST(CaseFile, InvalidChoice) {
  EXPECT_EQ(error_of("[material]\nslip = \"clmp\"\n"),
            "c.toml:2:8: material.slip = \"clmp\" is not a choice (tangential spring in slip: held at the "
            "Coulomb limit, "
            "frozen, or reset); did you mean \"clamp\"? It must be one of \"clamp\", \"freeze\", \"reset\"");
  EXPECT_THAT(error_of("experiment = \"rheology\"\n"),
              HasSubstr("; it must be one of \"oscillatory_shear\", \"preparation\", \"dynamics\""));
}

TEST(CaseFile, WrongUnit) {
  EXPECT_EQ(error_of("[box]\nwidth = \"5 kg\"\n"),
            "c.toml:2:9: box.width: \"5 kg\" has the wrong dimension, 'kg' is no multiple of m (length along "
            "the flow); "
            "write a number in m, or \"500 um\"");
}

TEST(CaseFile, SyntaxErrorsHaveAPositionAndAReason) {
  EXPECT_THAT(error_of("[material]\nfriction = \n"), StartsWith("c.toml:2:"));
  EXPECT_THAT(error_of("[material]\nfriction = \n"), HasSubstr("this is not valid TOML ("));
  EXPECT_THAT(error_of("[material]\nfriction = 1\nfriction = 2\n"), StartsWith("c.toml:3:"));
}

TEST(CaseFile, EveryProblemIsListedInTheOrderOfTheFile) {
  EXPECT_EQ(error_of("[shear]\nperiods = 0\n[box]\nwidth = 0\n"),
            "c.toml:2:11: shear.periods = 0 is out of range (periods of shear); it must be above 0\n"
            "c.toml:4:9: box.width = 0 is out of range (length along the flow); it must be above 0 m");
}

TEST(CaseFile, OverridesWinAndNeedNoQuotes) {
  const Case c =
      read_case_text("[material]\nfriction = 0.1\n", "c.toml",
                     {"material.friction=0.3", "material.slip=reset", "seed=9", "box.width=250 um",
                      "shear.rate=10*cos(t)", "initial.state=1", "particles.permanent_links=false"});
  EXPECT_EQ(c.material.friction, 0.3);
  EXPECT_EQ(c.material.slip, "reset");
  EXPECT_EQ(c.general.seed, 9);
  EXPECT_EQ(c.box.width, 250e-6);
  EXPECT_EQ(c.shear.rate, "10*cos(t)");
  EXPECT_EQ(c.initial.state, "1");
  EXPECT_FALSE(c.particles.permanent_links);
  EXPECT_TRUE(c.is_given("shear.rate"));
}

TEST(CaseFile, OverridesMayHaveSpacesAroundTheSign) {
  EXPECT_EQ(read_case_text("", "c.toml", {"shear.amplitude = 0.3"}).shear.amplitude, 0.3);
}

TEST(CaseFile, ErrorsInOverridesNameThem) {
  EXPECT_EQ(error_of("", {"material.fricton=0.3"}),
            "--set material.fricton=0.3: unknown key 'fricton' in [material]; did you mean 'friction'?");
  EXPECT_EQ(
      error_of("", {"particles.N=many"}),
      "--set particles.N=many: particles.N must be an integer, not a string (\"many\") (number of discs)");
  EXPECT_EQ(error_of("", {"friction=0.3"}),
            "--set friction=0.3: unknown key 'friction' above any section; 'friction' belongs in [material]");
  EXPECT_EQ(error_of("", {"materal.friction=0.3"}),
            "--set materal.friction=0.3: unknown section [materal]; did you mean [material]?");
  EXPECT_THAT(error_of("", {"material.friction"}), HasSubstr("not of the form section.key=value"));
  EXPECT_THAT(error_of("", {"seed=1\nthreads=4"}), HasSubstr("seed must be an integer"));
}

TEST(CaseFile, RelativePathsAreRelativeToTheCase) {
  EXPECT_EQ(read_case_text("[initial]\nstate = \"s.json\"\n", "some/where/c.toml").initial.state,
            "some/where/s.json");
  EXPECT_EQ(read_case_text("[initial]\nstate = \"/s.json\"\n", "some/where/c.toml").initial.state, "/s.json");
  EXPECT_EQ(read_case_text("", "some/where/c.toml").initial.state, "");
  EXPECT_EQ(read_case_text("", "some/where/c.toml", {"initial.state=s.json"}).initial.state, "s.json");
}

TEST(CaseFile, ARunInPlaceOfACaseIsSaidToBeOne) {
  const std::string path = testing::TempDir() + "run_as_case.h5";
  std::ofstream(path) << "\x89HDF\r\n\x1a\n";
  try {
    read_case(path);
    ADD_FAILURE();
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::input);
    EXPECT_THAT(e.what(), HasSubstr("is a run, not a case"));
    EXPECT_THAT(e.what(), HasSubstr("; supple show " + path));
  }
  std::remove(path.c_str());
}

TEST(CaseFile, UnreadableFilesAreFileErrors) {
  for (const std::string path : {"/nonexistent/case.toml", "/"}) {
    try {
      read_case(path);
      ADD_FAILURE() << path;
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), ErrorKind::file);
      EXPECT_THAT(e.what(), HasSubstr("cannot read the case '" + path + "'"));
    }
  }
}

TEST(CaseFile, WrittenCasesReadBackAsTheSame) {
  Case c;
  c.general.seed = 123456789012;
  c.material.friction = 0.1 + 0.2;
  c.material.young_modulus = 1e-300;
  c.shear.rate = "quote \" back \\ tab \t bell \a";
  c.initial.state = "/absolute.json";
  c.given = {"seed", "material.friction", "material.young_modulus", "shear.rate", "initial.state"};
  for (const CaseStyle style : {CaseStyle::commented, CaseStyle::resolved}) {
    const Case back = read_case_text(write_case(c, style), "c.toml");
    EXPECT_EQ(write_case(back, CaseStyle::resolved), write_case(c, CaseStyle::resolved));
    EXPECT_EQ(back.material.friction, c.material.friction);
    EXPECT_EQ(back.shear.rate, c.shear.rate);
    if (style == CaseStyle::commented) {
      EXPECT_EQ(back.given, c.given);
    }
  }
}

TEST(CaseFile, NumbersAreWrittenAsShortAsTheyReadBack) {
  Case c;
  c.box.width = 500e-6;
  c.material.friction = 0.1;
  const std::string text = write_case(c, CaseStyle::resolved);
  EXPECT_THAT(text, HasSubstr("\nwidth = 0.0005\n"));
  EXPECT_THAT(text, HasSubstr("\nfriction = 0.1\n"));
}

TEST(CaseFile, TheCommentedCaseFitsThePageAndExplainsEveryKey) {
  const std::string text = write_case(Case{}, CaseStyle::commented);
  EXPECT_THAT(text, HasSubstr("# young_modulus = 8000"));
  EXPECT_THAT(text, HasSubstr("# [kg/m^3] density of the discs; above 0\n"));
  EXPECT_THAT(text, HasSubstr(": \"clamp\", \"freeze\",\n"));
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(text_width(line), page_width) << line;
}

}  // namespace
}  // namespace supple
