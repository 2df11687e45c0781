#include "supple/experiment/sliding_record.hpp"

#include <cmath>

#include "supple/observe/summary.hpp"
#include "supple/solve/body_objective.hpp"

namespace supple {

SlidingInstant look_at_pair(SlidingPair& pair, std::int64_t place) {
  Packing<2>& p = pair.packing;
  Evaluation<2> evaluation;
  p.field->evaluate(p.system, Detail::energies, evaluation);
  BodyContacts<2>& contacts = *p.field->bodies();
  SlidingInstant instant;
  instant.leg = pair.path.leg(place);
  instant.x = pair.path.x(place);
  instant.x_in_widths = instant.x / pair.width;
  instant.force =
      force_on(p.system, site_contacts(p.system, contacts.records(p.system), contacts.laws()), 1, 0);
  instant.contact_energy = evaluation.energy.elastic;
  instant.energy = evaluation.energy.stored();
  instant.residual = largest_net_force(p.system, evaluation.force);
  instant.kinetic = pair.in_contact_energies(kinetic_energy(p.system).total());
  return instant;
}

const Observables<SlidingInstant>& sliding_observables() {
  using I = SlidingInstant;
  static const Observables<I> all{
      {{"leg", "", "which way over the lower particle, from 0"},
       [](const I& i) { return static_cast<double>(i.leg); }},
      {{"x_over_width", "D", "x over the width of the lower particle"},
       [](const I& i) { return i.x_in_widths; }},
      {{"x", "", "how far to the right of the lower particle the upper one is held"},
       [](const I& i) { return i.x; }},
      {{"friction", "", "mu_eff = F_t/F_n; 0 where nothing touches"},
       [](const I& i) { return i.force.friction(); }},
      {{"normal_force", "", "F_n on the upper particle, along the line from the lower centre to its own"},
       [](const I& i) { return i.force.normal_force(); }},
      {{"tangential_force", "", "F_t on it, across that line: positive to the left where it is above"},
       [](const I& i) { return i.force.tangential_force(); }},
      {{"distance", "", "of the two centres"}, [](const I& i) { return i.force.distance; }},
      {{"contacts", "", "vertices in contact; rough: pairs of them"},
       [](const I& i) { return static_cast<double>(i.force.contacts); }},
      {{"contact_energy", "", "energy stored in contacts"}, [](const I& i) { return i.contact_energy; }},
      {{"energy", "", "energy of shapes, contacts and the springs that hold vertices"},
       [](const I& i) { return i.energy; }},
      {{"residual", "", "largest net force on a vertex"}, [](const I& i) { return i.residual; }},
      {{"kinetic_energy", "k_c sigma^2", "kinetic energy that is left"},
       [](const I& i) { return i.kinetic; }}};
  return all;
}

void record_sliding(const SlidingPair& pair, Recorder& recorder) {
  const auto column = [&](const char* name) { return recorder.column("friction", name); };
  const std::vector<double> mu = column("friction"), x = column("x_over_width"),
                            force = column("normal_force"), across = column("tangential_force");
  const auto record = [&](const char* name, const char* unit, const char* meaning, double value) {
    recorder.value("results", {name, unit, meaning}, value);
  };
  const auto touches = [&](std::size_t k) { return std::hypot(force[k], across[k]) > pair.least_force; };
  std::size_t touching = 0, highest = 0, lowest = 0;
  double jump = 0;
  for (std::size_t k = 0; k < mu.size(); ++k) {
    if (!touches(k)) continue;
    if (touching++ == 0) highest = lowest = k;
    if (mu[k] > mu[highest]) highest = k;
    if (mu[k] < mu[lowest]) lowest = k;
    if (k > 0 && touches(k - 1)) jump = std::max(jump, std::abs(mu[k] - mu[k - 1]));
  }
  record("places_in_contact", "", "places of the upper particle at which the two touch",
         static_cast<double>(touching));
  if (touching == 0)
    return recorder.warning("the particles touch at no place of the way: there is no friction to be seen");
  record("friction_max", "", "largest mu_eff", mu[highest]);
  record("friction_max_x", "D", "x where it is", x[highest]);
  record("friction_max_force", "", "F_n there", force[highest]);
  record("friction_min", "", "least mu_eff", mu[lowest]);
  record("friction_min_x", "D", "x where it is", x[lowest]);
  record("friction_jump", "", "largest change of mu_eff from one place to the next, both in contact", jump);
  if (pair.bound)
    record("friction_bound", "", "largest mu_eff of rigid rough particles of this geometry (9.13)",
           *pair.bound);
  if (touches(0) || touches(mu.size() - 1))
    recorder.warning("the particles touch at an end of the way: it shows a part of the contacts");
}

}  // namespace supple
