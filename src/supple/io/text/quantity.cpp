#include "supple/io/text/quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "supple/core/error.hpp"
#include "supple/core/meant_number.hpp"

namespace supple {

namespace {

/// 10^power times metre^length kilogram^mass second^time degree^angle.
struct Unit {
  int power = 0;
  std::array<int, 4> dimension{};  // length, mass, time, angle

  void multiply(const Unit& u, int exponent) {
    power += u.power * exponent;
    for (std::size_t d = 0; d < dimension.size(); ++d) dimension[d] += u.dimension[d] * exponent;
  }
};

struct NamedUnit {
  std::string_view name;
  Unit unit;
};
struct Prefix {
  std::string_view name;
  int power;
};

constexpr NamedUnit units[] = {
    {"m", {0, {1, 0, 0, 0}}},    {"g", {-3, {0, 1, 0, 0}}},     {"s", {0, {0, 0, 1, 0}}},
    {"Pa", {0, {-1, 1, -2, 0}}}, {"N", {0, {1, 1, -2, 0}}},     {"J", {0, {2, 1, -2, 0}}},
    {"Hz", {0, {0, 0, -1, 0}}},  {"degree", {0, {0, 0, 0, 1}}}, {"deg", {0, {0, 0, 0, 1}}},
    {"°", {0, {0, 0, 0, 1}}},    {"1", {0, {0, 0, 0, 0}}},
};
constexpr Prefix prefixes[] = {{"p", -12}, {"n", -9}, {"u", -6}, {"µ", -6}, {"μ", -6},
                               {"m", -3},  {"c", -2}, {"k", 3},  {"M", 6},  {"G", 9}};

std::optional<Unit> find_unit(std::string_view name) {
  for (const NamedUnit& u : units)
    if (name == u.name) return u.unit;
  for (const Prefix& p : prefixes)
    if (name.substr(0, p.name.size()) == p.name)
      for (const NamedUnit& u : units)
        if (name.substr(p.name.size()) == u.name && u.name != "1") {
          Unit scaled = u.unit;
          scaled.power += p.power;
          return scaled;
        }
  return std::nullopt;
}

/// One factor, such as "m^3", "m-3" or "m³".
std::optional<Unit> parse_factor(std::string_view text) {
  constexpr std::pair<std::string_view, int> superscripts[] = {{"²", 2}, {"³", 3}};
  int exponent = 1;
  for (const auto& [mark, value] : superscripts)
    if (text.ends_with(mark)) {
      exponent = value;
      text.remove_suffix(mark.size());
    }
  if (const auto at = text.find_first_of("^-"); at != text.npos) {
    std::string_view digits = text.substr(text[at] == '^' ? at + 1 : at);
    const auto end = digits.data() + digits.size();
    if (const auto r = std::from_chars(digits.data(), end, exponent); r.ec != std::errc{} || r.ptr != end)
      return std::nullopt;
    text = text.substr(0, at);
  }
  const auto unit = find_unit(text);
  if (!unit) return std::nullopt;
  Unit out;
  out.multiply(*unit, exponent);
  return out;
}

/// A product of factors separated by spaces, '*' or '/' (which divides by the next factor only).
std::optional<Unit> parse_unit(std::string_view text) {
  Unit out;
  int sign = 1;
  while (!text.empty()) {
    const auto end = text.find_first_of(" */");
    if (const std::string_view factor = text.substr(0, end); !factor.empty()) {
      const auto unit = parse_factor(factor);
      if (!unit) return std::nullopt;
      out.multiply(*unit, sign);
      sign = 1;
    }
    if (end == text.npos) break;
    if (text[end] == '/') sign = -1;
    text.remove_prefix(end + 1);
  }
  return out;
}

std::string_view trim(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

/// A number at the start of `text` and what follows it; nothing where there is no finite number.
struct Leading {
  double value;
  std::string_view digits, rest;
};
std::optional<Leading> leading_number(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || !std::isfinite(value)) return std::nullopt;
  const auto used = static_cast<std::size_t>(end - text.data());
  return Leading{value, text.substr(0, used), trim(text.substr(used))};
}

/// The number `digits` times 10^power, rounded once: the power is added to the exponent of the text.
double scaled_number(std::string_view digits, int power) {
  if (const auto e = digits.find_first_of("eE"); e != digits.npos) {
    int exponent = 0;
    const std::string_view sign_and_digits = digits.substr(digits[e + 1] == '+' ? e + 2 : e + 1);
    std::from_chars(sign_and_digits.data(), sign_and_digits.data() + sign_and_digits.size(), exponent);
    power += exponent;
    digits = digits.substr(0, e);
  }
  return leading_number(fmt::format("{}e{}", digits, power)).value().value;
}

/// What to write where nothing better is known.
std::string want_number(std::string_view unit) {
  const std::string_view example = example_quantity(unit);
  return fmt::format("write a number{}{}{}", unit.empty() ? "" : " in ", unit,
                     example.empty() ? "" : fmt::format(", or \"{}\"", example));
}

/// A decimal comma, a missing zero or an unknown sign before a unit.
Error not_a_quantity(std::string_view text, std::string_view unit, const std::string& why) {
  const auto end = text.find_first_not_of("+-0123456789.,eE\u2212");
  const auto meant = meant_number(text.substr(0, end));
  return input_error(fmt::format("\"{}\" is not a number", text), why,
                     meant && end != text.npos
                         ? fmt::format("write \"{} {}\"", *meant, trim(text.substr(end)))
                         : want_number(unit));
}

std::string lower(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

/// Spellings of a factor such as "kpa", "m3", "Pascal" or "µM" that are units.
std::vector<std::string> meant_factors(std::string_view text) {
  constexpr std::pair<std::string_view, std::string_view> words[] = {
      {"pascal", "Pa"},      {"metre", "m"},   {"meter", "m"},  {"second", "s"}, {"sec", "s"},
      {"newton", "N"},       {"gram", "g"},    {"joule", "J"},  {"hertz", "Hz"}, {"percent", "%"},
      {"degrees", "degree"}, {"micron", "um"}, {"minutes", "s"}};
  const auto end = text.find_first_of("^-0123456789");
  std::string power(end == text.npos ? "" : text.substr(end));
  if (!power.empty() && power.front() != '^') power = "^" + power;
  const std::string name = lower(text.substr(0, end));
  std::vector<std::string> out;
  const auto offer = [&](const std::string& unit) {
    if (const std::string factor = unit + power; parse_factor(factor)) out.push_back(factor);
  };
  for (const NamedUnit& u : units) {
    if (name == lower(u.name)) offer(std::string(u.name));
    for (const Prefix& p : prefixes)
      if (const std::string both = fmt::format("{}{}", p.name, u.name); u.name != "1" && name == lower(both))
        offer(both);
  }
  for (const auto& [word, unit] : words)
    if (name == word || name == fmt::format("{}s", word)) offer(std::string(unit));
  return out;
}

/// Units of the wanted dimension that `written` may have been meant to be, factor by factor.
std::vector<std::string> meant_units(std::string_view written, const Unit& wanted) {
  std::vector<std::string> out{""};
  while (!written.empty()) {
    const auto end = std::min(written.find_first_of(" */"), written.size());
    const std::string_view factor = written.substr(0, end);
    const std::vector<std::string> spellings =
        factor.empty() || parse_factor(factor) ? std::vector{std::string(factor)} : meant_factors(factor);
    std::vector<std::string> longer;
    for (const std::string& begin : out)
      for (const std::string& spelling : spellings)
        longer.push_back(begin + spelling + std::string(written.substr(end, 1)));
    out = std::move(longer);
    written.remove_prefix(std::min(end + 1, written.size()));
  }
  std::erase_if(out, [&](const std::string& unit) {
    const auto found = parse_unit(unit);
    return !found || found->dimension != wanted.dimension;
  });
  return out;
}

Error unknown_unit(std::string_view text, std::string_view digits, std::string_view written,
                   std::string_view unit, const Unit& wanted, const std::string& why) {
  std::string offers;
  for (const std::string& meant : meant_units(written, wanted))
    offers += fmt::format("{}\"{} {}\"", offers.empty() ? "" : " or ", digits, meant);
  return input_error(fmt::format("\"{}\" has the unknown unit '{}'", text, written), why,
                     offers.empty() ? want_number(unit) : "did you mean " + offers + "?");
}

}  // namespace

double parse_quantity(std::string_view text, std::string_view unit, const std::string& why) {
  text = trim(text);
  if (const auto meant = meant_number(text))
    throw input_error(fmt::format("\"{}\" is text, not a number", text), why,
                      fmt::format("write {}{}{}, without quotes", *meant, unit.empty() ? "" : ", in ", unit));
  const auto number = leading_number(text);
  if (!number || number->rest.starts_with(',')) throw not_a_quantity(text, unit, why);
  const auto& [value, digits, written] = *number;

  if (written == unit && !unit.empty()) return value;
  if (unit.empty() && written == "%") return scaled_number(digits, -2);
  const auto wanted = parse_unit(unit);
  if (!wanted || unit.empty())
    throw input_error(fmt::format("\"{}\" has a unit where none is expected", text), why,
                      fmt::format("write a number{}{}", unit.empty() ? "" : " in ", unit));
  const auto found = parse_unit(written);
  if (!found) throw unknown_unit(text, digits, written, unit, *wanted, why);
  if (found->dimension != wanted->dimension)
    throw input_error(
        fmt::format("\"{}\" has the wrong dimension, '{}' is no multiple of {}", text, written, unit), why,
        want_number(unit));
  return scaled_number(digits, found->power - wanted->power);
}

std::string_view example_quantity(std::string_view unit) {
  constexpr std::pair<std::string_view, std::string_view> examples[] = {
      {"m", "500 um"}, {"Pa", "8 kPa"}, {"s", "0.1 us"}, {"kg/m^3", "1000 kg/m^3"}, {"degree", "15 degree"}};
  for (const auto& [name, example] : examples)
    if (name == unit) return example;
  return {};
}

}  // namespace supple
