/// The number that a text with another spelling of it was probably meant to be.
#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace supple {

/// The spelling that cases and formulas take of ".1", "1.", "+3", "010", "0,2" or a number with a typographic
/// minus: "0.1", "1.0", "3", "10", "0.2"; what is spelt so already stays. "1,000" may be two numbers: "1.000
/// or 1000". Nothing where the text is no number.
std::optional<std::string> meant_number(std::string_view text);

}  // namespace supple
