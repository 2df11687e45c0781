/// Numbers as text, in as few digits as read back to the same double.
#pragma once
#include <cstdint>
#include <string>

namespace supple {

/// Appends the shortest form: 150, 0.1, 1e-06.
void append_shortest(std::string& text, double x);
void append_integer(std::string& text, std::int64_t x);

/// The double as Python's str() writes a float: 150.0, 0.1, 1e-06, 1e+16.
std::string python_float(double x);
/// The same, but a whole number as Python writes an int: 150.
std::string python_number(double x);

}  // namespace supple
