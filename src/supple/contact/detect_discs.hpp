/// Contacts of discs (spheres in 3D), from the pair table.
#pragma once
#include <vector>

#include "supple/contact/coincident.hpp"
#include "supple/contact/record.hpp"
#include "supple/model/row_separation.hpp"

namespace supple {

/// The contact of the two discs of a row, whatever their distance. The arms share the distance d in
/// proportion to the radii (S1-3): both end at one point on the line of centres, so that angular momentum is
/// conserved at any compression or stretch.
template <int Dim>
ContactRecord<Dim> disc_contact(const System<Dim>& system, std::int32_t row) {
  const State<Dim>& state = system.state;
  const std::int32_t i = system.pairs.first[row], j = system.pairs.second[row];
  const auto separation = row_separation(system, row);
  const double d = norm(separation.r);

  ContactRecord<Dim> record;
  record.normal = d > 0 ? (1 / d) * separation.r : arbitrary_direction<Dim>(i, j);
  record.branch = separation.r;
  record.reach = state.radius[i] + state.radius[j];
  record.gap = d - record.reach;
  record.row = row;
  record.up = separation.up;
  record.crosses = separation.crosses;
  const double share = d / record.reach;
  record.add(i, -1, share * state.radius[i] * record.normal);
  record.add(j, +1, -share * state.radius[j] * record.normal);
  return record;
}

/// A record for each row that touches (d < range d0) or is linked, in the order of the pair table.
template <int Dim>
std::vector<ContactRecord<Dim>> detect_discs(const System<Dim>& system, double range = 1) {
  std::vector<ContactRecord<Dim>> records;
  for (std::int32_t row = 0; row < system.pairs.size(); ++row) {
    const ContactRecord<Dim> record = disc_contact(system, row);
    if (record.distance() < range * record.reach || system.pairs.state[row] == ContactState::permanent)
      records.push_back(record);
  }
  return records;
}

}  // namespace supple
