#include "supple/core/text_columns.hpp"

#include <algorithm>
#include <sstream>

namespace supple {

namespace {

/// Words that explain have at least this many columns, however long what stands before them.
constexpr std::size_t least_width = 22;

std::string padded(std::string text, std::size_t width) {
  const std::size_t used = text_width(text);
  return used < width ? text + std::string(width - used, ' ') : text;
}

}  // namespace

std::size_t text_width(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::vector<std::string> wrap_pieces(const std::vector<std::string>& pieces, std::size_t width) {
  std::vector<std::string> lines{""};
  for (const std::string& piece : pieces) {
    if (!lines.back().empty() && text_width(lines.back()) + 1 + text_width(piece) > width)
      lines.emplace_back();
    lines.back() += (lines.back().empty() ? "" : " ") + piece;
  }
  return lines;
}

std::vector<std::string> wrap_words(std::string_view text, std::size_t width) {
  std::istringstream words{std::string(text)};
  std::vector<std::string> pieces;
  for (std::string word; words >> word;) pieces.push_back(word);
  return wrap_pieces(pieces, width);
}

std::string hang_words(std::string_view begin, std::string_view text, std::size_t indent) {
  indent = std::min(indent, page_width - least_width);
  std::string out(begin);
  if (text_width(begin) >= indent && indent > 0) out += "\n" + std::string(indent, ' ');
  else out = padded(out, indent);
  bool first = true;
  for (const std::string& line : wrap_words(text, page_width - indent)) {
    if (!first) out += std::string(indent, ' ');
    out += line + "\n";
    first = false;
  }
  return out;
}

std::vector<std::size_t> widths_of(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], text_width(row[i]));
  }
  return widths;
}

std::string table_row(const std::vector<std::string>& cells, const std::vector<std::size_t>& widths,
                      std::string_view text) {
  std::string begin;
  std::size_t indent = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    begin += "  " + cells[i];
    indent += 2 + widths[i];
    if (i + 1 < cells.size() || !text.empty()) begin = padded(begin, indent);
  }
  while (begin.ends_with(' ')) begin.pop_back();
  return text.empty() ? begin + "\n" : hang_words(begin, text, indent + 2);
}

}  // namespace supple
