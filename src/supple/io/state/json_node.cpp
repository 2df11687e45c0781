#include "supple/io/state/json_node.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "supple/core/path_kind.hpp"

namespace supple {

namespace {

struct JsonMistake {
  std::string why, to_do;
};

/// The letters about this place, in lower case.
std::string word_at(const std::string& text, std::size_t at) {
  const auto is_letter = [&](std::size_t i) {
    return std::isalpha(static_cast<unsigned char>(text[i])) != 0;
  };
  std::size_t end = at;
  while (at > 0 && is_letter(at - 1)) --at;
  while (end < text.size() && is_letter(end)) ++end;
  std::string word = text.substr(at, end - at);
  for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return word;
}

/// What is wrong at this byte, counted from 1; behind the end where something is missing there.
JsonMistake find_json_mistake(const std::string& text, std::size_t byte) {
  const auto first = text.find_first_not_of(" \t\r\n");
  if (first == text.npos) return {"it is empty", ""};
  if (text.starts_with("\x89HDF")) return {"it is a run, not JSON", "a run is named by initial.state"};
  if (text[first] != '{' && text[first] != '[') return {"it is not JSON, which begins with {", ""};
  const std::size_t at = std::min(byte > 0 ? byte - 1 : 0, text.size());
  const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
  if (text.find_first_not_of(" \t\r\n", at) == text.npos)
    return {fmt::format("it ends too early, in line {}", line), ""};
  const auto start = at == 0 ? text.npos : text.rfind('\n', at - 1);
  const std::size_t column = start == text.npos ? at + 1 : at - start;
  const auto c = static_cast<unsigned char>(text[at]);
  const std::string place = fmt::format("line {}, column {}: ", line, column);
  const std::string word = word_at(text, at);
  if (word == "nan" || word == "inf" || word == "infinity")
    return {place + "JSON has no nan and no infinity", ""};
  if (c == '}' || c == ']')
    return {place + "something is missing before the bracket, or a comma is one too many", ""};
  if (c == '\'') return {place + "text stands between \" \"", ""};
  return {place + (std::isprint(c) ? fmt::format("'{}' cannot stand there", text[at]) : "this is no text"),
          ""};
}

}  // namespace

Json parse_json(const std::string& path, const std::string& kind) {
  constexpr std::size_t longest = std::size_t{4} << 30;
  const std::string text = read_whole_file(path, kind, longest);
  const auto cannot = [&](const JsonMistake& m) {
    return file_error("cannot use " + path + " as " + kind, m.why, m.to_do);
  };
  try {
    return Json::parse(text);
  } catch (const Json::parse_error& e) {
    throw cannot(find_json_mistake(text, e.byte));
  } catch (const Json::exception&) {
    throw cannot({"a number in it is too large", ""});
  }
}

}  // namespace supple
