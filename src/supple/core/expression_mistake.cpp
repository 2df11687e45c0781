#include "supple/core/expression_mistake.hpp"

#include <fmt/format.h>
#include <muParser.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <string_view>

#include "supple/core/nearest_name.hpp"

namespace supple {

namespace {

/// Words and signs of other languages, and how they are written here.
struct Foreign {
  std::string_view text, to_do;
};
constexpr Foreign signs[] = {
    {"**", "a power is written x^y"},
    {"\u2212", "write a plain minus: -"},
    {"\u00d7", "write * for times"},
    {"\u00b7", "write * for times"},
    {"[", "write ( ) around what belongs together"},
    {"{", "write ( ) around what belongs together"},
};
constexpr Foreign words[] = {
    {"and", "write a && b"},
    {"or", "write a || b"},
    {"not", "write a == 0"},
    {"true", "write 1"},
    {"false", "write 0"},
    {"if", "write condition ? a : b"},
    {"else", "write condition ? a : b"},
    {"pow", "a power is written x^y"},
    {"fabs", "did you mean 'abs'?"},
    {"math", "functions have no module: sin(x)"},
    {"np", "functions have no module: sin(x)"},
};

bool is_name_part(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

/// The name that begins at `at` or, where none does, the one that ends there.
std::string name_at(const std::string& text, std::size_t at) {
  at = std::min(at, text.size());
  while (at > 0 && is_name_part(text[at - 1])) --at;
  std::size_t end = at;
  while (end < text.size() && is_name_part(text[end])) ++end;
  return text.substr(at, end - at);
}

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

std::optional<ExpressionMistake> foreign_sign(const std::string& text) {
  for (const Foreign& f : signs)
    if (text.find(f.text) != text.npos)
      return ExpressionMistake{fmt::format("there is no '{}'", f.text), std::string(f.to_do)};
  return std::nullopt;
}

ExpressionMistake unknown_name(const std::string& name, const std::vector<std::string>& names) {
  const std::string why = fmt::format("there is no '{}'", name);
  for (const Foreign& f : words)
    if (lower(name) == f.text) return {why, std::string(f.to_do)};
  if (std::find(names.begin(), names.end(), name) != names.end())  // a function without its bracket
    return {fmt::format("'{}' is a function", name), fmt::format("write {}(x)", name)};
  const auto near = nearest_name(name, names);
  return {why, near ? fmt::format("did you mean '{}'?", *near) : ""};
}

}  // namespace

ExpressionMistake find_mistake(const std::string& text, const mu::ParserError& error,
                               const std::vector<std::string>& names) {
  if (const auto mistake = foreign_sign(text)) return *mistake;
  if (text.find_first_not_of(" \t\n") == text.npos) return {"it is empty", ""};
  const auto at = static_cast<std::size_t>(std::max(0, static_cast<int>(error.GetPos())));
  switch (error.GetCode()) {
    case mu::ecMISSING_PARENS: return {"a bracket is opened and not closed", "write ) where it ends"};
    case mu::ecUNEXPECTED_EOF: return {"it ends too early", "something must follow the last sign"};
    case mu::ecMISSING_ELSE_CLAUSE:
    case mu::ecMISPLACED_COLON: return {"a choice has two results", "write condition ? a : b"};
    case mu::ecUNEXPECTED_PARENS:
      if (at < text.size() && text[at] == '(')
        return {fmt::format("nothing stands between '{}' and its bracket", name_at(text, at)),
                "write * for times"};
      return {"a bracket is closed that was not opened, or is empty", ""};
    case mu::ecUNEXPECTED_VAR:
    case mu::ecUNEXPECTED_VAL:
    case mu::ecUNEXPECTED_FUN:
      return {fmt::format("nothing stands before '{}'", error.GetToken()), "write * for times"};
    case mu::ecTOO_FEW_PARAMS:
    case mu::ecTOO_MANY_PARAMS:
    case mu::ecUNEXPECTED_ARG_SEP:
    case mu::ecUNEXPECTED_ARG:
      return {"a function has too few or too many values, or a comma stands outside of one",
              "write sin(x), min(x, y); decimals have a point: 0.5"};
    default: break;
  }
  if (const std::string name = name_at(text, at);
      !name.empty() && !std::isdigit(static_cast<unsigned char>(name[0])))
    return unknown_name(name, names);
  const auto end = std::min(text.find(' ', at), at + 10);
  return {at < text.size() ? fmt::format("'{}' cannot stand there", text.substr(at, end - at))
                           : "it cannot be understood",
          ""};
}

}  // namespace supple
