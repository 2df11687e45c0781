#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>
#include <type_traits>

#include "supple/core/text_columns.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/experiment/used_keys.hpp"
#include "supple/io/text/case_file.hpp"

namespace supple {

namespace {

std::string toml_value(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') (out += '\\') += c;
    else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) out += fmt::format("\\u{:04X}", c);
    else out += c;
  }
  return out + '"';
}
std::string toml_value(bool value) { return value ? "true" : "false"; }
template <class Number>
std::string toml_value(Number value) {
  return fmt::format("{}", value);
}

/// What explains a key, in pieces between which a line may end: the words of the meaning, the range, each
/// choice.
template <class P>
std::vector<std::string> explanation(const Field<P>& field) {
  std::vector<std::string> pieces;
  if (!field.unit.empty()) pieces.push_back(fmt::format("[{}]", field.unit));
  std::istringstream words{std::string(field.meaning)};
  for (std::string word; words >> word;) pieces.push_back(word);
  if (const std::string range = describe(field.range); !range.empty()) {
    pieces.back() += ";";
    pieces.push_back(range);
  }
  if (!field.choices.empty()) pieces.back() += ":";
  for (const std::string_view choice : field.choices)
    pieces.push_back(fmt::format("\"{}\"{}", choice, choice == field.choices.back() ? "" : ","));
  return pieces;
}

/// The range, or the choices, of a key.
template <class P>
std::string valid_values(const Field<P>& field) {
  if (field.choices.empty()) return describe(field.range);
  std::string out;
  for (const std::string_view choice : field.choices)
    out += fmt::format("{}`{}`", out.empty() ? "" : ", ", choice);
  return out;
}

/// The experiments that use a key.
std::string users(std::string_view section, std::string_view name) {
  const std::vector<std::string> all =
      users_of(section.empty() ? std::string(name) : fmt::format("{}.{}", section, name));
  return all.size() == experiment_names().size() ? "all" : fmt::format("{}", fmt::join(all, ", "));
}

/// Text for a cell of a Markdown table.
std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) (c == '|' ? out += '\\' : out) += c;
  return out;
}

/// "[bodies]", "[[species]]"; empty above any section.
std::string title_of(std::string_view section) {
  if (section.empty()) return "";
  return section.starts_with("species") ? "[[species]]" : fmt::format("[{}]", section);
}
std::string heading(std::string_view section) {
  return section.empty() ? "" : fmt::format("\n{}\n", title_of(section));
}

/// Where comments begin, behind nearly every key and its value.
constexpr std::size_t comment_column = 31, comment_width = page_width - comment_column - 2;

}  // namespace

std::string write_case(const Case& c, CaseStyle style) {
  std::string out;
  if (style != CaseStyle::resolved)
    out =
        "# A case of Supple. Keys that begin with # hold their default: take the # away\n"
        "# to change one. Numbers are in the unit in brackets, or carry their own:\n"
        "# width = \"500 um\".\n\n";
  const std::vector<std::string> read = sections_of(c);
  for_each_section(c, [&](std::string_view section, const auto& parameters) {
    if (style != CaseStyle::all && std::find(read.begin(), read.end(), section) == read.end()) return;
    out += heading(section);
    for (const auto& field : fields<std::decay_t<decltype(parameters)>>()) {
      const std::string value =
          std::visit([&](auto member) { return toml_value(parameters.*member); }, field.member);
      const std::string key =
          section.empty() ? std::string(field.name) : fmt::format("{}.{}", section, field.name);
      std::string line = fmt::format("{} = {}", field.name, value);
      if (style == CaseStyle::commented && !uses(c, key) && !c.is_given(key)) continue;
      if (style != CaseStyle::all && field.role == Role::exception && !c.is_given(key)) continue;
      if (style != CaseStyle::resolved) {
        if (!c.is_given(key)) line = "# " + line;
        std::string margin = fmt::format("{:<{}}", line, comment_column);
        if (text_width(line) >= comment_column) {
          out += margin + "\n";
          margin.assign(comment_column, ' ');
        }
        for (const std::string& part : wrap_pieces(explanation(field), comment_width)) {
          out += fmt::format("{}# {}\n", margin, part);
          margin.assign(comment_column, ' ');
        }
      } else {
        out += line + "\n";
      }
    }
  });
  return out;
}

std::string describe_parameters() {
  const Case defaults = every_section();
  std::string out;
  for_each_section(defaults, [&](std::string_view section, const auto& parameters) {
    out += section.empty() ? "### Above any section\n" : fmt::format("\n### {}\n", title_of(section));
    out += "\n| key | default | unit | valid | meaning | used by |\n|---|---|---|---|---|---|\n";
    for (const auto& field : fields<std::decay_t<decltype(parameters)>>())
      out +=
          fmt::format("| `{}` | `{}` | {} | {} | {} | {} |\n", field.name,
                      std::visit([&](auto member) { return toml_value(parameters.*member); }, field.member),
                      field.unit, valid_values(field), escaped(field.meaning), users(section, field.name));
  });
  return out;
}

}  // namespace supple
