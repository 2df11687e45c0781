#include "supple/experiment/frame.hpp"

#include <algorithm>
#include <map>
#include <numbers>
#include <tuple>
#include <utility>

#include "supple/model/body_links.hpp"
#include "supple/model/links.hpp"
#include "supple/observe/contact_network.hpp"

namespace supple {

namespace {

constexpr char axes[] = {'x', 'y', 'z'};

/// visit("_xy", i, j) for each component of a tensor.
template <int Dim, class Visit>
void for_each_component(Visit&& visit) {
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j < Dim; ++j) visit(std::string{'_', axes[i], axes[j]}, i, j);
}

/// All but the contacts and the numbers of bodies.
template <int Dim>
Frame<Dim> frame_of_sites(const System<Dim>& system, const Evaluation<Dim>& evaluation) {
  const State<Dim>& s = system.state;
  Frame<Dim> frame;
  frame.step = system.step;
  frame.time = system.time;
  frame.strain = system.box.strain;
  frame.strain_rate = system.box.strain_rate;
  frame.position = s.position;
  frame.velocity = s.velocity;
  frame.force = evaluation.force;
  frame.angle = s.angle;
  frame.spin = s.spin;
  frame.torque = evaluation.torque;
  frame.mobility = s.mobility;
  frame.length = system.box.length;
  return frame;
}

/// Two corners that meet head on act on each other's edges: one contact.
template <int Dim>
void join(ContactRow<Dim>& row, const ContactRow<Dim>& other) {
  row.normal_force += other.normal_force;
  row.tangential_force += other.tangential_force;
  row.elastic += other.elastic;
  row.viscous += other.viscous;
  row.force += other.force;
}

}  // namespace

Frame<2> make_frame(const System<2>& system, const Evaluation<2>& evaluation) {
  const PairTable& pairs = system.pairs;
  Frame<2> frame = frame_of_sites(system, evaluation);
  std::vector<Mat2> stress(system.state.position.size());
  const auto add_to_discs = [&](const PairForce<2>& p, std::int32_t i, std::int32_t j) {
    const Vec2 force = force_on_first(p), from_second = -p.distance * p.normal;
    for (const std::int32_t disc : {i, j}) {
      const double radius = system.state.radius[disc];
      stress[disc].add_outer(0.5 / (std::numbers::pi * radius * radius), force, from_second);
    }
  };
  for (int row = 0; row < pairs.size(); ++row) {
    if (evaluation.trial_state[row] == ContactState::open) continue;
    const PairForce<2>& p = evaluation.pair[row];
    add_to_discs(p, pairs.first[row], pairs.second[row]);
    const double* u = &evaluation.trial_history[static_cast<std::size_t>(row) * pairs.width];
    frame.contacts.push_back({pairs.first[row], pairs.second[row], evaluation.trial_state[row], u[0],
                              u[pairs.width - 1], p.elastic + p.viscous, p.tangential, p.elastic, p.viscous,
                              force_on_first(p)});
  }
  add_stresses(frame.body, stress);
  return frame;
}

namespace {

/// What friction and viscosity add to the contacts of bodies.
class Rubbing {
 public:
  explicit Rubbing(const Evaluation<2>& evaluation) {
    for (const Touch& touch : evaluation.trial_touch) touch_[name(touch.key)] = &touch;
    for (const TouchForce& force : evaluation.touch_force) force_[name(force.key)] = &force;
  }

  /// Adds it to the row of a contact between a site and another one of that body.
  void add_to(ContactRow<2>& row, const SiteContact<2>& c) const {
    for (const auto& [on, other] :
         {std::pair(TouchOn::site, c.other), std::pair(TouchOn::body, c.other_body)}) {
      const auto touch = touch_.find({c.site, on, other});
      const auto force = force_.find({c.site, on, other});
      if (touch == touch_.end() || force == force_.end()) continue;
      const double size = norm(c.force);
      const Vec2 n = (1 / size) * c.force;
      const Vec2 added = force->second->viscous * n - force->second->tangential * turned_left(n);
      row.state = touch->second->state;
      row.elongation = row.elongation_back = touch->second->elongation;
      row.viscous = force->second->viscous;
      row.normal_force += row.viscous;
      // t turns with n, and the force is on the other side: the number is the same for first and second.
      row.tangential_force = force->second->tangential;
      row.force += c.site == row.first ? added : -added;
      return;
    }
  }

