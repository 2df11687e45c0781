#include "supple/io/state/held_keys_json.hpp"

#include <map>

#include "supple/io/text/case_file.hpp"

namespace supple {

namespace {

/// The object as a case would have it: JSON values of these kinds are TOML as they are.
std::string as_case(const JsonNode& keys) {
  std::map<std::string, std::string> sections;
  for (const std::string& key : keys.keys()) {
    const JsonNode value = keys.at(key);
    if (!value.json().is_primitive() || value.json().is_null()) throw value.fault("is no value of a key");
    const std::string section(section_of(key));
    sections[section] += Json(section.empty() ? key : key.substr(section.size() + 1)).dump() + " = " +
                         value.json().dump() + "\n";
  }
  std::string text;
  for (const auto& [section, lines] : sections)
    text += (section.empty() ? "" : "[" + Json(section).dump() + "]\n") + lines;
  return text;
}

}  // namespace

HeldKeys read_held_keys(const JsonNode& root) {
  if (!root.has(held_keys_name)) return {};
  const JsonNode keys = root.at(held_keys_name);
  const std::string text = as_case(keys);
  try {
    return given_as_held(read_case_text(text, held_keys_name));
  } catch (const Error& e) {
    throw keys.fault(std::string("does not hold: ") + e.what());
  }
}

Json held_keys_json(const HeldKeys& keys) {
  Json json = Json::object();
  for (const auto& [key, value] : keys)
    std::visit([&json, name = key](const auto& v) { json[name] = v; }, value);
  return json;
}

}  // namespace supple
