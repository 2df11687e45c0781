/// What is wrong with a line that is not TOML, and what was probably meant.
#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace supple {

/// "true" or "false" where the text is another spelling of it, such as True, yes or OFF; else nothing.
std::optional<std::string_view> meant_truth(std::string_view text);

/// What to do about a whole number in another spelling, "write 150" for the text "150.0"; empty where the
/// text is no whole number.
std::string how_to_write_integer(std::string_view text);

/// What is wrong, and what to do about it.
struct TomlMistake {
  std::string why, to_do;  ///< both empty where the line does not tell
};

/// The mistake in line `line`, counted from 1, at which the TOML library gave up.
TomlMistake find_toml_mistake(std::string_view text, std::size_t line);

/// The mistake in the value of a key, the text right of "=".
TomlMistake find_value_mistake(std::string_view key, std::string_view value);

}  // namespace supple
