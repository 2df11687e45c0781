/// Reads tables of TOML into a case: the one home of what errors in keys and values say.
#pragma once
#include <fmt/format.h>

#include <toml++/toml.h>
#include <algorithm>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "supple/core/error.hpp"
#include "supple/core/nearest_name.hpp"
#include "supple/io/text/case_names.hpp"
#include "supple/io/text/quantity.hpp"
#include "supple/io/text/toml_mistake.hpp"

namespace supple {

inline std::string_view type_name(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::string: return "a string";
    case toml::node_type::integer: return "an integer";
    case toml::node_type::floating_point: return "a number with a decimal point";
    case toml::node_type::boolean: return "true or false";
    case toml::node_type::array: return "a list";
    case toml::node_type::table: return "a section";
    default: return "a date or time";
  }
}

/// The value as it stands in errors.
inline std::string shown_in_errors(const toml::node& node) {
  if (const auto* s = node.as_string()) return fmt::format("\"{}\"", s->get());
  if (const auto* i = node.as_integer()) return fmt::format("{}", i->get());
  if (const auto* f = node.as_floating_point()) return fmt::format("{}", f->get());
  if (const auto* b = node.as_boolean()) return b->get() ? "true" : "false";
  return std::string(type_name(node));
}

/// Reads one table of TOML into a case and collects what is wrong with it.
class CaseReader {
 public:
  /// `origin`: the file, or the whole "--set ..." where positions mean nothing.
  enum class Kind { file, override_ };
  CaseReader(Case& c, std::string origin, Kind kind) : case_(c), origin_(std::move(origin)), kind_(kind) {}

  void read(const toml::table& root) {
    const std::vector<std::string> sections = section_names(case_);
    for (auto&& [key, node] : root) {
      if (key.str() == species) read_species(node);
      else if (key.str() == contact && node.is_table()) read_contact(*node.as_table());
      else if (key.str().starts_with("contact.") && node.is_table())
        read_pair(key.str().substr(contact.size() + 1), *node.as_table());
      else if (std::find(sections.begin(), sections.end(), key.str()) == sections.end())
        read_key("", key, node);
      else if (const toml::table* section = node.as_table())
        for (auto&& [name, value] : *section) read_key(key.str(), name, value);
      else
        report(node.source(), fmt::format("'{}' is a section, not a key", key.str()), "",
               fmt::format("write [{}] on a line of its own and its keys below", key.str()));
    }
  }

  /// Throws one input error with every problem, in the order of the file.
  void finish() {
    if (problems_.empty()) return;
    std::stable_sort(problems_.begin(), problems_.end(), [](const Problem& a, const Problem& b) {
      return std::pair(a.line, a.column) < std::pair(b.line, b.column);
    });
    std::string all;
    for (const Problem& p : problems_) all += (all.empty() ? "" : "\n") + p.text;
    throw input_error(all);
  }

  void report(const toml::source_region& at, const std::string& what, const std::string& why = {},
              const std::string& to_do = {}) {
    const std::string place =
        kind_ == Kind::override_ ? origin_ : fmt::format("{}:{}:{}", origin_, at.begin.line, at.begin.column);
    problems_.push_back(
        {at.begin.line, at.begin.column, input_error(place + ": " + what, why, to_do).what()});
  }

 private:
  void read_species(const toml::node& node) {
    const toml::array* list = node.as_array();
    if (!list || !list->is_homogeneous(toml::node_type::table) || list->empty())
      return report(node.source(), "species is a list of sections",
                    "a sample may have several kinds of particles",
                    "write [[species]] on a line of its own and its keys below");
    case_.species.resize(list->size());
    for (std::size_t k = 0; k < list->size(); ++k)
      for (auto&& [name, value] : *list->get_as<toml::table>(k)) read_key(species_section(k), name, value);
  }

