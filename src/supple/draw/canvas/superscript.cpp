#include "supple/draw/canvas/superscript.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

namespace supple {

namespace {

/// Superscripts 0 to 9 and minus, and what they raise.
constexpr std::array<std::pair<std::string_view, std::string_view>, 11> raised{{{"\u2070", "0"},
                                                                                {"\u00b9", "1"},
                                                                                {"\u00b2", "2"},
                                                                                {"\u00b3", "3"},
                                                                                {"\u2074", "4"},
                                                                                {"\u2075", "5"},
                                                                                {"\u2076", "6"},
                                                                                {"\u2077", "7"},
                                                                                {"\u2078", "8"},
                                                                                {"\u2079", "9"},
                                                                                {"\u207b", "\u2212"}}};

bool is_in_font(std::string_view superscript) {
  return superscript.size() == 2;
}  // Latin-1: two bytes of UTF-8

}  // namespace

std::string superscript(int exponent) {
  std::string text;
  for (const char c : std::to_string(exponent)) text += raised[c == '-' ? 10 : c - '0'].first;
  return text;
}

std::string short_number(double value) {
  const double size = std::abs(value);
  std::string text;
  if (size == 0 || !std::isfinite(size) || (size >= 1e-3 && size < 1e4)) {
    text = fmt::format("{:.3g}", value);
  } else {
    const std::string scientific = fmt::format("{:.2e}", value);
    const std::size_t e = scientific.find('e');
    text = fmt::format("{:.3g}\u00b710{}", std::stod(scientific.substr(0, e)),
                       superscript(std::stoi(scientific.substr(e + 1))));
  }
  if (text[0] == '-') text.replace(0, 1, "\u2212");
  return text;
}

std::vector<TextRun> text_runs(const std::string& text) {
  const auto is_missing = [&](const auto& entry) {
    return !is_in_font(entry.first) && text.find(entry.first) != std::string::npos;
  };
  if (std::none_of(raised.begin(), raised.end(), is_missing)) return {{text, false}};
  std::vector<TextRun> runs;
  for (std::size_t at = 0; at < text.size();) {
    const auto found = std::find_if(raised.begin(), raised.end(), [&](const auto& entry) {
      return text.compare(at, entry.first.size(), entry.first) == 0;
    });
    const bool up = found != raised.end();
    if (runs.empty() || runs.back().raised != up) runs.push_back({"", up});
    runs.back().text += up ? found->second : std::string_view(text).substr(at, 1);
    at += up ? found->first.size() : 1;
  }
  return runs;
}

}  // namespace supple
