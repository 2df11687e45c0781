#include "supple/io/text/number_text.hpp"

#include <charconv>
#include <cmath>

namespace supple {

void append_shortest(std::string& text, double x) {
  char buffer[32];
  text.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, x).ptr);
}

void append_integer(std::string& text, std::int64_t x) {
  char buffer[24];
  text.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, x).ptr);
}

/// Python's repr: fixed notation for decimal exponents from -4 to 15, else scientific.
std::string python_float(double x) {
  if (!std::isfinite(x)) return std::isnan(x) ? "nan" : x > 0 ? "inf" : "-inf";
  char buffer[400];
  const auto format = [&](std::chars_format f) {
    return std::string(buffer, std::to_chars(buffer, buffer + sizeof buffer, x, f).ptr);
  };
  const std::string scientific = format(std::chars_format::scientific);
  const int exponent = std::stoi(scientific.substr(scientific.find('e') + 1));
  if (exponent < -4 || exponent > 15) return scientific;
  const std::string fixed = format(std::chars_format::fixed);
  return fixed.find('.') == std::string::npos ? fixed + ".0" : fixed;
}

std::string python_number(double x) {
  std::string text = python_float(x);
  if (text.ends_with(".0")) text.resize(text.size() - 2);
  return text == "-0" ? "0" : text;
}

}  // namespace supple
