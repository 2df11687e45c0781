#include "supple/experiment/body_rheology.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "supple/contact/link_forces.hpp"
#include "supple/contact/touch_friction.hpp"
#include "supple/experiment/suspension.hpp"
#include "supple/model/body_links.hpp"
#include "supple/solve/time_step.hpp"

namespace supple {

namespace {

double mean(const std::vector<double>& x) {
  return std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(x.size());
}

/// Sites that touch: the one of a record, and of the others that which bears most of it.
TouchingSites touching_sites(const ContactRecord<2>& record) {
  int on = 0, other = -1;
  for (int k = 0; k < record.sites; ++k) {
    if (record.weight[k] > 0) on = k;
    else if (other < 0 || record.weight[k] < record.weight[other]) other = k;
  }
  TouchingSites pair{record.site[other], record.site[on], {}};
  for (std::size_t d = 0; d < record.cells.size(); ++d) pair.cells[d] = record.cells[d];
  return pair;
}

/// Share of the stability limit that is used.
constexpr double step_share = 0.1;
constexpr double neighbours = 6;

}  // namespace

BodyLaws body_laws(const Case& c, const Packing<2>& packing) {
  const State<2>& s = packing.system.state;
  const Material& m = c.material;
  const ContactLaws& contacts = packing.field->bodies()->laws();
  const double sigma = 2 * mean(s.radius);
  BodyLaws laws;
  laws.k = contacts.common().spring(sigma);
  laws.mass = mean(s.mass);
  const double body_mass = laws.mass * s.size() / packing.system.topology.body_count(s.size());
  laws.tau = std::sqrt(body_mass / laws.k);

  const double ratio = m.relative_transversal_link_strength;
  const auto touch_of = [&](double k, double friction, double relative_viscosity) {
    TouchLaw touch;
    touch.friction = friction;
    touch.k_t = friction > 0 ? tangential_stiffness(ratio, k) : 0;
    touch.eta = viscosity(relative_viscosity, laws.mass, k);
    touch.eta_t = ratio * touch.eta;
    touch.slip = m.slip == "freeze" ? Slip::freeze : m.slip == "reset" ? Slip::reset : Slip::clamp;
    return touch;
  };
  const double central = 1 / m.interface_reenforcement_central,
               tangential = 1 / m.interface_reenforcement_tangential;
  const bool keep = m.keep_viscosity_coefficients_constant;
  const auto link_of = [&](double k, const TouchLaw& touch) {
    return LinkLaw{k * central, touch.eta * (keep ? 1 : central), ratio * k * tangential,
                   touch.eta_t * (keep ? 1 : tangential)};
  };
  const TouchLaw common = touch_of(laws.k, m.friction, m.relative_viscosity);
  laws.touch = common;
  laws.link = link_of(laws.k, common);
  for (const PairOfSpecies& pair : pairs_of(c)) {
    const double k = contacts.of(pair.first, pair.second).spring(sigma);
    const TouchLaw touch = touch_of(k, pair.contact.friction, pair.contact.relative_viscosity);
    laws.touch.set(pair.first, pair.second, touch);
    laws.link.set(pair.first, pair.second, link_of(k, touch));
    laws.pairs.emplace_back(pair, k);
  }
  return laws;
}

namespace {

/// Of contacts and links under one of the laws; names end in `of`.
void append_laws(const std::string& of, const std::string& between, double k, const TouchLaw& t,
                 const LinkLaw& l, std::vector<Derived>& all) {
  const auto add = [&](const char* name, const std::string& meaning, double value) {
    all.push_back({{name + of, "", meaning + between}, value});
  };
  add("friction", "Coulomb coefficient mu", t.friction);
  add("spring_constant", "k of a contact of two vertices of mean size", k);
  add("tangential_spring_constant", "k_t of contacts", t.k_t);
  add("viscosity", "eta of contacts, relative_viscosity sqrt(mean_mass k)", t.eta);
  add("tangential_viscosity", "eta_t of contacts", t.eta_t);
  add("link_spring_constant", "k of permanent links", l.k);
  add("link_tangential_spring_constant", "k_t of permanent links", l.k_t);
  add("link_viscosity", "eta of permanent links", l.eta);
  add("link_tangential_viscosity", "eta_t of permanent links", l.eta_t);
}

}  // namespace

std::vector<Derived> derived_laws(const BodyLaws& laws) {
  std::vector<Derived> all{
      {{"mean_mass", "", "mass of a vertex"}, laws.mass},
      {{"time_constant", "", "tau = sqrt(m/k), m the mean mass of a particle"}, laws.tau}};
  append_laws("", "", laws.k, laws.touch.common(), laws.link.common(), all);
  for (const auto& [pair, k] : laws.pairs)
    append_laws(fmt::format(".{}.{}", pair.contact.first, pair.contact.second),
                fmt::format(" of {} with {}", pair.contact.first, pair.contact.second), k,
                laws.touch.of(pair.first, pair.second), laws.link.of(pair.first, pair.second), all);
  return all;
}

void add_rheology(const BodyLaws& laws, Packing<2>& packing) {
  if (laws.touch.most([](const TouchLaw& t) { return std::max(t.friction, t.eta); }) > 0)
    packing.field->add(TouchFriction(laws.touch));
  packing.field->add(LinkForces(laws.link));
}

int crosslink_bodies(const Case& c, Packing<2>& packing) {
  Evaluation<2> evaluation;
  packing.field->evaluate(packing.system, Detail::forces, evaluation);
  std::vector<TouchingSites> touching;
  for (const ContactRecord<2>& record : packing.field->bodies()->records(packing.system))
    if (record.multiplicity > 0 && record.gap < 0) touching.push_back(touching_sites(record));
  CrosslinkSpec spec = crosslink_spec(c);
  spec.cut_top_bottom = false;  // there are no plates
  link_bodies(packing.system, std::move(touching), spec, static_cast<std::uint64_t>(c.general.seed));
  packing.field->invalidate();
  const std::vector<std::int32_t> cluster = linked_clusters(packing.system);
  return cluster.empty() ? 0 : *std::max_element(cluster.begin(), cluster.end()) + 1;
}

double sheared_body_step(const Case& c, const BodyLaws& laws, Packing<2>& packing) {
  if (c.time.time_step > 0) return c.time.time_step;
  const std::vector<double>& masses = packing.system.state.mass;
  const double mass = *std::min_element(masses.begin(), masses.end());
  const double conservative = frequency_bound(packing.system, *packing.field);
  const double springs = std::max(laws.touch.most([](const TouchLaw& t) { return 3 * t.k_t; }),
                                  laws.link.most([](const LinkLaw& l) { return l.k + 3 * l.k_t; }));
  const double dashpots = std::max(laws.touch.most([](const TouchLaw& t) { return t.eta + 3 * t.eta_t; }),
                                   laws.link.most([](const LinkLaw& l) { return l.eta + 3 * l.eta_t; }));
  const double w = std::sqrt(conservative * conservative + neighbours * springs / mass);
  const double z = neighbours * dashpots / (2 * mass * w);
  return c.time.step_factor * step_share * leapfrog_limit(w, z);
}

}  // namespace supple
