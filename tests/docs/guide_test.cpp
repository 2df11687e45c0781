/// The documents say what the code does.
#include <gmock/gmock.h>

#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "supple/io/case_file.hpp"

namespace supple {
namespace {

std::string document(const std::string& name) {
  std::ifstream in(std::string(SUPPLE_SOURCE_DIR) + "/docs/" + name);
  EXPECT_TRUE(in) << name;
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
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
  const std::string text = document("parameters.md"), tables = describe_parameters();
  EXPECT_NE(text.find(tables), std::string::npos) << "docs/parameters.md should end with\n" << tables;
}

TEST(Guide, NamesOnlyKeysThatExist) {
  const std::set<std::string> keys = all_keys();
  const std::regex mention("`((material|particles|box|shear|time|preparation|initial|output)\\.\\w+)( = [^`]*)?`");
  int mentions = 0;
  for (const char* name : {"guide.md", "theory/microgel.md"}) {
    const std::string text = document(name);
    for (std::sregex_iterator m(text.begin(), text.end(), mention), end; m != end; ++m, ++mentions)
      EXPECT_TRUE(keys.count((*m)[1])) << name << " mentions " << (*m)[1];
  }
  EXPECT_GT(mentions, 20);
}

}  // namespace
}  // namespace supple