 private:
  using Name = std::tuple<std::int32_t, TouchOn, std::int32_t>;
  static Name name(const TouchKey& key) { return {key.site, key.on, key.other}; }
  std::map<Name, const Touch*> touch_;
  std::map<Name, const TouchForce*> force_;
};

void append_links(const System<2>& system, const Evaluation<2>& evaluation,
                  std::vector<ContactRow<2>>& rows) {
  for (std::size_t k = 0; k < evaluation.link_force.size(); ++k) {
    const Link& link = system.links[k];
    const LinkForce& f = evaluation.link_force[k];
    Vec2 n = link_vector(system, link);
    if (const double d = norm(n); d > 0) n = (1 / d) * n;
    const double normal = f.elastic + f.viscous, u = evaluation.trial_link[k];
    rows.push_back({link.first, link.second, ContactState::permanent, u, u, normal, f.tangential, f.elastic,
                    f.viscous, -normal * n + f.tangential * turned_left(n)});
  }
}

/// What friction and viscosity add to the rows, one for each of these contacts, and the rows of links.
void add_what_rubs(const System<2>& system, const Evaluation<2>& evaluation,
                   const std::vector<SiteContact<2>>& contacts, std::vector<ContactRow<2>>& rows) {
  const Rubbing rubbing(evaluation);
  for (std::size_t k = 0; k < contacts.size(); ++k) rubbing.add_to(rows[k], contacts[k]);
  append_links(system, evaluation, rows);
}

}  // namespace

template <int Dim>
Frame<Dim> make_frame(const System<Dim>& system, const Evaluation<Dim>& evaluation,
                      const std::vector<ContactRecord<Dim>>& records, const ContactLaws& laws) {
  Frame<Dim> frame = frame_of_sites(system, evaluation);
  std::vector<ContactRow<Dim>>& rows = frame.contacts;
  const std::vector<SiteContact<Dim>> contacts = site_contacts(system, records, laws);
  for (const SiteContact<Dim>& c : contacts)
    rows.push_back({std::min(c.site, c.other), std::max(c.site, c.other), ContactState::slip, 0, 0,
                    c.normal_force(), 0, c.normal_force(), 0, c.site < c.other ? c.force : -1 * c.force});
  if constexpr (Dim == 2) add_what_rubs(system, evaluation, contacts, rows);
  const auto pair = [](const ContactRow<Dim>& row) { return std::pair(row.first, row.second); };
  std::stable_sort(rows.begin(), rows.end(), [&](const auto& a, const auto& b) { return pair(a) < pair(b); });
  std::size_t kept = 0;
  for (std::size_t k = 1; k < rows.size(); ++k)
    if (pair(rows[k]) == pair(rows[kept])) join(rows[kept], rows[k]);
    else rows[++kept] = rows[k];
  if (!rows.empty()) rows.resize(kept + 1);
  return frame;
}

template <int Dim>
void add_stresses(BodyNumbers& numbers, const std::vector<Mat<Dim>>& stress) {
  for_each_component<Dim>([&](const std::string& component, int i, int j) {
    for (const Mat<Dim>& s : stress) numbers["stress" + component].push_back(s[i][j]);
  });
}

template <int Dim>
void add_tensor(SystemNumbers& numbers, const std::string& name, const Mat<Dim>& tensor) {
  for_each_component<Dim>(
      [&](const std::string& component, int i, int j) { numbers[name + component] = tensor[i][j]; });
}

namespace {

/// The particle of each site: crosslinked particle of a disc, body of a vertex.
template <int Dim>
std::vector<std::int32_t> particles_of(const System<Dim>& system) {
  if constexpr (Dim == 2)
    if (system.topology.begin.empty()) return connected_particles(system, LinkKind::all);
  return bodies_of_sites(system.topology, system.state.size());
}

}  // namespace

template <int Dim>
RunInfo<Dim> make_run_info(const System<Dim>& system, const Units& units) {
  const State<Dim>& s = system.state;
  RunInfo<Dim> info{
      units, system.box, s.radius, s.mass, s.inertia, particles_of(system), system.topology.begin,
      {},    {},         {}};
  if constexpr (Dim == 3) info.facet = system.topology.facet;
  if (system.solid.empty()) return info;
  for (int b = 0; b < system.topology.body_count(s.size()); ++b)
    info.boundary_sites.push_back(system.topology.boundary_size(b));
  info.bond = system.solid.bond;
  return info;
}

template Frame<2> make_frame(const System<2>&, const Evaluation<2>&, const std::vector<ContactRecord<2>>&,
                             const ContactLaws&);
template void add_stresses<2>(BodyNumbers&, const std::vector<Mat2>&);
template void add_tensor<2>(SystemNumbers&, const std::string&, const Mat2&);
template RunInfo<2> make_run_info(const System<2>&, const Units&);
template Frame<3> make_frame(const System<3>&, const Evaluation<3>&, const std::vector<ContactRecord<3>>&,
                             const ContactLaws&);
template void add_stresses<3>(BodyNumbers&, const std::vector<Mat<3>>&);
template void add_tensor<3>(SystemNumbers&, const std::string&, const Mat<3>&);
template RunInfo<3> make_run_info(const System<3>&, const Units&);

}  // namespace supple
