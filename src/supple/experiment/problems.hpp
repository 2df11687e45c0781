/// Everything that is wrong with a case, gathered so that one error says all of it.
#pragma once
#include <string>
#include <vector>

#include "supple/core/error.hpp"
#include "supple/experiment/case.hpp"

namespace supple {

using Problems = std::vector<std::string>;
/// Warnings of what is allowed but was probably not meant.
using Doubts = std::vector<std::string>;

/// Adds a problem with the text of an input error that names the file of the case.
inline void add_problem(Problems& problems, const Case& c, const std::string& what, const std::string& why,
                        const std::string& to_do) {
  const std::string place = c.origin.empty() ? "" : c.origin + ": ";
  problems.push_back(input_error(place + what, why, to_do).what());
}

}  // namespace supple
