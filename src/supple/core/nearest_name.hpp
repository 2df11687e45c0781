/// The valid name that a misspelt one was probably meant to be.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace supple {

/// Smallest number of insertions, deletions, replacements and swaps of neighbours that turn a into b; upper
/// and lower case count as the same letter.
int edit_distance(std::string_view a, std::string_view b);

/// The candidate with the least edit distance to `name`; nothing where more than about one letter in three is
/// wrong.
std::optional<std::string> nearest_name(std::string_view name, const std::vector<std::string>& candidates);

/// "a, b, c", each between `quote`s.
std::string join_names(const std::vector<std::string>& names, std::string_view quote = "'");

}  // namespace supple
