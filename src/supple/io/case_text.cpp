#include <fmt/format.h>

#include <type_traits>

#include "supple/core/nearest_name.hpp"
#include "supple/io/case_file.hpp"

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
std::string toml_value(Number value) { return fmt::format("{}", value); }

/// "[Pa] Young modulus of the discs; above 0".
template <class P>
std::string explanation(const Field<P>& field) {
  std::string text = field.unit.empty() ? "" : fmt::format("[{}] ", field.unit);
  text += field.meaning;
  if (const std::string range = describe(field.range); !range.empty()) text += "; " + range;
  if (!field.choices.empty()) text += ": " + join_names({field.choices.begin(), field.choices.end()}, "\"");
  return text;
}

/// Words of `text` in lines of at most `width` characters.
std::vector<std::string> wrapped(const std::string& text, std::size_t width) {
  std::vector<std::string> lines{""};
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    if (!lines.back().empty() && lines.back().size() + 1 + word.size() > width) lines.emplace_back();
    lines.back() += (lines.back().empty() ? "" : " ") + word;
    begin = end + 1;
  }
  return lines;
}

constexpr std::size_t comment_column = 46, comment_width = 60;

}  // namespace

std::string write_case(const Case& c, CaseStyle style) {
  std::string out;
  if (style == CaseStyle::commented)
    out = "# A case of Supple. Keys that begin with # hold their default: take the # away to change one.\n"
          "# Numbers are in the unit in brackets, or carry their own: width = \"500 um\".\n\n";
  for_each_section(c, [&](std::string_view section, const auto& parameters) {
    if (!section.empty()) out += fmt::format("\n[{}]\n", section);
    for (const auto& field : fields<std::decay_t<decltype(parameters)>>()) {
      const std::string value = std::visit([&](auto member) { return toml_value(parameters.*member); }, field.member);
      const std::string key = section.empty() ? std::string(field.name) : fmt::format("{}.{}", section, field.name);
      std::string line = fmt::format("{} = {}", field.name, value);
      if (style == CaseStyle::commented) {
        if (!c.is_given(key)) line = "# " + line;
        std::string margin = fmt::format("{:<{}}", line, comment_column);
        for (const std::string& part : wrapped(explanation(field), comment_width)) {
          out += fmt::format("{} # {}\n", margin, part);
          margin.assign(comment_column, ' ');
        }
      } else {
        out += line + "\n";
      }
    }
  });
  return out;
}

}  // namespace supple
