#include "supple/model/body_links.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "supple/core/disjoint_sets.hpp"
#include "supple/model/bodies.hpp"

namespace supple {

namespace {

using BodyPair = std::pair<std::int32_t, std::int32_t>;

BodyPair bodies_of(const TouchingSites& t, const std::vector<std::int32_t>& body) {
  return std::minmax(body[t.first], body[t.second]);
}

/// Each body as the disc that encloses it, with a row for each pair of bodies that touch.
System<2> bodies_as_discs(const System<2>& system, const std::vector<TouchingSites>& touching,
                          const std::vector<std::int32_t>& body) {
  System<2> discs;
  discs.box = system.box;
  const int count = system.topology.body_count(system.state.size());
  discs.state.resize(count);
  for (int b = 0; b < count; ++b) {
    discs.state.position[b] = body_centre(system, b);
    discs.box.lattice().wrap(discs.state.position[b]);
    discs.state.radius[b] = outer_radius(system, b);
    discs.state.mass[b] = discs.state.inertia[b] = 1;
  }
  index_rows(discs.pairs, count);
  for (const TouchingSites& t : touching) {
    const auto [a, b] = bodies_of(t, body);
    if (discs.pairs.find(a, b) < 0) set_pair_state(discs.pairs, count, a, b, ContactState::slip);
  }
  return discs;
}

}  // namespace

CrosslinkReport link_bodies(System<2>& system, std::vector<TouchingSites> touching, const CrosslinkSpec& spec,
                            std::uint64_t seed) {
  for (TouchingSites& t : touching) {
    if (t.first < t.second) continue;
    std::swap(t.first, t.second);
    for (std::int32_t& n : t.cells) n = -n;
  }
  std::sort(touching.begin(), touching.end());
  touching.erase(std::unique(touching.begin(), touching.end()), touching.end());
  const std::vector<std::int32_t> body = bodies_of_sites(system.topology, system.state.size());
  System<2> discs = bodies_as_discs(system, touching, body);
  CrosslinkReport report = crosslink(discs, spec, seed);
  system.links.clear();
  for (const TouchingSites& t : touching) {
    const auto [a, b] = bodies_of(t, body);
    if (discs.pairs.state[discs.pairs.find(a, b)] != ContactState::permanent) continue;
    Link& link = system.links.emplace_back(Link{t.first, t.second, t.cells});
    link.rest = norm(link_vector(system, link));
  }
  report.links = static_cast<int>(system.links.size());
  return report;
}

Vec2 link_vector(const System<2>& system, const Link& link) {
  Vec2 r = system.state.position[link.second] - system.state.position[link.first];
  system.box.lattice().subtract({1.0 * link.cells[0], 1.0 * link.cells[1]}, r);
  return r;
}

std::vector<std::int32_t> linked_clusters(const System<2>& system) {
  const int bodies = system.topology.body_count(system.state.size());
  const std::vector<std::int32_t> body = bodies_of_sites(system.topology, system.state.size());
  DisjointSets sets(bodies);
  for (const Link& link : system.links) sets.merge(body[link.first], body[link.second]);
  std::vector<std::int32_t> cluster(static_cast<std::size_t>(bodies));
  std::map<std::int32_t, std::int32_t> number;
  for (int b = 0; b < bodies; ++b)
    cluster[b] = number.try_emplace(sets.root(b), static_cast<std::int32_t>(number.size())).first->second;
  return cluster;
}

}  // namespace supple
