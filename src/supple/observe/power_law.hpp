/// Power laws by straight lines through logarithms.
#pragma once
#include <optional>
#include <span>
#include <vector>

namespace supple {

/// y = factor x^exponent by least squares of ln y against ln x, with the standard error of the exponent by
/// the scatter about the line. `from` and `to` are the least and the largest x that took part.
struct PowerLaw {
  double exponent = 0, error = 0;
  double factor = 0;
  double from = 0, to = 0;
  int points = 0;
};

/// The power law through the points with from <= x <= to, to rounding, that a logarithmic axis can show.
/// Nothing with less than three points or a single x. Input error where the lists differ in length.
std::optional<PowerLaw> fit_power_law(std::span<const double> x, std::span<const double> y, double from,
                                      double to);

/// The exponent round each point: the power law over `decades` decades of x with the point in their middle,
/// or moved inwards at the ends of the data. Nothing where the data span less than that, and at points that
/// are not above 0.
std::vector<std::optional<PowerLaw>> local_power_laws(std::span<const double> x, std::span<const double> y,
                                                      double decades);

}  // namespace supple
