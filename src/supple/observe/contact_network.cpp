#include "supple/observe/contact_network.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "supple/model/rigid.hpp"

namespace supple {

namespace {

/// The site of negative weight that bears the largest share of a record of the touch.
std::int32_t main_site(const std::vector<ContactRecord<2>>& records, const BodyTouch<2>& touch,
                       const ContactLaws& laws) {
  std::int32_t site = -1;
  double largest = -1;
  for (std::int32_t r = touch.first_record; r < touch.first_record + touch.records; ++r) {
    const ContactRecord<2>& record = records[r];
    const BodyLaw& law = laws.of(record.species);
    const double force = std::abs(record.multiplicity * law.force(record.distance(), record.reach));
    for (int k = 0; k < record.sites; ++k)
      if (const double weight = -record.weight[k]; weight > 0 && weight * force > largest) {
        largest = weight * force;
        site = record.site[k];
      }
  }
  return site;
}

/// Displacement from the sites of negative weight as they are stored to the copy that the record is with. The
/// branch of the record is the sum of weight times position over the images that meet.
Vec2 shift_of(const System<2>& system, const ContactRecord<2>& record) {
  Vec2 stored{};
  for (int k = 0; k < record.sites; ++k) stored += record.weight[k] * system.state.position[record.site[k]];
  return stored - record.branch;
}

/// The pair of a contact, with the cells between its bodies.
ContactNetwork::Pair pair_of(const Box<2>& box, const SiteContact& c) {
  const bool turned = c.body > c.other_body;
  const Vec2 shift = turned ? -c.shift : c.shift;
  const auto cells = [&](int d, double length) {
    return box.periodic[d] ? static_cast<std::int32_t>(std::lround(length / box.length[d])) : 0;
  };
  const std::int32_t up = cells(gradient, shift[gradient]);
  const std::int32_t across = cells(flow, shift[flow] - up * box.lattice().shift);
  return {turned ? c.other_body : c.body, turned ? c.body : c.other_body, across, up, 1};
}

bool counts(std::span<const std::uint8_t> left_out, std::int32_t body) {
  return left_out.empty() || left_out[body] == 0;
}

/// Which wall pushes with this force: 0 and 1 along the flow, 2 and 3 along the gradient. A wall beside
/// pushes straight.
int wall_of(const SiteForce<2>& wall) {
  const int d = wall.force[gradient] != 0 ? gradient : flow;
  return 2 * d + (wall.force[d] > 0 ? 0 : 1);
}

}  // namespace

std::vector<SiteContact> site_contacts(const System<2>& system, const std::vector<ContactRecord<2>>& records,
                                       const ContactLaws& laws) {
  const std::vector<std::int32_t> body = bodies_of_sites(system.topology, system.state.size());
  std::vector<SiteContact> contacts;
  for (const BodyTouch<2>& touch : sum_touches(system, records, laws))
    contacts.push_back({touch.site, main_site(records, touch, laws), body[touch.site], touch.body,
                        touch.force, shift_of(system, records[touch.first_record]), touch.normal_force() < 0,
                        laws.of(records[touch.first_record].species).attracts()});
  return contacts;
}

double mean_overlap(const System<2>& system, const std::vector<ContactRecord<2>>& records,
                    const ContactLaws& laws) {
  const std::vector<BodyTouch<2>> touches = sum_touches(system, records, laws);
  double sum = 0;
  for (const BodyTouch<2>& touch : touches) {
    double depth =
        0;  // a corner that is taken back (weight -1) is never nearer than the edges that end there
    for (std::int32_t r = touch.first_record; r < touch.first_record + touch.records; ++r)
      depth = std::max(depth, -records[r].gap / records[r].reach);
    sum += depth;
  }
  return touches.empty() ? 0 : sum / static_cast<double>(touches.size());
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
  for (const SiteContact& c : contacts) network.pairs.push_back(pair_of(system.box, c));
  const auto key = [](const ContactNetwork::Pair& p) {
    return std::tuple(p.first, p.second, p.across, p.up);
  };
  std::sort(network.pairs.begin(), network.pairs.end(),
            [&](const auto& a, const auto& b) { return key(a) < key(b); });
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
                                  std::span<const std::uint8_t> left_out,
                                  std::span<const SiteForce<2>> wall) {
  ConstraintCount out;
  const int sites = system.state.size();
  const std::vector<std::int32_t> body = bodies_of_sites(system.topology, sites);
  for (int d = 0; d < 2; ++d) out.translations += system.box.periodic[d];
  const std::vector<std::int32_t>& rigid = system.rigid.body;
  for (int b = 0; b < system.topology.body_count(sites); ++b) {
    if (!counts(left_out, b)) continue;
    if (const auto r = std::lower_bound(rigid.begin(), rigid.end(), b); r != rigid.end() && *r == b) {
      out.freedoms += held(system, static_cast<int>(r - rigid.begin())) ? 0 : 3;
      continue;
    }
    const int n = system.topology.body_size(b);
    for (std::int32_t i = system.topology.body_begin(b); i < system.topology.body_end(b); ++i)
      out.freedoms += system.state.mobility[i] == Mobility::free ? 2 : 0;
    if (n < 3 || system.shape.empty()) continue;
    const ShapeStiffness& k = system.shape.stiffness[b];
    const int deformations = 2 * n - 3, stiff = (k.volume > 0) + (k.facet > 0 ? n : 0);
    out.shape += k.hinge > 0 || k.tension > 0 ? deformations : std::min(stiff, deformations);
  }
  for (const SiteContact& c : contacts)
    out.contacts += counts(left_out, c.body) && counts(left_out, c.other_body);
  for (const SiteForce<2>& w : wall) out.contacts += counts(left_out, body[w.site]);
  return out;
}

}  // namespace supple
