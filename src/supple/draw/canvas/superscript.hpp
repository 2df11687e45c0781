/// Powers of ten in pictures.
#pragma once
#include <string>
#include <vector>

namespace supple {

/// The exponent as Unicode superscripts: ⁻⁷.
std::string superscript(int exponent);

/// The number with at most three digits, and a power of ten where it is small or large: 0.5, 12, 5·10⁻⁷.
std::string short_number(double value);

/// Part of a line of text, on the line or raised.
struct TextRun {
  std::string text;
  bool raised;
};

/// Splits a line into parts. The font of pictures has only the superscripts 1, 2 and 3: where a line has
/// others, all of its superscripts become raised characters.
std::vector<TextRun> text_runs(const std::string& text);

}  // namespace supple
