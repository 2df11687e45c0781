#include "supple/model/discs.hpp"

#include <fmt/core.h>

#include <numbers>

#include "supple/core/random.hpp"
#include "supple/core/require.hpp"

namespace supple {
namespace {

constexpr double pi = std::numbers::pi;

void check(const DiscSpec& spec, double area) {
  require(spec.count >= 1, "number of discs", spec.count, "at least 1");
  require(spec.packing_fraction > 0, "packing fraction", spec.packing_fraction, "a positive number");
  require(spec.size_ratio >= 1, "size ratio", spec.size_ratio, "large over small radius, at least 1");
  require(spec.density > 0, "density", spec.density, "a positive number");
  require(area > 0, "area of the cell", area, "positive lengths");
}

/// Whether the disc wins its coin; discs 2k and 2k+1 share one, so that exactly one of them is large.
bool is_large_of_two(std::uint64_t seed, int disc) {
  const bool first_is_large =
      RandomStream(seed, Purpose::disc_size, static_cast<std::uint64_t>(disc / 2)).uniform() < 0.5;
  return first_is_large == (disc % 2 == 0);
}

Vec2 random_position(const Box<2>& box, std::uint64_t seed, int disc) {
  RandomStream draw(seed, Purpose::disc_position, static_cast<std::uint64_t>(disc));
  const double x = draw.uniform(), y = draw.uniform();
  return {x * box.length[0], y * box.length[1]};
}

}  // namespace

std::vector<double> bimodal_radii(const DiscSpec& spec, double area, std::uint64_t seed) {
  check(spec, area);
  const int n = spec.count, small_count = n / 2, large_count = n - small_count;
  const double b = spec.size_ratio;
  const double large = std::sqrt(spec.packing_fraction * area / (pi * (large_count + small_count / (b * b))));
  std::vector<double> radius(static_cast<std::size_t>(n), large);
  for (int i = 0; i < 2 * small_count; ++i)
    if (!is_large_of_two(seed, i)) radius[i] = large / b;
  return radius;
}

void add_disc(State<2>& state, const Vec2& position, double radius, double density) {
  const int i = state.size();
  state.resize(i + 1);
  state.position[i] = position;
  state.radius[i] = radius;
  state.mass[i] = density * pi * radius * radius;
  state.inertia[i] = 0.5 * state.mass[i] * radius * radius;
}

System<2> random_discs(const Box<2>& box, const DiscSpec& spec, std::uint64_t seed) {
  const std::vector<double> radius = bimodal_radii(spec, box.volume(), seed);
  System<2> system;
  system.box = box;
  for (int i = 0; i < spec.count; ++i)
    add_disc(system.state, random_position(box, seed, i), radius[i], spec.density);
  return system;
}

System<2> hexagonal_discs(int columns, int rows, double spacing, double radius, double density) {
  if (columns < 1 || rows < 2 || rows % 2 != 0)
    throw input_error(fmt::format("a lattice of {} columns and {} rows", columns, rows),
                      "it cannot be periodic", "give at least one column and an even number of rows");
  System<2> system;
  const double row_height = 0.5 * std::sqrt(3.0) * spacing;
  system.box.length = {columns * spacing, rows * row_height};
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      add_disc(system.state, {(column + (row % 2 ? 0.75 : 0.25)) * spacing, (row + 0.5) * row_height}, radius,
               density);
  return system;
}

System<2> listed_discs(const Box<2>& box, const std::vector<Vec2>& position,
                       const std::vector<double>& radius, double density, const std::vector<Vec2>& velocity,
                       const std::vector<double>& spin) {
  const auto fits = [&](std::size_t size, bool optional) {
    return size == position.size() || (optional && size == 0);
  };
  if (!fits(radius.size(), false) || !fits(velocity.size(), true) || !fits(spin.size(), true))
    throw input_error(fmt::format("lists of {} positions, {} radii, {} velocities and {} spins",
                                  position.size(), radius.size(), velocity.size(), spin.size()),
                      "they describe different numbers of discs", "give one value per disc");
  System<2> system;
  system.box = box;
  for (std::size_t i = 0; i < position.size(); ++i) add_disc(system.state, position[i], radius[i], density);
  if (!velocity.empty()) system.state.velocity = velocity;
  if (!spin.empty()) system.state.spin = spin;
  return system;
}

}  // namespace supple
