/// A formula given as text, such as "0.2*cos(2*pi*t)".
#pragma once
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace supple {

/// Arithmetic, powers (^), the usual functions (sin, cos, exp, ln, sqrt, abs, min, max, ...), comparisons, c
/// ? a : b, and pi; one result, and nothing is assigned. Off the hot path: about 10-30 ns a call. Not safe to
/// call from two threads at once.
class Expression {
 public:
  /// Throws an input error that names the formula, the position and what was expected there; `what` says what
  /// the formula is for.
  Expression(const std::string& text, const std::vector<std::string>& variables, const std::string& what);
  ~Expression();
  Expression(Expression&&) noexcept;
  Expression& operator=(Expression&&) noexcept;

  /// Value at these variables, in the order of the constructor. Throws an input error that names the formula
  /// and the variables where it is not finite.
  double operator()(std::span<const double> values) const;
  double operator()(double value) const { return (*this)(std::span<const double>(&value, 1)); }

 private:
  struct Parser;
  std::unique_ptr<Parser> parser_;
  std::string name_;  ///< what it is for, and its text
  std::vector<std::string> variables_;
};

}  // namespace supple
