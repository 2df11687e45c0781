/// A search for a step along a descent direction that lowers the energy enough.
#pragma once
#include <span>
#include <vector>

#include "supple/solve/descent.hpp"

namespace supple {

/// Moves `descent` from the point last evaluated to x + step * direction, step at most `most` and at first
/// `first`. A step is accepted by the Wolfe conditions or, where differences of energy drown in rounding, by
/// the approximate Wolfe conditions of Hager and Zhang, SIAM J. Optim. 16, 170 (2005). Returns the step; 0 if
/// none was accepted, with `descent` back at the start.
double line_search(Descent& descent, std::span<const double> direction, double first, double most);

}  // namespace supple
