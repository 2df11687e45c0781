#include "supple/contact/linked_touches.hpp"

namespace supple {

template <int Dim>
void LinkedTouches<Dim>::update(const System<Dim>& system, Meeting meeting) {
  keys_.clear();
  if (system.links.empty()) return;
  std::vector<std::int32_t> body;
  if (meeting == Meeting::facets) body = bodies_of_sites(system.topology, system.state.size());
  const auto on = meeting == Meeting::facets ? TouchOn::body : TouchOn::site;
  const auto other = [&](std::int32_t site) { return on == TouchOn::body ? body[site] : site; };
  for (const Link& link : system.links) {
    const auto& n = link.cells;
    keys_.push_back({link.second, other(link.first), on, n});
    keys_.push_back({link.first, other(link.second), on, {-n[0], -n[1], -n[2]}});
  }
  std::sort(keys_.begin(), keys_.end());
}

template class LinkedTouches<2>;
template class LinkedTouches<3>;

}  // namespace supple
