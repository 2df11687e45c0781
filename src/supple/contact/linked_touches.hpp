/// Contacts that do not act because the pair is linked.
#pragma once
#include <algorithm>
#include <vector>

#include "supple/contact/reach.hpp"
#include "supple/model/ring.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// The keys of contacts that links replace. Rough: the contact of the two linked sites. Smooth: the contacts
/// of either site with the body of the other. Only contacts with the image of the link are among them. The
/// list is short and made anew at every evaluation.
template <int Dim>
class LinkedTouches {
 public:
  void update(const System<Dim>& system, Meeting meeting);
  bool empty() const { return keys_.empty(); }
  bool contains(const TouchKey& key) const { return std::binary_search(keys_.begin(), keys_.end(), key); }

 private:
  std::vector<TouchKey> keys_;
};

/// The key of the contact about x_site - x_other - n, n the lattice vector of `cells`.
template <int Dim>
TouchKey touch_key(std::int32_t site, TouchOn on, std::int32_t other, const Vec<Dim>& cells) {
  TouchKey key{site, other, on, {}};
  for (int d = 0; d < Dim; ++d) key.cells[static_cast<std::size_t>(d)] = static_cast<std::int32_t>(cells[d]);
  return key;
}

}  // namespace supple
