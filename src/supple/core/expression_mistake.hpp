/// What was probably meant by a formula that cannot be read.
#pragma once
#include <string>
#include <vector>

namespace mu {
class ParserError;
}

namespace supple {

struct ExpressionMistake {
  std::string why,
      to_do;  ///< to_do: empty where nothing better is known than the list of what may stand there
};

/// `names`: of variables, constants and functions.
ExpressionMistake find_mistake(const std::string& text, const mu::ParserError& error,
                               const std::vector<std::string>& names);

}  // namespace supple
