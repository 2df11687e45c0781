#include "supple/io/text/case_file.hpp"

#include <fmt/format.h>

#include <toml++/toml.h>
#include <algorithm>
#include <filesystem>
#include <limits>

#include "supple/core/error.hpp"
#include "supple/core/nearest_name.hpp"
#include "supple/core/path_kind.hpp"
#include "supple/io/text/case_names.hpp"
#include "supple/io/text/quantity.hpp"
#include "supple/io/text/toml_mistake.hpp"

namespace supple {

namespace {

std::string_view type_name(const toml::node& node) {
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
std::string shown(const toml::node& node) {
  if (const auto* s = node.as_string()) return fmt::format("\"{}\"", s->get());
  if (const auto* i = node.as_integer()) return fmt::format("{}", i->get());
  if (const auto* f = node.as_floating_point()) return fmt::format("{}", f->get());
  if (const auto* b = node.as_boolean()) return b->get() ? "true" : "false";
  return std::string(type_name(node));
}

/// Reads one table of TOML into a case and collects what is wrong with it.
class Reader {
 public:
  /// `origin`: the file, or the whole "--set ..." where positions mean nothing.
  enum class Kind { file, override_ };
  Reader(Case& c, std::string origin, Kind kind) : case_(c), origin_(std::move(origin)), kind_(kind) {}

  void read(const toml::table& root) {
    const std::vector<std::string> sections = section_names(case_);
    for (auto&& [key, node] : root) {
      if (key.str() == species) read_species(node);
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
           fmt::format("{} must be {}, not {} ({})", name, expected, type_name(node), shown(node)),
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
    report(node.source(), fmt::format("{} = {} is out of range", name, shown(node)),
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
                        how_to_write_integer(text ? text->get() : shown(node)));
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
};

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
  Reader reader(c, "--set " + text, Reader::Kind::override_);
  reader.read(override_value(c, section, key, std::string_view(text).substr(equals + 1)));
  reader.finish();
}

}  // namespace

Case read_case_text(const std::string& text, const std::string& name,
                    const std::vector<std::string>& overrides) {
  Case c;
  c.origin = name;
  Reader reader(c, name, Reader::Kind::file);
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
