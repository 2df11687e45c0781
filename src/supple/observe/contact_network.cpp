#include "supple/observe/contact_network.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "supple/model/rigid.hpp"

namespace supple {

namespace {

/// The site of negative weight that bears the largest share of a record of the touch.
template <int Dim>
std::int32_t main_site(const std::vector<ContactRecord<Dim>>& records, const BodyTouch<Dim>& touch,
                       const ContactLaws& laws) {
  std::int32_t site = -1;
  double largest = -1;
  for (std::int32_t r = touch.first_record; r < touch.first_record + touch.records; ++r) {
    const ContactRecord<Dim>& record = records[r];
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
template <int Dim>
Vec<Dim> shift_of(const System<Dim>& system, const ContactRecord<Dim>& record) {
  Vec<Dim> stored{};
  for (int k = 0; k < record.sites; ++k) stored += record.weight[k] * system.state.position[record.site[k]];
  return stored - record.branch;
}

/// The pair of a contact, with the cells between its bodies.
template <int Dim>
ContactNetwork::Pair pair_of(const Box<Dim>& box, const SiteContact<Dim>& c) {
  const bool turned = c.body > c.other_body;
  const Vec<Dim> shift = turned ? -c.shift : c.shift;
  const auto cells = [&](int d, double length) {
    return box.periodic[d] ? static_cast<std::int32_t>(std::lround(length / box.length[d])) : 0;
  };
  const std::int32_t up = cells(gradient, shift[gradient]);
  const std::int32_t across = cells(flow, shift[flow] - up * box.lattice().shift);
  const std::int32_t along = Dim == 3 ? cells(Dim - 1, shift[Dim - 1]) : 0;
  return {turned ? c.other_body : c.body, turned ? c.body : c.other_body, across, up, along, 1};
}

bool counts(std::span<const std::uint8_t> left_out, std::int32_t body) {
  return left_out.empty() || left_out[body] == 0;
}

/// Which wall pushes with this force: 0 and 1 along the flow, 2 and 3 along the gradient, 4 and 5 along the
/// vorticity. A wall beside pushes straight.
template <int Dim>
int wall_of(const SiteForce<Dim>& wall) {
  const int d = direction_of(wall);
  return 2 * d + (wall.force[d] > 0 ? 0 : 1);
}

}  // namespace

template <int Dim>
std::vector<SiteContact<Dim>> site_contacts(const System<Dim>& system,
                                            const std::vector<ContactRecord<Dim>>& records,
                                            const ContactLaws& laws) {
  const std::vector<std::int32_t> body = bodies_of_sites(system.topology, system.state.size());
  std::vector<SiteContact<Dim>> contacts;
  for (const BodyTouch<Dim>& touch : sum_touches(system, records, laws))
    contacts.push_back({touch.site, main_site(records, touch, laws), body[touch.site], touch.body,
                        touch.force, shift_of(system, records[touch.first_record]), touch.normal_force() < 0,
                        laws.of(records[touch.first_record].species).attracts()});
  return contacts;
}

template <int Dim>
double mean_overlap(const System<Dim>& system, const std::vector<ContactRecord<Dim>>& records,
                    const ContactLaws& laws) {
  const std::vector<BodyTouch<Dim>> touches = sum_touches(system, records, laws);
  double sum = 0;
  for (const BodyTouch<Dim>& touch : touches) {
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

template <int Dim>
ContactNetwork contact_network(const System<Dim>& system, const std::vector<SiteContact<Dim>>& contacts,
                               std::type_identity_t<std::span<const SiteForce<Dim>>> wall) {
  ContactNetwork network;
  const int sites = system.state.size();
  network.walls.assign(static_cast<std::size_t>(system.topology.body_count(sites)), 0);
  for (const SiteContact<Dim>& c : contacts) network.pairs.push_back(pair_of(system.box, c));
  const auto key = [](const ContactNetwork::Pair& p) {
    return std::tuple(p.first, p.second, p.across, p.up, p.along);
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
  for (const SiteForce<Dim>& w : wall) touched.emplace_back(body[w.site], wall_of(w));
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

template <int Dim>
ConstraintCount count_constraints(const System<Dim>& system, const std::vector<SiteContact<Dim>>& contacts,
                                  std::span<const std::uint8_t> left_out,
                                  std::type_identity_t<std::span<const SiteForce<Dim>>> wall) {
  ConstraintCount out;
  const int sites = system.state.size();
  const std::vector<std::int32_t> body = bodies_of_sites(system.topology, sites);
  for (int d = 0; d < Dim; ++d) out.translations += system.box.periodic[d];
  for (int b = 0; b < system.topology.body_count(sites); ++b) {
    if (!counts(left_out, b)) continue;
    if (const int r = rigid_index(system, b); r >= 0) {
      out.freedoms += held(system, r) ? 0 : rigid_numbers<Dim>;
      continue;
    }
    const int n = system.topology.body_size(b);
    for (std::int32_t i = system.topology.body_begin(b); i < system.topology.body_end(b); ++i)
      out.freedoms += system.state.mobility[i] == Mobility::free ? Dim : 0;
    if (n < 3 || system.shape.empty()) continue;
    if (system.solid.fills(b)) {
      out.shape += Dim == 2 ? 2 * n - 3 : 3 * n - 6;
      continue;
    }
    const ShapeStiffness& k = system.shape.stiffness[b];
    const int facets = system.topology.facet_begin[b + 1] - system.topology.facet_begin[b];
    const int deformations = Dim == 2 ? 2 * n - 3 : 3 * n - 6,
              stiff = (k.volume > 0) + (k.facet > 0 ? facets : 0);
    out.shape += k.hinge > 0 || k.tension > 0 ? deformations : std::min(stiff, deformations);
  }
  for (const SiteContact<Dim>& c : contacts)
    out.contacts += counts(left_out, c.body) && counts(left_out, c.other_body);
  for (const SiteForce<Dim>& w : wall) out.contacts += counts(left_out, body[w.site]);
  return out;
}

template std::vector<SiteContact<2>> site_contacts(const System<2>&, const std::vector<ContactRecord<2>>&,
                                                   const ContactLaws&);
template double mean_overlap(const System<2>&, const std::vector<ContactRecord<2>>&, const ContactLaws&);
template ContactNetwork contact_network(const System<2>&, const std::vector<SiteContact<2>>&,
                                        std::span<const SiteForce<2>>);
template ConstraintCount count_constraints(const System<2>&, const std::vector<SiteContact<2>>&,
                                           std::span<const std::uint8_t>, std::span<const SiteForce<2>>);
template std::vector<SiteContact<3>> site_contacts(const System<3>&, const std::vector<ContactRecord<3>>&,
                                                   const ContactLaws&);
template double mean_overlap(const System<3>&, const std::vector<ContactRecord<3>>&, const ContactLaws&);
template ContactNetwork contact_network(const System<3>&, const std::vector<SiteContact<3>>&,
                                        std::span<const SiteForce<3>>);
template ConstraintCount count_constraints(const System<3>&, const std::vector<SiteContact<3>>&,
                                           std::span<const std::uint8_t>, std::span<const SiteForce<3>>);

}  // namespace supple
