/// A step along a descent direction that is good enough.
#pragma once
#include <span>
#include <vector>

#include "supple/solve/descent.hpp"

namespace supple {

/// Moves `descent` from the point last evaluated along `direction`, by at most `most` times it, trying
/// `first` times it first. Accepts by the Wolfe conditions or, where differences of energy drown in rounding,
/// the approximate Wolfe conditions of Hager and Zhang, SIAM J. Optim. 16, 170 (2005). Returns the step; 0,
/// back at the start, if there is none.
double line_search(Descent& descent, std::span<const double> direction, double first, double most);

}  // namespace supple
