/// The documents say what the code does.
#include <gmock/gmock.h>

#include <filesystem>
#include <regex>
#include <set>
#include <string>

#include "supple/io/run/quantity_tables.hpp"
#include "supple/io/text/case_file.hpp"
#include "tests/app/command.hpp"
#include "tests/paths.hpp"

namespace supple {
namespace {

std::string document(const std::string& name) {
  const std::string text = read_text(std::string(SUPPLE_SOURCE_DIR) + "/" + name);
  EXPECT_FALSE(text.empty()) << name;
  return text;
}

/// The first block of this language below the heading.
std::string code_block(const std::string& text, const std::string& heading, const std::string& language) {
  const std::string fence = "```" + language + "\n";
  const auto begin = text.find(fence, text.find("## " + heading + "\n")) + fence.size();
  return text.substr(begin, text.find("```", begin) - begin);
}

std::set<std::string> all_keys() {
  std::set<std::string> keys;
  const Case defaults;
  for_each_section(defaults, [&](std::string_view section, const auto& parameters) {
    for (const auto& field : fields<std::decay_t<decltype(parameters)>>())
      keys.insert((section.empty() ? "" : std::string(section) + ".") + std::string(field.name));
  });
  return keys;
}

TEST(Guide, ParameterTablesAreThoseOfTheCode) {
  const std::string text = document("docs/parameters.md"), tables = describe_parameters();
  EXPECT_NE(text.find(tables), std::string::npos) << "docs/parameters.md should end with\n" << tables;
}

TEST(Guide, TablesOfQuantitiesAreThoseOfTheCode) {
  const std::string text = document("docs/quantities.md"), tables = describe_quantities();
  EXPECT_NE(text.find(tables), std::string::npos) << "docs/quantities.md should end with\n" << tables;
}

TEST(Guide, NamesOnlyKeysThatExist) {
  const std::set<std::string> keys = all_keys();
  const std::regex mention(
      "`((material|particles|box|shear|time|preparation|initial|output)\\.\\w+)( = [^`]*)?`");
  int mentions = 0;
  for (const char* name : {"docs/guide.md", "docs/theory/microgel.md"}) {
    const std::string text = document(name);
    for (std::sregex_iterator m(text.begin(), text.end(), mention), end; m != end; ++m, ++mentions)
      EXPECT_TRUE(keys.count((*m)[1])) << name << " mentions " << (*m)[1];
  }
  EXPECT_GT(mentions, 20);
}

/// What the documents tell a reader to type, typed.
class Examples : public CommandTest {
 protected:
  void run_script(const std::string& interpreter, const std::string& script) {
    write("script", script);
    const std::string folder = std::filesystem::path(SUPPLE_COMMAND).parent_path().string();
    const std::string line = "cd '" + path("").string() + "' && PATH='" + folder + "':\"$PATH\" " +
                             interpreter + " script >log 2>&1";
    EXPECT_EQ(std::system(line.c_str()), 0) << read_text(path("log"));
  }
};

TEST_F(Examples, ReadingARunInPython) {
  write_small_case("gel.toml");
  ASSERT_EQ(supple("run gel.toml").code, 0);
  run_script("/usr/bin/python3", code_block(document("docs/guide.md"), "Reading a run in Python", "python"));
  EXPECT_THAT(read_text(path("log")), testing::HasSubstr("G' = "));
}

TEST_F(Examples, PackingOfTwoEllipsesInARectangularCell) {
  write("cell.json",
        code_block(document("docs/packing_json.md"), "Two ellipses in a rectangular cell", "json"));
  write("move.toml",
        "experiment = \"dynamics\"\n[initial]\npacking = \"cell.json\"\n[time]\nsteps = 100\n"
        "[motion]\nkinetic_energy = 1e-3\n[output]\nplot = false\n");
  const Outcome run = supple("run move.toml");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, testing::HasSubstr("3 particles, 2 of them polygons, with 16 vertices, cell 6 x 4"));
}

TEST_F(Examples, PackingOfADistributionOfSizes) {
  run_script("python3", code_block(document("docs/packing_json.md"), "A distribution of sizes", "python"));
  write("jam.toml",
        "experiment = \"jamming\"\n[initial]\npacking = \"ellipses.json\"\n[jamming]\nstep = 0.02\n"
        "pressure = 1e-3\n[output]\nplot = false\nsnapshot = false\n");
  const Outcome run = supple("run jam.toml");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, testing::HasSubstr("18 particles"));
}

}  // namespace
}  // namespace supple
