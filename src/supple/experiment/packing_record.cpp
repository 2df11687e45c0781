#include "supple/experiment/packing_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "supple/experiment/frame.hpp"
#include "supple/experiment/sound_states.hpp"
#include "supple/force/shape_terms.hpp"
#include "supple/force/solid_terms.hpp"
#include "supple/model/body_links.hpp"
#include "supple/observe/rattlers.hpp"
#include "supple/observe/summary.hpp"

namespace supple {

namespace {

/// Stress of each body on its covered area, and the pressure that it means.
template <int Dim>
void add_body_stresses(Frame<Dim>& frame, const Packing<Dim>& packing, const PackingReport<Dim>& r) {
  std::vector<Mat<Dim>> stresses = r.stresses.of_bodies(r.fraction.volume);
  for (Mat<Dim>& stress : stresses) {
    stress = (1 / packing.pressure_unit) * stress;
    frame.body["pressure"].push_back(pressure(stress));
  }
  add_stresses<Dim>(frame.body, stresses);
}

/// Energies of the whole by term and, where the particles fill a cell, its stress and that of the contacts.
template <int Dim>
void add_numbers(Frame<Dim>& frame, const Packing<Dim>& packing, const PackingReport<Dim>& r,
                 Surroundings surroundings) {
  const EnergyParts& e = r.evaluation.energy;
  frame.numbers = {{"kinetic_energy", kinetic_energy(packing.system, r.evaluation).total()},
                   {"shape_energy", e.terms},
                   {"contact_energy", e.elastic},
                   {"wall_energy", e.wall},
                   {"external_energy", e.external}};
  if (surroundings == Surroundings::open) return;
  const Mat<Dim> total = (1 / packing.pressure_unit) * r.stresses.total(),
                 contact = (1 / packing.pressure_unit) * r.stresses.contact;
  frame.numbers["packing_fraction"] = r.fraction.total;
  frame.numbers["pressure"] = pressure(total);
  add_tensor<Dim>(frame.numbers, "stress", total);
  add_tensor<Dim>(frame.numbers, "contact_stress", contact);
}

template <class T>
std::vector<double> as_numbers(const std::vector<T>& values) {
  return {values.begin(), values.end()};
}

template <int Dim>
void warn(const PackingReport<Dim>& r, const JamProgress<Dim>& progress, Recorder& recorder) {
  if (!r.soundness.sound())
    recorder.warning(
        fmt::format("{}: the numbers of this state are those of no packing", r.soundness.what()));
  if (const int n = r.soundness.uncovered; n > 0)
    recorder.warning(fmt::format(
        "{} {} longer than the vertices at its ends cover: edges of two particles could pass through each "
        "other unseen",
        n, n == 1 ? "particle has an edge" : "particles have an edge"));
  if (progress.unconverged > 0)
    recorder.warning(
        fmt::format("{} of {} minimisations stopped before their tolerance{}", progress.unconverged,
                    progress.minimisations,
                    progress.last.converged ? "" : ", the last one too: " + progress.last.reason));
}

}  // namespace

template <int Dim>
std::vector<Derived> derived_packing(const Packing<Dim>& packing) {
  const System<Dim>& s = packing.system;
  std::vector<Derived> all{
      {{"bodies", "", "particles"}, static_cast<double>(s.topology.body_count(s.state.size()))},
      {{"sites", "", Dim == 2 ? "vertices and discs" : "vertices and spheres"},
       static_cast<double>(s.state.size())},
      {{"cell_width", "", "width of the cell at the start"}, packing.cell.length[flow]},
      {{"cell_height", "", "height of the cell at the start"}, packing.cell.length[gradient]}};
  if constexpr (Dim == 3)
    all.push_back({{"cell_depth", "", "depth of the cell at the start"}, packing.cell.length[vorticity]});
  all.push_back({{"start_fraction", "", "packing fraction at the start"},
                 packing.covered_area / packing.cell.volume()});
  all.push_back({{"pressure_unit", "", "unit of pressures, in units of the run"}, packing.pressure_unit});
  return all;
}

template <int Dim>
std::vector<Derived> derived_equilibria(const Packing<Dim>& packing) {
  std::vector<Derived> all = derived_packing(packing);
  all.push_back({{"force_tolerance", "mean contact force", "largest net force in equilibrium"},
                 packing.tolerance.relative});
  all.push_back(
      {{"least_force", "", "net force that is equilibrium whatever touches"}, packing.tolerance.least});
  return all;
}

template <int Dim>
void begin_packing(Packing<Dim>& packing, const std::vector<Derived>& constants, Recorder& recorder) {
  packing.minimise.stop_requested = [&recorder] { return recorder.stop_requested(); };
  if (recorder.began()) return;
  recorder.begin(make_run_info(packing.system, reduced_units()));
  for (const Derived& d : constants) recorder.value("constants", d.name, d.value);
  const Harmonic law = packing.field->bodies()->laws().common().scale();
  recorder.value(material_group, {contact_stiffness, "", "k_c of contacts"}, law.stiffness);
  recorder.value(material_group,
                 {contact_is_relative, "", "1: energy (k_c/2)(1 - r/sigma)^2; 0: (k_c/2)(sigma - r)^2"},
                 law.relative);
}

namespace {

/// Links are contacts too where neighbours are counted.
template <int Dim>
std::vector<SiteContact<Dim>> with_links(std::vector<SiteContact<Dim>> contacts, const System<Dim>& system,
                                         const Evaluation<Dim>& evaluation) {
  if constexpr (Dim == 2) {  // links are of 2D
    const std::vector<std::int32_t> body = bodies_of_sites(system.topology, system.state.size());
    for (std::size_t k = 0; k < evaluation.link_force.size(); ++k) {
      const Link& link = system.links[k];
      const Vec2 shift = system.box.lattice().vector({1.0 * link.cells[0], 1.0 * link.cells[1]});
      Vec2 n = link_vector(system, link);
      if (const double d = norm(n); d > 0) n = (1 / d) * n;
      contacts.push_back({link.second, link.first, body[link.second], body[link.first],
                          (evaluation.link_force[k].elastic + evaluation.link_force[k].viscous) * n, shift});
    }
  }
  return contacts;
}

}  // namespace

template <int Dim>
PackingReport<Dim> report_packing(Packing<Dim>& packing,
                                  const std::type_identity_t<PresentMotion<Dim>>& now) {
  PackingReport<Dim> r;
  r.evaluation.now = now;
  System<Dim>& s = packing.system;
  packing.field->evaluate(s, Detail::energies, r.evaluation);
  BodyContacts<Dim>& contacts = *packing.field->bodies();
  r.records = contacts.records(s);
  r.contacts = site_contacts(s, r.records, contacts.laws());
  r.network = contact_network(s, with_links<Dim>(r.contacts, s, r.evaluation), r.evaluation.wall);
  r.rattlers = find_rattlers(s, r.contacts, {r.evaluation.wall, packing.field->external().gravity});
  r.numbers = count_contacts(r.network, r.rattlers);
  r.constraints = count_constraints(s, r.contacts, r.rattlers, r.evaluation.wall);
  r.stresses = body_stresses(s, *packing.field, r.evaluation);
  r.shapes = measure_shapes(s);
  r.fraction = packing_fraction(s, packing.outline);
  r.soundness = look_at(packing);
  return r;
}

template <int Dim>
Frame<Dim> packing_frame(const Packing<Dim>& packing, const PackingReport<Dim>& r,
                         Surroundings surroundings) {
  Frame<Dim> frame = make_frame(packing.system, r.evaluation, r.records, packing.field->bodies()->laws());
  add_body_stresses(frame, packing, r);
  add_numbers(frame, packing, r, surroundings);
  frame.body[Dim == 2 ? "area" : "volume"] = r.fraction.volume;
  frame.body["shape_parameter"] = r.shapes.shape_parameter;
  frame.body["contacts"] = as_numbers(r.network.contacts_of_bodies());
  frame.body["rattler"] = as_numbers(r.rattlers);
  frame.body["unsound"] = as_numbers(r.soundness.unsound);
  return frame;
}

namespace {

/// Walls and gravity as they are now, for a continuation.
template <int Dim>
void record_environment(const Packing<Dim>& packing, Recorder& recorder) {
  const Environment environment = environment_of(packing);
  for_each_wall<Dim>(environment, [&](const std::string& name, bool stands) {
    recorder.value(environment_group, {name, "", "1: this wall stands where the cell is not periodic"},
                   stands);
  });
  recorder.value(environment_group, {"gravity", "", "acceleration downward"}, -environment.gravity[gradient]);
}

/// The shape energy by term.
void record_energies(const System<3>& system, Recorder& recorder) {
  static const std::vector<std::pair<std::string, Column>> columns{
      {"enclosed_volume", {"energy_volume", "", "energy of enclosed volumes"}},
      {"facet_stretch", {"energy_area", "", "energy of the areas of triangles"}},
      {"hinge_bend", {"energy_bending", "", "energy of the angles between triangles"}},
      {"facet_tension", {"energy_tension", "", "energy of surface tension"}}};
  std::map<std::string, double> energies;  // a term whose stiffness is zero is no term
  for (const auto& [term, energy] : shape_terms(system).energies(system)) energies[term] = energy;
  for (const auto& [term, column] : columns) recorder.value("results", column, energies[term]);
  if (!system.solid.empty())
    recorder.value("results", {"energy_solid", "", "energy of springs and elements inside particles"},
                   SolidTerms<3>().energy(system));
}

}  // namespace

template <int Dim>
Environment environment_of(const Packing<Dim>& packing) {
  Environment e;
  if (const auto& walls = packing.field->walls()) std::ranges::copy(walls->stands, e.stands.begin());
  for (int d = 0; d < Dim; ++d) e.gravity[d] = packing.field->external().gravity[d];
  return e;
}

template <int Dim>
void record_packing(Packing<Dim>& packing, const JamProgress<Dim>& progress, Recorder& recorder,
                    Surroundings surroundings, const std::type_identity_t<PresentMotion<Dim>>& now) {
  const PackingReport<Dim> r = report_packing(packing, now);
  recorder.frame(packing_frame(packing, r, surroundings));
  const PackingInstant<Dim> instant{packing, r, progress};
  const bool moves = instant.moves(), open = surroundings == Surroundings::open;
  packing_observables<Dim>(packing.pressure_symbol).record(instant, recorder, [&](std::string_view name) {
    const bool of_cell =
        name == "packing_fraction" || name.find("pressure") != name.npos || name.starts_with("stress");
    return !(open && of_cell) && !(moves && one_of({"tolerance", "evaluations"})(name));
  });
  const auto number = [&](const char* name, const char* meaning, double value) {
    recorder.value("results", {name, "", meaning}, value);
  };
  if (moves) number("kinetic_energy", "kinetic energy", kinetic_energy(packing.system, r.evaluation).total());
  number("particle_contacts", "pairs of particles that touch, each image of one counted, rattlers left out",
         r.numbers.pairs);
  number("vertex_contacts", "vertices that touch another particle", static_cast<double>(r.contacts.size()));
  // Friction and links hold more than one push a contact does.
  if (!open && packing.field->interactions().empty())
    number("contacts_beyond_isostatic", "vertex contacts more than a just rigid packing needs",
           r.constraints.excess());
  if (const auto shape = mean_shape_parameter(r.shapes))
    number("mean_shape_parameter",
           Dim == 2 ? "mean p^2/(4 pi a) of the polygons" : "mean a^(3/2)/(6 sqrt(pi) v) of the surfaces",
           *shape);
  if constexpr (Dim == 3) {
    record_energies(packing.system, recorder);
    number("energy_contact", "energy of contacts between particles", r.evaluation.energy.elastic);
    if (packing.field->walls())
      number("energy_wall", "energy of contacts with walls", r.evaluation.energy.wall);
    if (!(packing.field->external().gravity == Vec<Dim>{}))
      number("energy_external", "energy in gravity", r.evaluation.energy.external);
  }
  if (packing.outline == Outline::smooth)
    number("feature_violations",
           Dim == 2 ? "vertices near a part of a boundary that is no simple arc, where corners and edges do "
                      "not add up to one contact"
                    : "vertices near a part of a surface that is no simple patch, where triangles, edges and "
                      "corners do not add up to one contact",
           packing.field->bodies()->feature_violations());
  else if (r.soundness.longest_edge > 0)
    number(
        "longest_edge",
        Dim == 2
            ? "longest edge over the distance at which the vertices at its ends touch; from 2 on others pass"
            : "longest edge over the distance at which the vertices at its ends touch; from 1.41 on other "
              "edges pass, from 1.73 vertices",
        r.soundness.longest_edge);
  if (!moves) {
    number("minimisations", "minimisations", static_cast<double>(progress.minimisations));
    number("unconverged", "minimisations that stopped before the tolerance",
           static_cast<double>(progress.unconverged));
  }
  warn(r, progress, recorder);
  record_environment(packing, recorder);
  recorder.final_state(FinalState<Dim>{packing.system, r.evaluation});
}

template <int Dim>
void hand_over_packing(Packing<Dim>& packing, Recorder& recorder) {
  hand_over(packing, recorder);  // whatever can be said of it
  try {
    const PackingReport<Dim> r = report_packing(packing);
    JamProgress<Dim> work;
    work.minimisations = 1;  // it rests: no kinetic part
    packing_observables<Dim>(packing.pressure_symbol)
        .record({packing, r, work}, recorder,
                one_of({"packing_fraction", "pressure", "contact_pressure", "energy", "residual"}));
    recorder.frame(packing_frame(packing, r));
  } catch (const Error&) {  // the run already ends for another reason, which is the one to report
  }
}

template <int Dim>
void hand_over(Packing<Dim>& packing, Recorder& recorder) {
  Evaluation<Dim> evaluation;
  packing.field->evaluate(packing.system, Detail::energies, evaluation);
  record_environment(packing, recorder);
  recorder.final_state(FinalState<Dim>{packing.system, evaluation});
}

#define SUPPLE_RECORDED(Dim)                                                                       \
  template std::vector<Derived> derived_packing(const Packing<Dim>&);                              \
  template std::vector<Derived> derived_equilibria(const Packing<Dim>&);                           \
  template void begin_packing(Packing<Dim>&, const std::vector<Derived>&, Recorder&);              \
  template PackingReport<Dim> report_packing(Packing<Dim>&, const PresentMotion<Dim>&);            \
  template Frame<Dim> packing_frame(const Packing<Dim>&, const PackingReport<Dim>&, Surroundings); \
  template Environment environment_of(const Packing<Dim>&);                                        \
  template void record_packing(Packing<Dim>&, const JamProgress<Dim>&, Recorder&, Surroundings,    \
                               const PresentMotion<Dim>&);                                         \
  template void hand_over_packing(Packing<Dim>&, Recorder&);                                       \
  template void hand_over(Packing<Dim>&, Recorder&);
SUPPLE_RECORDED(2)
SUPPLE_RECORDED(3)
#undef SUPPLE_RECORDED

}  // namespace supple
