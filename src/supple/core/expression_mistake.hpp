/// What is wrong with a formula that cannot be read, and what was probably meant.
#pragma once
#include <string>
#include <vector>

namespace mu {
class ParserError;
}

namespace supple {

/// What is wrong, and what to do about it.
struct ExpressionMistake {
  std::string why,
      to_do;  ///< `to_do` is empty where only the general list of what a formula may hold helps
};

/// Explains an error of the parser in the words of a user. `names` are those that a formula may use:
/// variables, constants and functions.
ExpressionMistake find_mistake(const std::string& text, const mu::ParserError& error,
                               const std::vector<std::string>& names);

}  // namespace supple
