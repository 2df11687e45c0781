/// Contacts of two bodies of one site each: discs, spheres.
#pragma once
#include <span>

#include "supple/contact/coincident.hpp"
#include "supple/contact/linked_touches.hpp"
#include "supple/contact/row_images.hpp"

namespace supple {

/// meet(row, i, j, distance, normal, sigma) for each of these rows of round bodies that touch: the normal is
/// from i to j. `shifts` are those of `images` at the box of now.
template <int Dim, class Laws, class Meet>
void walk_round_bodies(const System<Dim>& system, const Laws& laws, std::span<const std::int32_t> rows,
                       const RowImages<Dim>& images, const std::vector<Vec<Dim>>& shifts,
                       const LinkedTouches<Dim>& linked, const std::vector<std::int32_t>& body,
                       const Meet& meet) {
  const State<Dim>& state = system.state;
  for (const std::int32_t row : rows) {
    const std::int32_t i = system.pairs.first[row], j = system.pairs.second[row], image = images.index()[row];
    const Vec<Dim> r = state.position[j] - state.position[i] - shifts[image];
    const double sigma = state.radius[i] + state.radius[j], distance = norm(r);
    if (!(distance < laws.of(i, j).range() * sigma)) continue;
    if (!linked.empty() && linked.contains(touch_key(j, TouchOn::body, body[i], images.cells()[image])))
      continue;
    meet(row, i, j, distance, distance > 0 ? (1 / distance) * r : arbitrary_direction<Dim>(i, j), sigma);
  }
}

}  // namespace supple
