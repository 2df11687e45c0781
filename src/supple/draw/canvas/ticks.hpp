/// Round numbers and units for axes and scale bars.
#pragma once
#include <string>
#include <vector>

namespace supple {

/// The largest 1, 2 or 5 times a power of ten that is not above x > 0.
double round_below(double x);

/// Round positions, evenly spaced by 1, 2, 2.5 or 5 times a power of ten, within [low, high]; about `count`
/// of them.
struct Ticks {
  std::vector<double> at;
  double step = 1;
};
Ticks nice_ticks(double low, double high, int count);

/// A number at a tick, with as many decimals as the step needs and a true minus sign.
std::string tick_label(double value, double step);

/// The hyphen that a formatted number begins with becomes the minus sign.
std::string with_minus_sign(std::string number);

/// SI prefix that brings |largest| into [1, 1000): value / factor carries prefix + unit.
struct Prefix {
  double factor = 1;
  std::string symbol;
};
Prefix si_prefix(double largest);

/// How numbers up to |largest| are shown beside an axis: value / factor, and what to write for the unit. A
/// unit gets its prefix; "%" stands for 0.01; a unit that begins with a digit stays as it is; without a unit,
/// or with one of the model's symbols ("k_a a0"), very large and very small numbers get a power of ten.
struct ShownUnit {
  double factor = 1;
  std::string text;
};
ShownUnit shown_unit(const std::string& unit, double largest);

/// A value with SI prefix: three digits ("1.20 ms"), or as few as a round number has ("1.2 ms").
enum class Digits { three, fewest };
std::string with_unit(double value, const std::string& unit, Digits digits = Digits::three);

}  // namespace supple
