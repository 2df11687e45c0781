#include "supple/experiment/held_keys.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "supple/core/error.hpp"
#include "supple/experiment/used_keys.hpp"

namespace supple {

namespace {

template <class Field, class Section>
KeyValue value_of(const Field& field, const Section& section) {
  return std::visit(
      [&](auto member) -> KeyValue {
        using Value = std::decay_t<decltype(section.*member)>;
        if constexpr (std::is_same_v<Value, int>) return static_cast<std::int64_t>(section.*member);
        else return section.*member;
      },
      field.member);
}

template <class Field, class Section>
void assign(const Field& field, Section& section, const KeyValue& value) {
  std::visit(
      [&](auto member) {
        using Value = std::decay_t<decltype(section.*member)>;
        std::visit(
            [&](const auto& v) {
              if constexpr (std::is_convertible_v<decltype(v), Value>)
                section.*member = static_cast<Value>(v);
            },
            value);
      },
      field.member);
}

bool is_held(Role role) { return role == Role::law || role == Role::exception || role == Role::sample; }

/// Gives the case those sections of these keys of which a case may have several: all species, if it has none
/// itself, and pairs of them.
void make_sections(Case& c, const HeldKeys& keys) {
  const auto has = [&](const std::string& section) {
    const auto at = keys.lower_bound(section + ".");
    return at != keys.end() && at->first.starts_with(section + ".");
  };
  if (c.species.empty())
    while (has(species_section(c.species.size()))) c.species.emplace_back();
  for (const auto& [key, value] : keys) {
    const std::string section(section_of(key));
    if (kind_of_section(section) != "contact.A.B") continue;
    const std::string names = section.substr(section.find('.') + 1);
    contact_between(c, names.substr(0, names.find('.')), names.substr(names.find('.') + 1));
  }
}

/// Whether two values are the same; numbers to 1e-9, as units round them.
bool same(const KeyValue& a, const KeyValue& b) {
  const auto number = [](const KeyValue& v) -> std::optional<double> {
    if (const auto* x = std::get_if<double>(&v)) return *x;
    if (const auto* n = std::get_if<std::int64_t>(&v)) return static_cast<double>(*n);
    return std::nullopt;
  };
  const auto x = number(a), y = number(b);
  if (x && y) return std::abs(*x - *y) <= 1e-9 * std::abs(*y);
  return a == b;
}

}  // namespace

std::string shown(const KeyValue& value) {
  return std::visit(
      [](const auto& v) {
        if constexpr (std::is_same_v<std::decay_t<decltype(v)>, std::string>) return fmt::format("\"{}\"", v);
        else if constexpr (std::is_same_v<std::decay_t<decltype(v)>, double>)
          return fmt::format("{:.10g}", v);
        else return fmt::format("{}", v);
      },
      value);
}

HeldKeys held_keys(const Case& c) {
  const std::vector<std::string> read = sections_of(c);
  HeldKeys keys;
  for_each_key(c, [&](const std::string& key, const auto& field, const auto& section) {
    if (field.role == Role::exception && !c.is_given(key)) return;
    if (is_held(field.role) && std::find(read.begin(), read.end(), section_of(key)) != read.end())
      keys[key] = value_of(field, section);
  });
  return keys;
}

HeldKeys laws_of(const HeldKeys& keys) {
  HeldKeys laws;
  Case c;
  make_sections(c, keys);
  for_each_key(c, [&](const std::string& key, const auto& field, const auto&) {
    const auto at = keys.find(key);
    if ((field.role == Role::law || field.role == Role::exception) && at != keys.end()) laws.insert(*at);
  });
  return laws;
}

HeldKeys given_as_held(const Case& c) {
  HeldKeys keys;
  for_each_key(c, [&](const std::string& key, const auto& field, const auto& section) {
    if (!c.is_given(key)) return;
    if (!is_held(field.role))
      throw input_error(
          fmt::format("{} is no key that a state holds", key),
          field.role == Role::number ? "the state has it as numbers of its own" : "it says how a run goes",
          "give it in the case");
    keys[key] = value_of(field, section);
  });
  return keys;
}

void adopt_keys(Case& c, const HeldKeys& held, const HeldKeys& known, const std::string& file) {
  std::vector<std::string> problems;
  HeldKeys all = held;
  all.insert(known.begin(), known.end());
  make_sections(c, all);
  const auto find = [](const HeldKeys& keys, const std::string& key) -> std::optional<KeyValue> {
    const auto at = keys.find(key);
    return at == keys.end() ? std::nullopt : std::optional(at->second);
  };
  for_each_key(c, [&](const std::string& key, const auto& field, auto& section) {
    if (!is_held(field.role)) return;
    const std::optional<KeyValue> by_name = find(held, key), of_system = find(known, key);
    if (!c.is_given(key)) {
      if (by_name || of_system) assign(field, section, by_name ? *by_name : *of_system);
      if (by_name && field.role == Role::exception && uses(c, key)) c.given.insert(key);
      return;
    }
    const KeyValue given = value_of(field, section);
    const auto confirms = [&](const std::optional<KeyValue>& value) { return value && same(given, *value); };
    if (field.role == Role::law || field.role == Role::exception || confirms(by_name) || confirms(of_system))
      return;
    const std::string why = by_name || of_system
                                ? fmt::format("it is {} in {}, whose particles are taken as they are",
                                              shown(by_name ? *by_name : *of_system), file)
                                : fmt::format("the particles are taken from {} as they are", file);
    problems.push_back(
        input_error(fmt::format("{} = {}", key, shown(given)), why, "leave the key away").what());
  });
  if (!problems.empty()) throw input_error(fmt::format("{}", fmt::join(problems, "\n")));
}

}  // namespace supple
