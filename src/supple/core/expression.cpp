#include "supple/core/expression.hpp"

#include <muParser.h>

#include <algorithm>

#include "supple/core/error.hpp"

namespace supple {

struct Expression::Parser {
  mutable mu::Parser parser;
  mutable std::vector<double> values;
};

Expression::Expression(const std::string& text, const std::vector<std::string>& variables, const std::string& what)
    : parser_(std::make_unique<Parser>()) {
  parser_->values.assign(variables.size(), 0.5);
  std::string names;
  for (const std::string& v : variables) names += (names.empty() ? "" : ", ") + v;
  try {
    for (std::size_t i = 0; i < variables.size(); ++i) parser_->parser.DefineVar(variables[i], &parser_->values[i]);
    parser_->parser.DefineConst("pi", 3.14159265358979323846);
    parser_->parser.SetExpr(text);
    parser_->parser.Eval();
  } catch (const mu::Parser::exception_type& e) {
    throw input_error(what + " \"" + text + "\" cannot be read", e.GetMsg(),
                      "it may use " + names + ", pi, numbers, + - * / ^ and functions such as sin, exp, sqrt");
  }
}

Expression::~Expression() = default;
Expression::Expression(Expression&&) noexcept = default;
Expression& Expression::operator=(Expression&&) noexcept = default;

double Expression::operator()(std::span<const double> values) const {
  std::copy(values.begin(), values.end(), parser_->values.begin());
  return parser_->parser.Eval();
}

}  // namespace supple
