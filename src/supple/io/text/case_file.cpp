#include "supple/io/text/case_file.hpp"

#include <fmt/format.h>

#include <toml++/toml.h>
#include <filesystem>

#include "supple/core/error.hpp"
#include "supple/core/path_kind.hpp"
#include "supple/io/text/case_reader.hpp"
#include "supple/io/text/toml_mistake.hpp"

namespace supple {

namespace {

bool is_text_key(Case c, std::string_view section, std::string_view key) {
  bool text = false;
  for_each_field(c, [&](std::string_view s, const auto& field, auto& parameters) {
    using P = std::decay_t<decltype(parameters)>;
    if (s == section && field.name == key) text = std::holds_alternative<std::string P::*>(field.member);
  });
  return text;
}

/// The text right of "=" as one key of a table: TOML, or else a bare string.
toml::table override_value(const Case& c, std::string_view section, std::string_view key,
                           std::string_view text) {
  toml::table value;
  try {
    value = toml::parse(std::string_view(fmt::format("value = {}", text)));
  } catch (const toml::parse_error&) {
    value.clear();
  }
  const bool bare = value.size() != 1 || (is_text_key(c, section, key) && !value["value"].is_string());
  if (bare) value.insert_or_assign("value", std::string(text));

  toml::table keys;
  keys.insert(key, *value.get("value"));
  if (section.empty()) return keys;
  toml::table root;
  root.insert(section, std::move(keys));
  return root;
}

void apply_override(Case& c, const std::string& text) {
  const auto equals = text.find('=');
  if (equals == text.npos || equals == 0)
    throw input_error(fmt::format("--set {}: not of the form section.key=value", text), "",
                      "write for example --set material.friction=0.3");
  std::string_view name = std::string_view(text).substr(0, equals);
  while (name.starts_with(' ')) name.remove_prefix(1);
  while (name.ends_with(' ')) name.remove_suffix(1);
  const std::string_view section = section_of(name);
  const std::string_view key = section.empty() ? name : name.substr(section.size() + 1);
  CaseReader reader(c, "--set " + text, CaseReader::Kind::override_);
  reader.read(override_value(c, section, key, std::string_view(text).substr(equals + 1)));
  reader.finish();
}

}  // namespace

Case read_case_text(const std::string& text, const std::string& name,
                    const std::vector<std::string>& overrides) {
  Case c;
  c.origin = name;
  CaseReader reader(c, name, CaseReader::Kind::file);
  try {
    reader.read(toml::parse(std::string_view(text), std::string_view(name)));
  } catch (const toml::parse_error& e) {
    TomlMistake mistake = find_toml_mistake(text, e.source().begin.line);
    if (mistake.why.empty()) mistake.why = fmt::format("the reader of TOML says: {}", e.description());
    reader.report(e.source(), "this is not valid TOML", mistake.why, mistake.to_do);
  }
  reader.finish();
  for (auto* path : {&c.initial.state, &c.initial.packing})
    if (!path->empty())
      *path = (std::filesystem::path(name).parent_path() / *path).lexically_normal().string();
  for (const std::string& text_of_override : overrides) apply_override(c, text_of_override);
  return c;
}

Case read_case(const std::string& path, const std::vector<std::string>& overrides) {
  constexpr std::size_t longest = 16 << 20;
  const std::string text = read_whole_file(path, "the case", longest);
  if (text.starts_with("\x89HDF"))
    throw input_error(fmt::format("'{}' is a run, not a case", path), "a case is a text of keys and values",
                      fmt::format("supple show {} prints what it holds", path));
  return read_case_text(text, path, overrides);
}

}  // namespace supple
