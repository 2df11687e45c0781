/// Text that is laid out in columns of a terminal.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace supple {

inline constexpr std::size_t page_width = 80;

/// Columns that UTF-8 text takes: its characters.
std::size_t text_width(std::string_view text);

/// The pieces with spaces between, in lines of at most `width` columns; a piece that is longer has a line of
/// its own.
std::vector<std::string> wrap_pieces(const std::vector<std::string>& pieces, std::size_t width);
/// The same of the words of `text`.
std::vector<std::string> wrap_words(std::string_view text, std::size_t width);

/// `begin`, and from column `indent` on the words of `text`, in lines that end before the page does; each
/// with its line break. Where `begin` is too long the words begin below it.
std::string hang_words(std::string_view begin, std::string_view text, std::size_t indent);

/// Widths of the columns of a table: of the widest cell of each.
std::vector<std::size_t> widths_of(const std::vector<std::vector<std::string>>& rows);

/// A row: its cells, left-aligned in columns of these widths, two spaces between; then the words of `text` as
/// above.
std::string table_row(const std::vector<std::string>& cells, const std::vector<std::size_t>& widths,
                      std::string_view text);

}  // namespace supple
