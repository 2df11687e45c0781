/// Powers of ten in pictures.
#pragma once
#include <string>
#include <vector>

namespace supple {

/// The exponent as Unicode superscripts: ⁻⁷.
std::string superscript(int exponent);

/// Three digits at most, with a power of ten where the number is small or large: 0.5, 12, 5·10⁻⁷.
std::string short_number(double value);

/// Part of a line of text, on the line or raised.
struct TextRun {
  std::string text;
  bool raised;
};

/// The font of pictures has no superscripts but 1, 2 and 3: where others stand, all become raised characters.
std::vector<TextRun> text_runs(const std::string& text);

}  // namespace supple