  /// Keys, and the sections [contact.A.B] below.
  void read_contact(const toml::table& section) {
    const std::vector<std::string> keys = key_names(case_, contact);
    for (auto&& [name, value] : section) {
      const toml::table* table = value.as_table();
      if (!table || std::find(keys.begin(), keys.end(), name.str()) != keys.end()) {
        read_key(contact, name, value);
        continue;
      }
      bool pairs = true;
      for (auto&& [other, keys_of_pair] : *table) {
        if (const toml::table* pair = keys_of_pair.as_table())
          read_pair(fmt::format("{}.{}", name.str(), other.str()), *pair);
        else pairs = false;
      }
      if (!pairs || table->empty())
        report(table->source(), fmt::format("[contact.{}] names one species", name.str()),
               "contacts are of two",
               fmt::format("write [contact.{0}.{0}] for those with its own kind, [contact.{0}.B] for those "
                           "with B",
                           name.str()));
    }
  }

  /// The section [contact.A.B], `names` being "A.B".
  void read_pair(std::string_view names, const toml::table& keys) {
    const auto dot = names.find('.');
    const std::string first(names.substr(0, dot)), second(dot == names.npos ? "" : names.substr(dot + 1));
    if (first.empty() || second.empty() || second.find('.') != second.npos)
      return report(keys.source(), fmt::format("[contact.{}] does not name two species", names), "",
                    "write [contact.A.B] with their names");
    const std::string section = pair_section(contact_between(case_, first, second));
    if (!pairs_read_.insert(section).second)
      return report(keys.source(), fmt::format("[contact.{}] and [{}] are the same", names, section),
                    "the order of two species does not matter", "write one of them");
    for (auto&& [name, value] : keys) read_key(section, name, value);
  }

  struct Problem {
    toml::source_index line, column;
    std::string text;
  };

  void read_key(std::string_view section, const toml::key& key, const toml::node& node) {
    bool known = false;
    for_each_field(case_, [&](std::string_view s, const auto& field, auto& parameters) {
      if (s != section || field.name != key.str()) return;
      known = true;
      const std::string name = full_key(section, field.name);
      if (std::visit([&](auto member) { return assign(parameters.*member, field, name, node); },
                     field.member))
        case_.given.insert(name);
    });
    if (known) return;
    if (section.empty() && node.is_table()) unknown_section(key, *node.as_table());
    else unknown_key(section, key);
  }

  void unknown_section(const toml::key& key, const toml::table& table) {
    const auto near = nearest_name(key.str(), section_names(case_));
    report(table.source(), fmt::format("unknown section [{}]", key.str()), "",
           near ? fmt::format("did you mean [{}]?", *near)
                : "the sections are " + join_names(section_names(case_), ""));
  }

  void unknown_key(std::string_view section, const toml::key& key) {
    const std::string what = section.empty() ? fmt::format("unknown key '{}' above any section", key.str())
                                             : fmt::format("unknown key '{}' in [{}]", key.str(), section);
    std::vector<std::string> elsewhere;
    std::string home;
    Case c;
    for_each_field(c, [&](std::string_view s, const auto& field, auto&) {
      elsewhere.emplace_back(field.name);
      if (field.name == key.str()) home = s.empty() ? "above any section" : fmt::format("in [{}]", s);
    });
    const auto near = nearest_name(key.str(), key_names(case_, section));
    const auto far = nearest_name(key.str(), elsewhere);
    std::string hint;
    if (!home.empty()) hint = fmt::format("'{}' belongs {}", key.str(), home);
    else if (near) hint = fmt::format("did you mean '{}'?", *near);
    else if (far) hint = fmt::format("did you mean '{}'?", home_of(*far));
    else hint = "the keys here are " + join_names(key_names(case_, section), "");
    report(key.source(), what, "", hint);
  }

  static std::string home_of(const std::string& key) {
    std::string name;
    Case c;
    for_each_field(c, [&](std::string_view s, const auto& field, auto&) {
      if (field.name == key) name = full_key(s, key);
    });
    return name;
  }

