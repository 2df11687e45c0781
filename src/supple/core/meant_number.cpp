#include "supple/core/meant_number.hpp"

#include <cctype>

namespace supple {

namespace {

constexpr std::string_view typographic_minus = "\u2212";

/// Takes the digits at the start of `text`.
std::string take_digits(std::string_view& text) {
  std::string digits;
  while (!text.empty() && std::isdigit(static_cast<unsigned char>(text.front()))) {
    digits += text.front();
    text.remove_prefix(1);
  }
  return digits;
}

std::string take_sign(std::string_view& text) {
  const bool typographic = text.starts_with(typographic_minus);
  if (!typographic && !text.starts_with('-') && !text.starts_with('+')) return "";
  const std::string sign = text.starts_with('+') ? "" : "-";
  text.remove_prefix(typographic ? typographic_minus.size() : 1);
  return sign;
}

std::string without_leading_zeros(std::string digits) {
  while (digits.size() > 1 && digits.front() == '0') digits.erase(0, 1);
  return digits.empty() ? "0" : digits;
}

}  // namespace

std::optional<std::string> meant_number(std::string_view text) {
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front()))) text.remove_prefix(1);
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.remove_suffix(1);
  const std::string sign = take_sign(text);
  const std::string whole = take_digits(text);
  const char mark = text.empty() ? '\0' : text.front();
  std::string fraction, exponent;
  const bool marked = mark == '.' || mark == ',';
  if (marked) {
    text.remove_prefix(1);
    fraction = take_digits(text);
  }
  if (whole.empty() && fraction.empty()) return std::nullopt;
  if (text.starts_with('e') || text.starts_with('E')) {
    text.remove_prefix(1);
    exponent = "e" + take_sign(text);
    const std::string digits = take_digits(text);
    if (digits.empty()) return std::nullopt;
    exponent += digits;
  }
  if (!text.empty()) return std::nullopt;
  const std::string number = sign + without_leading_zeros(whole);
  if (!marked) return number + exponent;
  const bool thousands = mark == ',' && fraction.size() == 3 && exponent.empty() && !whole.empty() &&
                         whole.size() <= 3 && whole.front() != '0';
  return number + "." + (fraction.empty() ? "0" : fraction) + exponent +
         (thousands ? " or " + sign + whole + fraction : "");
}

}  // namespace supple
