/// Text that is laid out in columns of a terminal.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace supple {

/// Columns of a page of text on a terminal.
inline constexpr std::size_t page_width = 80;

/// Number of columns that UTF-8 text takes, one for each character.
std::size_t text_width(std::string_view text);

/// The pieces with spaces between them, in lines of at most `width` columns; a longer piece has a line of its
/// own.
std::vector<std::string> wrap_pieces(const std::vector<std::string>& pieces, std::size_t width);
/// The words of `text` in lines of at most `width` columns.
std::vector<std::string> wrap_words(std::string_view text, std::size_t width);

/// `begin`, then the words of `text` from column `indent` on, in lines of at most page_width columns, each
/// with its line break. Where `begin` reaches beyond `indent` the words start on the next line.
std::string hang_words(std::string_view begin, std::string_view text, std::size_t indent);

/// Width of each column of a table: that of its widest cell.
std::vector<std::size_t> widths_of(const std::vector<std::vector<std::string>>& rows);

/// A row of a table: its cells, left-aligned in columns of these widths with two spaces before each; then the
/// words of `text`, as hang_words() lays them out.
std::string table_row(const std::vector<std::string>& cells, const std::vector<std::size_t>& widths,
                      std::string_view text);

}  // namespace supple
