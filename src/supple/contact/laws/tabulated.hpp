/// A repulsion law given by the user as a formula or a function, tabulated so that it is as fast as a
/// built-in one.
#pragma once
#include <bit>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace supple {

/// Force of two discs at the distance d <= d0 [force], positive: repulsion; k [force/length] and c are those
/// of the case.
using RepulsionFunction = std::function<double(double d, double d0, double k, double c)>;

/// F = k d0 g(d/d0), with g a cubic Hermite spline (continuously differentiable) on cells whose width halves
/// from octave to octave toward d = 0, so that steep cores are resolved; g is constant below d = d0/4096. The
/// energy is the exact integral of the spline.
class Tabulated {
 public:
  static constexpr std::string_view name = "expression";

  /// Throws an input error that names `what` unless, over (0, d0], the law is finite, not attractive, zero at
  /// d0, below 1000 k d0, proportional to k, and homogeneous: F(s d, s d0) = s F(d, d0).
  Tabulated(const RepulsionFunction& law, double c, const std::string& what);

  double force(double d, double d0, double k) const {
    const double x = clamped(d / d0);
    const Cell& cell = cell_at(x);
    const double s = x - cell.start;
    return k * d0 * (cell.a + s * (cell.b + s * (cell.c + s * cell.d)));
  }
  double energy(double d, double d0, double k) const;
  double stiffness(double d, double d0, double k) const {
    const double x = d / d0;
    const Cell& cell = cell_at(clamped(x));
    const double s = x - cell.start;
    return x < least ? 0 : -k * (cell.b + s * (2 * cell.c + s * 3 * cell.d));
  }

  /// Largest |spline - law| / (k d0) over max(1, F / (k d0)), on four points of every cell.
  double error_bound() const { return error_bound_; }

 private:
  /// g = a + b s + c s^2 + d s^3, s = x - start; `energy`: integral of g from `start` to 1.
  struct Cell {
    double start, a, b, c, d, energy;
  };
  static constexpr int octaves = 12;
  static constexpr double least = 1.0 / (1 << octaves);

  /// Index of the cell of x: exponent and leading bits of the mantissa number the cells in ascending x.
  std::int64_t index(double x) const { return (std::bit_cast<std::int64_t>(x) >> shift_) - base_; }
  static double clamped(double x) { return x < least ? least : x; }
  const Cell& cell_at(double x) const {
    const auto i = static_cast<std::size_t>(index(x));
    return (*cells_)[i < cells_->size() ? i : cells_->size() - 1];
  }
  void build(const std::function<double(double)>& g, int bits);

  std::shared_ptr<const std::vector<Cell>> cells_;  ///< shared: a law is copied with its contacts
  std::int64_t base_ = 0;
  int shift_ = 0;
  double error_bound_ = 0;
};

}  // namespace supple
