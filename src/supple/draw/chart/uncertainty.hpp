/// Numbers beside their errors.
#pragma once
#include <string>

namespace supple {

/// "565 ± 17": the error with two digits, the value with the same decimals (at most twelve digits in all).
/// Without an error (negative) five digits of the value; so, too, with an error of 0.
std::string value_with_error(double value, double error);

}  // namespace supple