  template <class F>
  bool wrong_type(const F& field, const std::string& name, const toml::node& node,
                  const std::string& expected, const std::string& to_do = {}) {
    report(node.source(),
           fmt::format("{} must be {}, not {} ({})", name, expected, type_name(node), shown_in_errors(node)),
           std::string(field.meaning), to_do);
    return false;
  }

  /// The field with no more than the integers of its own type: others would wrap.
  template <class Integer, class F>
  static F within(F field) {
    using Limits = std::numeric_limits<Integer>;
    if constexpr (Limits::digits < 53) {
      field.range.low = std::max(field.range.low, static_cast<double>(Limits::lowest()));
      field.range.high = std::min(field.range.high, static_cast<double>(Limits::max()));
    }
    return field;
  }

  template <class F>
  bool in_range(double value, const F& field, const std::string& name, const toml::node& node) {
    if (field.range.contains(value)) return true;
    const std::string unit = field.unit.empty() ? "" : fmt::format(" {}", field.unit);
    const std::string range = std::isfinite(value) ? describe(field.range) : "finite";
    report(node.source(), fmt::format("{} = {} is out of range", name, shown_in_errors(node)),
           std::string(field.meaning), fmt::format("it must be {}{}", range, unit));
    return false;
  }

  template <class F>
  bool assign(double& target, const F& field, const std::string& name, const toml::node& node) {
    double value = 0;
    if (const auto* s = node.as_string()) {
      try {
        value = parse_quantity(s->get(), field.unit, std::string(field.meaning));
      } catch (const Error& e) {
        report(node.source(), fmt::format("{}: {}", name, e.what()));
        return false;
      }
    } else if (const auto number = node.value_exact<double>()) {
      value = *number;
    } else if (const auto integer = node.value_exact<std::int64_t>()) {
      value = static_cast<double>(*integer);
    } else {
      return wrong_type(field, name, node, "a number");
    }
    if (!in_range(value, field, name, node)) return false;
    target = value;
    return true;
  }

  template <class Integer, class F>
  requires std::is_integral_v<Integer>
  bool assign(Integer& target, const F& field, const std::string& name, const toml::node& node) {
    const auto value = node.value_exact<std::int64_t>();
    if (!value) {
      const auto* text = node.as_string();
      return wrong_type(field, name, node, "an integer",
                        how_to_write_integer(text ? text->get() : shown_in_errors(node)));
    }
    if (!in_range(static_cast<double>(*value), within<Integer>(field), name, node)) return false;
    target = static_cast<Integer>(*value);
    return true;
  }

  template <class F>
  bool assign(bool& target, const F& field, const std::string& name, const toml::node& node) {
    const auto value = node.value_exact<bool>();
    if (!value) {
      const auto* text = node.as_string();
      const auto meant = text ? meant_truth(text->get()) : std::nullopt;
      return wrong_type(field, name, node, "true or false", meant ? fmt::format("write {}", *meant) : "");
    }
    target = *value;
    return true;
  }

  template <class F>
  bool assign(std::string& target, const F& field, const std::string& name, const toml::node& node) {
    const auto value = node.value_exact<std::string>();
    if (!value) return wrong_type(field, name, node, "a string", "put it between quotes");
    const std::vector<std::string> choices(field.choices.begin(), field.choices.end());
    if (!choices.empty() && std::find(choices.begin(), choices.end(), *value) == choices.end()) {
      const auto near = nearest_name(*value, choices);
      report(node.source(), fmt::format("{} = \"{}\" is not a choice", name, *value),
             std::string(field.meaning),
             (near ? fmt::format("did you mean \"{}\"? It", *near) : "it") + " must be one of " +
                 join_names(choices, "\""));
      return false;
    }
    target = *value;
    return true;
  }

  Case& case_;
  std::string origin_;
  Kind kind_;
  std::vector<Problem> problems_;
  std::set<std::string> pairs_read_;
};

}  // namespace supple
