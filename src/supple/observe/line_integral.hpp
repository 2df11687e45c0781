/// Integrals over the lines along z that meet a rectangle, on randomly shifted lattices of lines.
#pragma once
#include <cmath>
#include <cstdint>

#include "supple/core/random.hpp"
#include "supple/geometry/bounds.hpp"
#include "supple/geometry/line_chord.hpp"

namespace supple {

/// An integral with its standard error.
struct LineIntegral {
  double value = 0, error = 0;
};

/// Shifts of the lattice, from whose spread the error is known with one degree of freedom less.
inline constexpr int lattice_shifts = 8;

/// A Fibonacci number of lines, and the one before it.
struct LatticeSize {
  std::int64_t lines = 21, before = 13;
  void grow() {
    const std::int64_t next = lines + before;
    before = lines;
    lines = next;
  }
};

/// The integral of f(line) over the points of a rectangle, from `lattice_shifts` independent shifts of one
/// Fibonacci lattice, each of `size.lines` points (i/F_m, i F_(m-1)/F_m mod 1), which crosses edges of no
/// direction in rows [Sloan & Joe 1994, Lattice Methods for Multiple Integration, sections 4.2 and 4.6].
/// Shifted at random the lattice has no bias [Cranley & Patterson 1976]. Its error falls as 1/lines for the
/// chords of smooth bodies.
template <class F>
LineIntegral integrate_over_lines(const Bounds& rectangle, const LatticeSize& size, RandomStream& draw,
                                  const F& f) {
  const Vec2 extent = rectangle.high - rectangle.low;
  const double n = static_cast<double>(size.lines);
  double mean[lattice_shifts], sum = 0, squares = 0;
  for (double& m : mean) {
    const double u = draw.uniform(), v = draw.uniform();
    m = 0;
    std::int64_t up = 0;  // i F_(m-1) mod F_m
    for (std::int64_t i = 0; i < size.lines; ++i) {
      const double y = static_cast<double>(up) / n + v;
      const double x = (static_cast<double>(i) + u) / n;
      m +=
          f(LineAlongZ{rectangle.low[0] + x * extent[0], rectangle.low[1] + (y - std::floor(y)) * extent[1]});
      up += size.before;
      if (up >= size.lines) up -= size.lines;
    }
    m /= n;
    sum += m;
  }
  const double whole = sum / lattice_shifts, area = extent[0] * extent[1];
  for (const double m : mean) squares += (m - whole) * (m - whole);
  return {area * whole, area * std::sqrt(squares / (lattice_shifts * (lattice_shifts - 1.0)))};
}

/// The same to this error [unit of the integral], with at most `most_lines` lines. How many are needed is
/// guessed from a small lattice whose lines are not used again: to stop where the spread happens to be small
/// would make the errors too small.
template <class F>
LineIntegral integrate_over_lines(const Bounds& rectangle, double wanted_error, std::int64_t most_lines,
                                  RandomStream& draw, const F& f) {
  LatticeSize size;
  const double found = integrate_over_lines(rectangle, size, draw, f).error;
  const double first = static_cast<double>(size.lines);
  while (static_cast<double>(size.lines) * wanted_error < first * found &&
         (size.lines + size.before) * lattice_shifts <= most_lines)
    size.grow();
  return integrate_over_lines(rectangle, size, draw, f);
}

}  // namespace supple
