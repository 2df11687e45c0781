/// What was probably meant by a line that is not TOML.
#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace supple {

/// "true" or "false" where the text is one of them as other languages and people write them: True, yes, OFF,
/// ...
std::optional<std::string_view> meant_truth(std::string_view text);

/// "write 150" for "150", "150.0" or "1e3"; empty where the text is no integer.
std::string how_to_write_integer(std::string_view text);

struct TomlMistake {
  std::string why, to_do;  ///< both empty where the line does not tell
};

/// The mistake in line `line`, counted from 1, where the reader of TOML gave up.
TomlMistake find_toml_mistake(std::string_view text, std::size_t line);

/// The same of what stands right of "=".
TomlMistake find_value_mistake(std::string_view key, std::string_view value);

}  // namespace supple
