#include "supple/core/expression.hpp"

#include <fmt/format.h>
#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "supple/core/error.hpp"
#include "supple/core/expression_mistake.hpp"

namespace supple {

struct Expression::Parser {
  mutable mu::Parser parser;
  mutable std::vector<double> values;
};

namespace {

/// Whether a single "=" stands in the text: it would set a variable. "==", "<=", ">=" and "!=" compare.
bool assigns(const std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '=') continue;
    if (i + 1 < text.size() && text[i + 1] == '=') ++i;
    else if (i == 0 || std::string_view("<>!").find(text[i - 1]) == std::string_view::npos) return true;
  }
  return false;
}

std::string named_value(double value) {
  return std::isnan(value) ? "not a number" : value > 0 ? "infinite" : "minus infinite";
}

}  // namespace

Expression::Expression(const std::string& text, const std::vector<std::string>& variables,
                       const std::string& what)
    : parser_(std::make_unique<Parser>()), name_(what + " \"" + text + "\""), variables_(variables) {
  const auto refuse = [&](const std::string& why, const std::string& to_do = {}) {
    const std::string grammar = fmt::format(
        "it may use {}, pi, numbers such as 0.5, + - * / ^, comparisons, c ? a : b, and functions such as "
        "sin, exp, sqrt",
        fmt::join(variables, ", "));
    throw input_error(name_ + " cannot be read", why, to_do.empty() ? grammar : to_do);
  };
  if (assigns(text)) refuse("a single = sets a variable; == compares");
  parser_->values.assign(variables.size(), 0.5);
  mu::Parser& parser = parser_->parser;
  int results = 0;
  try {
    for (std::size_t i = 0; i < variables.size(); ++i) parser.DefineVar(variables[i], &parser_->values[i]);
    for (const char* name : {"pi", "_pi"})
      parser.DefineConst(name, std::numbers::pi);  // the library's has 12 decimals
    parser.SetExpr(text);
    parser.Eval(results);
  } catch (const mu::Parser::exception_type& e) {
    std::vector<std::string> names = variables;
    names.emplace_back("pi");
    for (const auto& [name, function] : parser.GetFunDef()) names.push_back(name);
    const ExpressionMistake mistake = find_mistake(text, e, names);
    refuse(mistake.why, mistake.to_do);
  }
  if (results != 1)
    refuse(fmt::format("it is {} formulas with commas between them; decimals have a point: 0.5", results));
}

Expression::~Expression() = default;
Expression::Expression(Expression&&) noexcept = default;
Expression& Expression::operator=(Expression&&) noexcept = default;

double Expression::operator()(std::span<const double> values) const {
  std::copy(values.begin(), values.end(), parser_->values.begin());
  const double value = parser_->parser.Eval();
  if (std::isfinite(value)) return value;
  std::string place;
  for (std::size_t i = 0; i < values.size(); ++i)
    place += fmt::format("{}{} = {:.6g}", i ? ", " : "", variables_[i], values[i]);
  throw input_error(fmt::format("{} is {} at {}", name_, named_value(value), place), "",
                    "look for a division by zero, or a root or logarithm of what is negative there");
}

}  // namespace supple
