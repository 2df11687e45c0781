#include "supple/observe/contact_network.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace supple {

namespace {

/// The site of a side of the record (the side of `weight`'s sign) with the largest share.
std::int32_t main_site(const ContactRecord<2>& record, bool positive) {
  std::int32_t site = -1;
  double largest = 0;
  for (int k = 0; k < record.sites; ++k) {
    const double weight = positive ? record.weight[k] : -record.weight[k];
    if (weight > largest) largest = weight, site = record.site[k];
  }
  return site;
}

bool counts(std::span<const std::uint8_t> left_out, std::int32_t body) {
  return left_out.empty() || left_out[body] == 0;
}

/// Which wall pushes with this force: 0 and 1 along the flow, 2 and 3 along the gradient. A wall beside pushes
/// straight.
int wall_of(const SiteForce<2>& wall) {
  const int d = wall.force[gradient] != 0 ? gradient : flow;
  return 2 * d + (wall.force[d] > 0 ? 0 : 1);
}

}  // namespace

std::vector<SiteContact> site_contacts(const System<2>& system, const std::vector<ContactRecord<2>>& records,
                                       const Harmonic& law) {
  const std::vector<std::int32_t> body = bodies_of_sites(system.topology, system.state.size());
  std::map<std::tuple<std::int32_t, std::int32_t, std::int32_t>, std::size_t> known;
  std::vector<SiteContact> contacts;
  std::vector<double> strongest;
  for (const ContactRecord<2>& record : records) {
    // The site that acts stands first; the other side is a site, or a facet.
    const std::int32_t site = record.site[0];
    const bool positive = record.weight[0] > 0;
    const std::int32_t other = main_site(record, !positive);
    const bool pair_of_sites = record.sites == 2 && record.multiplicity == 1;
    const auto [at, is_new] = known.try_emplace({site, body[other], pair_of_sites ? other : -1}, contacts.size());
    if (is_new) {
      contacts.push_back({site, other, body[site], body[other], {}});
      strongest.push_back(0);
    }
    SiteContact& contact = contacts[at->second];
    const double force = record.multiplicity * law.force(record.distance(), record.reach);
    contact.force += (positive ? force : -force) * record.normal;
    if (force > strongest[at->second]) strongest[at->second] = force, contact.other = other;
  }
  return contacts;
}

std::vector<std::int32_t> ContactNetwork::contacts_of_bodies() const {
  std::vector<std::int32_t> count = walls;
  for (const Pair& pair : pairs) ++count[pair.first], ++count[pair.second];
  return count;
}

ContactNetwork contact_network(const System<2>& system, const std::vector<SiteContact>& contacts,
                               std::span<const SiteForce<2>> wall) {
  ContactNetwork network;
  const int sites = system.state.size();
  network.walls.assign(static_cast<std::size_t>(system.topology.body_count(sites)), 0);
  for (const SiteContact& c : contacts)
    network.pairs.push_back({std::min(c.body, c.other_body), std::max(c.body, c.other_body), 1});
  const auto key = [](const ContactNetwork::Pair& p) { return std::pair(p.first, p.second); };
  std::sort(network.pairs.begin(), network.pairs.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
  std::size_t last = 0;
  for (std::size_t k = 1; k < network.pairs.size(); ++k)
    if (key(network.pairs[k]) == key(network.pairs[last])) ++network.pairs[last].site_contacts;
    else network.pairs[++last] = network.pairs[k];
  if (!network.pairs.empty()) network.pairs.resize(last + 1);

  const std::vector<std::int32_t> body = bodies_of_sites(system.topology, sites);
  std::vector<std::pair<std::int32_t, int>> touched;
  for (const SiteForce<2>& w : wall) touched.emplace_back(body[w.site], wall_of(w));
  std::sort(touched.begin(), touched.end());
  touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
  for (const auto& [b, which] : touched) ++network.walls[b];
  return network;
}

std::vector<std::uint8_t> find_rattlers(const ContactNetwork& network, int least) {
  std::vector<std::uint8_t> rattler(static_cast<std::size_t>(network.bodies()), 0);
  std::vector<std::int32_t> count = network.contacts_of_bodies();
  for (bool removed = true; removed;) {
    removed = false;
    for (int b = 0; b < network.bodies(); ++b)
      if (!rattler[b] && count[b] < least) {
        rattler[b] = 1;
        removed = true;
      }
    if (!removed) break;
    count = network.walls;
    for (const ContactNetwork::Pair& p : network.pairs)
      if (!rattler[p.first] && !rattler[p.second]) ++count[p.first], ++count[p.second];
  }
  return rattler;
}

ContactNumbers count_contacts(const ContactNetwork& network, std::span<const std::uint8_t> left_out) {
  ContactNumbers numbers;
  for (int b = 0; b < network.bodies(); ++b) {
    if (!counts(left_out, b)) continue;
    ++numbers.bodies;
    numbers.walls += network.walls[b];
  }
  for (const ContactNetwork::Pair& p : network.pairs) {
    if (!counts(left_out, p.first) || !counts(left_out, p.second)) continue;
    ++numbers.pairs;
    numbers.site_contacts += p.site_contacts;
  }
  return numbers;
}

ConstraintCount count_constraints(const System<2>& system, const std::vector<SiteContact>& contacts,
                                  std::span<const std::uint8_t> left_out, std::span<const SiteForce<2>> wall) {
  ConstraintCount out;
  const int sites = system.state.size();
  const std::vector<std::int32_t> body = bodies_of_sites(system.topology, sites);
  for (int d = 0; d < 2; ++d) out.translations += system.box.periodic[d];
  for (int b = 0; b < system.topology.body_count(sites); ++b) {
    if (!counts(left_out, b)) continue;
    const int n = system.topology.body_size(b);
    out.freedoms += 2 * n;
    if (n < 3 || system.shape.empty()) continue;
    const ShapeStiffness& k = system.shape.stiffness[b];
    const int deformations = 2 * n - 3, stiff = (k.volume > 0) + (k.facet > 0 ? n : 0);
    out.shape += k.hinge > 0 || k.tension > 0 ? deformations : std::min(stiff, deformations);
  }
  for (const SiteContact& c : contacts) out.contacts += counts(left_out, c.body) && counts(left_out, c.other_body);
  for (const SiteForce<2>& w : wall) out.contacts += counts(left_out, body[w.site]);
  return out;
}

}  // namespace supple
