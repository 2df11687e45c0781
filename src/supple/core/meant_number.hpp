/// The number that a text in another spelling probably means.
#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace supple {

/// The spelling that cases and formulas accept: "0.1" for ".1", "1.0" for "1.", "3" for "+3", "10" for "010",
/// "0.2" for "0,2"; a typographic minus becomes "-". An accepted spelling stays as it is. "1,000" may mean
/// two numbers and gives "1.000 or 1000". Nothing where the text is no number.
std::optional<std::string> meant_number(std::string_view text);

}  // namespace supple
