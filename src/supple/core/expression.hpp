/// A formula given as text, such as "0.2*cos(2*pi*t)".
#pragma once
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace supple {

/// A formula may hold arithmetic, powers (^), the usual functions (sin, cos, exp, ln, sqrt, abs, min, max,
/// ...), comparisons, choices (condition ? a : b) and pi. It has one result and assigns nothing. A call takes
/// about 10-30 ns, too long for inner loops. Not safe to call from two threads at once.
class Expression {
 public:
  /// `what` says what the formula is for, in errors. Throws an input error that names the formula, the
  /// position of the mistake and what was expected there.
  Expression(const std::string& text, const std::vector<std::string>& variables, const std::string& what);
  ~Expression();
  Expression(Expression&&) noexcept;
  Expression& operator=(Expression&&) noexcept;

  /// The value of the formula, given the variables in the order of the constructor. Throws an input error
  /// with the formula and the variables where the value is not finite.
  double operator()(std::span<const double> values) const;
  double operator()(double value) const { return (*this)(std::span<const double>(&value, 1)); }

 private:
  struct Parser;
  std::unique_ptr<Parser> parser_;
  std::string name_;  ///< what the formula is for, and its text
  std::vector<std::string> variables_;
};

}  // namespace supple
