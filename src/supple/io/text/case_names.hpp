/// Names of sections and keys of a case.
#pragma once
#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

#include "supple/experiment/case.hpp"

namespace supple {

/// "material.friction", or "seed" for the keys above any section.
inline std::string full_key(std::string_view section, std::string_view key) {
  return section.empty() ? std::string(key) : fmt::format("{}.{}", section, key);
}

inline constexpr std::string_view species = "species", contact = "contact";

/// Sections of the case, and what is a list of them.
inline std::vector<std::string> section_names(const Case& c) {
  std::vector<std::string> names;
  for_each_section(c, [&](std::string_view section, const auto&) {
    if (!section.empty()) names.emplace_back(section);
    if (section == "bodies") names.emplace_back(species);
  });
  return names;
}

/// visit(section, field, struct) for every parameter of the case.
template <class Visit>
void for_each_field(Case& c, Visit&& visit) {
  for_each_section(c, [&](std::string_view section, auto& parameters) {
    for (const auto& field : fields<std::decay_t<decltype(parameters)>>()) visit(section, field, parameters);
  });
}

inline std::vector<std::string> key_names(Case c, std::string_view section) {
  std::vector<std::string> names;
  for_each_field(c, [&](std::string_view s, const auto& field, auto&) {
    if (s == section) names.emplace_back(field.name);
  });
  return names;
}

}  // namespace supple
