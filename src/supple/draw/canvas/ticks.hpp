/// Round numbers and units for axes and scale bars.
#pragma once
#include <string>
#include <vector>

namespace supple {

/// The largest number of the form 1, 2 or 5 times a power of ten that is at most x > 0.
double round_below(double x);

/// About `count` round positions in [low, high], spaced by 1, 2, 2.5 or 5 times a power of ten.
struct Ticks {
  std::vector<double> at;
  double step = 1;
};
Ticks nice_ticks(double low, double high, int count);

/// A number at a tick, with as many decimals as the step needs and a true minus sign.
std::string tick_label(double value, double step);

/// The text of a number, with a true minus sign for the hyphen at its start.
std::string with_minus_sign(std::string number);

/// The SI prefix that brings |largest| into [1, 1000): value / factor is in units of prefix + unit.
struct Prefix {
  double factor = 1;
  std::string symbol;
};
Prefix si_prefix(double largest);

/// How numbers up to |largest| are shown on an axis: as value / factor, with `text` for the unit. A unit gets
/// an SI prefix; "%" means 0.01; a unit that begins with a digit stays as it is; without a unit, or with a
/// symbol of the model ("k_a a0"), very large and very small numbers get a power of ten.
struct ShownUnit {
  double factor = 1;
  std::string text;
};
ShownUnit shown_unit(const std::string& unit, double largest);

/// A value with its unit and SI prefix, with three digits ("1.20 ms") or as few as a round number needs ("1.2
/// ms").
enum class Digits { three, fewest };
std::string with_unit(double value, const std::string& unit, Digits digits = Digits::three);

}  // namespace supple
