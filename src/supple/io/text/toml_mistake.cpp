#include "supple/io/text/toml_mistake.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "supple/core/meant_number.hpp"

namespace supple {

namespace {

std::string_view trim(std::string_view text) {
  const auto is_space = [](char c) { return std::isspace(static_cast<unsigned char>(c)); };
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

std::vector<std::string_view> split_lines(std::string_view text) {
  std::vector<std::string_view> lines;
  while (true) {
    const auto end = text.find('\n');
    lines.push_back(text.substr(0, end));
    if (end == text.npos) return lines;
    text.remove_prefix(end + 1);
  }
}

/// Up to the first "#" that no quotes enclose.
std::string_view without_comment(std::string_view line) {
  char quote = '\0';
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (quote == '\0' && line[i] == '#') return line.substr(0, i);
    if (quote == '\0' && (line[i] == '"' || line[i] == '\'')) quote = line[i];
    else if (line[i] == quote) quote = '\0';
  }
  return line;
}

/// Where the first number of `value` ends; 0 where it begins with none.
std::size_t end_of_number(std::string_view value) {
  std::size_t end = 0;
  for (std::size_t n = 1; n <= value.size(); ++n)
    if (meant_number(value.substr(0, n)) && value[n - 1] != ' ') end = n;
  return end;
}

std::string_view key_of(std::string_view line) { return trim(line.substr(0, line.find('='))); }

bool is_header(std::string_view line) { return trim(line).starts_with('['); }

/// A section or key that the file already has, above this line.
TomlMistake find_repetition(const std::vector<std::string_view>& lines, std::size_t at) {
  std::string section;
  std::map<std::pair<std::string, std::string>, std::size_t> first;
  for (std::size_t i = 0; i <= at; ++i) {
    const std::string_view line = trim(without_comment(lines[i]));
    const bool header = is_header(line);
    if (line.empty() || (!header && line.find('=') == line.npos)) continue;
    if (header) section = line;
    const std::string key(header ? "" : key_of(line));
    const auto [before, is_new] = first.try_emplace({section, key}, i + 1);
    if (i < at || is_new) continue;
    return {fmt::format("{} stands already in line {}", header ? section : "'" + key + "'", before->second),
            header ? "put its keys there" : "keep one of the two"};
  }
  return {};
}

const TomlMistake no_list{"no key of a case takes a list or a table", "give it one value"};

/// A list or table that goes on over several lines, down to this one.
bool is_in_list(const std::vector<std::string_view>& lines, std::size_t at) {
  std::ptrdiff_t open = 0;
  for (std::size_t i = 0; i < at; ++i) {
    std::string_view line = without_comment(lines[i]);
    if (open == 0) {
      if (is_header(line) || line.find('=') == line.npos) continue;
      line = trim(line.substr(line.find('=') + 1));
      if (line.empty() || (line.front() != '[' && line.front() != '{')) continue;
    }
    for (const char c : line) open += (c == '[' || c == '{') - (c == ']' || c == '}');
  }
  return open > 0;
}

}  // namespace

std::optional<std::string_view> meant_truth(std::string_view text) {
  std::string word(text);
  for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (word == "true" || word == "yes" || word == "on") return "true";
  if (word == "false" || word == "no" || word == "off") return "false";
  return std::nullopt;
}

std::string how_to_write_integer(std::string_view text) {
  const auto number = meant_number(text);
  if (!number || number->find(' ') != number->npos) return "";
  const double value = std::strtod(number->c_str(), nullptr);
  if (value != std::floor(value)) return "";
  return std::abs(value) < 1e15 ? fmt::format("write {:.0f}", value)
                                : "integers go up to 9223372036854775807";
}

TomlMistake find_value_mistake(std::string_view key, std::string_view value) {
  value = trim(value);
  const auto write = [&](std::string_view meant) { return fmt::format("write {} = {}", key, meant); };
  if (value.empty()) return {fmt::format("'{}' has no value", key), ""};
  for (const std::string_view quote : {"\u201c", "\u201d", "\u201e", "\u2018", "\u2019", "\u00ab", "\u00bb"})
    if (value.find(quote) != value.npos) return {"these are typographic quotes", "write plain ones: \"...\""};
  if (value.front() == '"' || value.front() == '\'') {
    if (value.size() == 1 || value.find(value.front(), 1) == value.npos)
      return {"a quote is opened and not closed",
              "write " + std::string(1, value.front()) + " where the text ends"};
    if (value.find('\\') != value.npos)
      return {"a backslash between \" \" begins an escape", "write / in paths, or put the text between ' '"};
    if (value.back() != value.front()) return {"something stands behind the text", "comments begin with #"};
    return {};
  }
  if (value.front() == '[' || value.front() == '{') return no_list;
  if (value.ends_with(';')) return {"nothing ends a line", write(value.substr(0, value.size() - 1))};
  if (const auto slashes = value.find("//"); slashes != value.npos && slashes > 0)
    return {"a comment begins with #", write(trim(value.substr(0, slashes)))};
  if (const auto truth = meant_truth(value))
    return {fmt::format("'{}' is neither true nor false", value), write(*truth)};
  if (const auto number = meant_number(value); number && *number == value)
    return {"the number is too large", "integers go up to 9223372036854775807"};
  if (const auto number = meant_number(value))
    return {value.find(',') == value.npos
                ? "numbers have digits on both sides of the point and no zeros in front"
                : "decimals have a point, not a comma",
            write(*number)};
  const std::size_t end = end_of_number(value);
  const std::string_view rest = trim(value.substr(end));
  if (end > 0 &&
      (std::isalpha(static_cast<unsigned char>(rest.front())) || rest.front() == '%' || rest.front() < 0))
    return {"a number with a unit stands between quotes",
            write(fmt::format("\"{} {}\"", *meant_number(value.substr(0, end)), rest))};
  if (end > 0)
    return {fmt::format("'{}' stands behind the number", rest), "a key has one value; comments begin with #"};
  return {"text stands between quotes", write(fmt::format("\"{}\"", value))};
}

TomlMistake find_toml_mistake(std::string_view text, std::size_t line) {
  const std::vector<std::string_view> lines = split_lines(text);
  if (line == 0 || line > lines.size()) return {};
  if (is_in_list(lines, line - 1)) return no_list;
  if (const TomlMistake repetition = find_repetition(lines, line - 1); !repetition.why.empty())
    return repetition;
  const std::string_view here = trim(without_comment(lines[line - 1]));
  if (here.starts_with('{')) return {"this looks like JSON", "a case is key = value, below [section]"};
  if (is_header(here)) {
    if (here.ends_with(']')) return {"the name of a section is letters, digits and _", ""};
    return {"the brackets of a section enclose its name and nothing follows them",
            fmt::format("write [{}] on a line of its own",
                        trim(here.substr(1, here.find_first_of("] =", 1) - 1)))};
  }
  const auto equals = here.find('=');
  if (equals == here.npos) {
    const auto end = std::min(here.find_first_of(": \t"), here.size());
    const std::string_view value = trim(here.substr(std::min(end + 1, here.size())));
    return {"a key and its value have = between them",
            value.empty() ? "" : fmt::format("write {} = {}", here.substr(0, end), trim(value))};
  }
  const std::string_view key = key_of(here);
  if (key.empty()) return {"there is no key left of =", ""};
  if (key.find_first_of(" \t") != key.npos)
    return {fmt::format("'{}' is no key: it has a space in it", key), ""};
  return find_value_mistake(key, here.substr(equals + 1));
}

}  // namespace supple
