/// The image that a row of the pair table is about, and how the row keeps it when a site crosses the
/// boundary.
#pragma once
#include <cmath>
#include <string>

#include "supple/core/error.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// The cells of an image as numbers, by direction.
template <int Dim>
Vec<Dim> cells_of(const RowImage& image) {
  Vec<Dim> cells;
  for (int d = 0; d < Dim; ++d) cells[d] = image.cells[static_cast<std::size_t>(d)];
  return cells;
}

/// Vector from the first site of the row to the image of the second that the row is about: the one that it
/// keeps (RowImage), or else the nearest.
template <int Dim>
typename Box<Dim>::Separation row_separation(const System<Dim>& system, std::int32_t row) {
  const PairTable& pairs = system.pairs;
  const Vec<Dim>&a = system.state.position[pairs.first[row]], &b = system.state.position[pairs.second[row]];
  if (pairs.image.empty() || !pairs.image[row].kept) return system.box.separation(a, b);
  return system.box.separation(a, b, cells_of<Dim>(pairs.image[row]));
}

/// Most cells that a site may cross at once: a coordinate further out lacks the digits that contacts need.
inline constexpr double most_cells_passed = 1e6;

/// Whether a site can be moved by these cells: false where they are not finite numbers. Numerics error where
/// they are more than `most_cells_passed`.
template <int Dim>
bool is_passable(std::int32_t site, const Vec<Dim>& cells) {
  for (int d = 0; d < Dim; ++d) {
    if (!std::isfinite(cells[d])) return false;
    if (std::abs(cells[d]) > most_cells_passed)
      throw numerics_error("site " + std::to_string(site) + " left a million cells behind",
                           "the time step may be too large or the law too stiff", "reduce [time] step");
  }
  return true;
}

/// Whether x is in the cell, or beyond it only where the cell is not periodic. Asked for every site at every
/// step, and nearly always true.
template <int Dim>
bool is_in_cell(const Box<Dim>& box, const Vec<Dim>& x) {
  bool inside = true;
  for (int d = 0; d < Dim; ++d) inside = inside && (!box.periodic[d] || (0 <= x[d] && x[d] < box.length[d]));
  return inside;
}

/// Brings site i into the cell, with its velocity; links keep their images. A position that is not finite
/// stays. Numerics error where the site has crossed more than `most_cells_passed` cells.
template <int Dim>
void wrap_site(System<Dim>& system, std::int32_t i) {
  if (is_in_cell(system.box, system.state.position[i])) return;
  const Vec<Dim> moved = system.box.wrap(system.state.position[i], system.state.velocity[i]);
  if (moved == Vec<Dim>{}) return;
  if (!is_passable(i, moved)) return;
  if (system.pairs.image.empty()) return;
  std::array<std::int32_t, 3> cells{};
  for (int d = 0; d < Dim; ++d) cells[static_cast<std::size_t>(d)] = static_cast<std::int32_t>(moved[d]);
  follow_images(system.pairs, i, cells);
}

}  // namespace supple
