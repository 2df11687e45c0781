/// Numbers beside their errors.
#pragma once
#include <string>

namespace supple {

/// A value beside its error, "565 ± 17": the error has two digits and the value as many decimals (at most
/// twelve digits in all). Where the error is negative (not known) or 0, five digits of the value alone.
std::string value_with_error(double value, double error);

}  // namespace supple
