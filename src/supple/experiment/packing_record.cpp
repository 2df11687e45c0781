#include "supple/experiment/packing_record.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "supple/experiment/frame.hpp"
#include "supple/experiment/sound_states.hpp"
#include "supple/model/body_links.hpp"
#include "supple/observe/rattlers.hpp"
#include "supple/observe/summary.hpp"

namespace supple {

namespace {

/// Stress of each body on its covered area, and the pressure that it means.
void add_body_stresses(Frame& frame, const Packing<2>& packing, const PackingReport& r) {
  std::vector<Mat2> stresses = r.stresses.of_bodies(r.fraction.volume);
  for (Mat2& stress : stresses) {
    stress = (1 / packing.pressure_unit) * stress;
    frame.body["pressure"].push_back(pressure(stress));
  }
  add_stresses(frame.body, stresses);
}

/// Energies of the whole by term and, where the particles fill a cell, its stress and that of the contacts.
void add_numbers(Frame& frame, const Packing<2>& packing, const PackingReport& r, Surroundings surroundings) {
  const EnergyParts& e = r.evaluation.energy;
  frame.numbers = {{"kinetic_energy", kinetic_energy(packing.system, r.evaluation).total()},
                   {"shape_energy", e.terms},
                   {"contact_energy", e.elastic},
                   {"wall_energy", e.wall},
                   {"external_energy", e.external}};
  if (surroundings == Surroundings::open) return;
  const Mat2 total = (1 / packing.pressure_unit) * r.stresses.total(),
             contact = (1 / packing.pressure_unit) * r.stresses.contact;
  frame.numbers["packing_fraction"] = r.fraction.total;
  frame.numbers["pressure"] = pressure(total);
  add_tensor(frame.numbers, "stress", total);
  add_tensor(frame.numbers, "contact_stress", contact);
}

template <class T>
std::vector<double> as_numbers(const std::vector<T>& values) {
  return {values.begin(), values.end()};
}

void warn(const PackingReport& r, const JamProgress<2>& progress, Recorder& recorder) {
  if (!r.soundness.sound())
    recorder.warning(
        fmt::format("{}: the numbers of this state are those of no packing", r.soundness.what()));
  if (progress.unconverged > 0)
    recorder.warning(
        fmt::format("{} of {} minimisations stopped before their tolerance{}", progress.unconverged,
                    progress.minimisations,
                    progress.last.converged ? "" : ", the last one too: " + progress.last.reason));
}

}  // namespace

std::vector<Derived> derived_packing(const Packing<2>& packing) {
  const System<2>& s = packing.system;
  return {
      {{"bodies", "", "particles"}, static_cast<double>(s.topology.body_count(s.state.size()))},
      {{"sites", "", "vertices and discs"}, static_cast<double>(s.state.size())},
      {{"cell_width", "", "width of the cell at the start"}, packing.cell.length[flow]},
      {{"cell_height", "", "height of the cell at the start"}, packing.cell.length[gradient]},
      {{"start_fraction", "", "packing fraction at the start"}, packing.covered_area / packing.cell.volume()},
      {{"pressure_unit", "", "unit of pressures, in units of the run"}, packing.pressure_unit}};
}

std::vector<Derived> derived_equilibria(const Packing<2>& packing) {
  std::vector<Derived> all = derived_packing(packing);
  all.push_back({{"force_tolerance", "mean contact force", "largest net force in equilibrium"},
                 packing.tolerance.relative});
  all.push_back(
      {{"least_force", "", "net force that is equilibrium whatever touches"}, packing.tolerance.least});
  return all;
}

void begin_packing(Packing<2>& packing, const std::vector<Derived>& constants, Recorder& recorder) {
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
std::vector<SiteContact<2>> with_links(std::vector<SiteContact<2>> contacts, const System<2>& system,
                                       const Evaluation<2>& evaluation) {
  const std::vector<std::int32_t> body = bodies_of_sites(system.topology, system.state.size());
  for (std::size_t k = 0; k < evaluation.link_force.size(); ++k) {
    const Link& link = system.links[k];
    const Vec2 shift = system.box.lattice().vector({1.0 * link.cells[0], 1.0 * link.cells[1]});
    Vec2 n = link_vector(system, link);
    if (const double d = norm(n); d > 0) n = (1 / d) * n;
    contacts.push_back({link.second, link.first, body[link.second], body[link.first],
                        (evaluation.link_force[k].elastic + evaluation.link_force[k].viscous) * n, shift});
  }
  return contacts;
}

}  // namespace

PackingReport report_packing(Packing<2>& packing, const PresentMotion<2>& now) {
  PackingReport r;
  r.evaluation.now = now;
  System<2>& s = packing.system;
  packing.field->evaluate(s, Detail::energies, r.evaluation);
  BodyContacts<2>& contacts = *packing.field->bodies();
  r.records = contacts.records(s);
  r.contacts = site_contacts(s, r.records, contacts.laws());
  r.network = contact_network(s, with_links(r.contacts, s, r.evaluation), r.evaluation.wall);
  r.rattlers = find_rattlers(s, r.contacts, {r.evaluation.wall, packing.field->external().gravity});
  r.numbers = count_contacts(r.network, r.rattlers);
  r.constraints = count_constraints(s, r.contacts, r.rattlers, r.evaluation.wall);
  r.stresses = body_stresses(s, *packing.field, r.evaluation);
  r.shapes = measure_shapes(s);
  r.fraction = packing_fraction(s, packing.outline);
  r.soundness = look_at(packing);
  return r;
}

Observables<PackingInstant> packing_observables(const std::string& symbol) {
  using P = PackingInstant;
  return {
      {{"packing_fraction", "", "covered area over area of the cell"},
       [](const P& p) { return p.report.fraction.total; }},
      {{"pressure", symbol, "full virial pressure (9.26)"}, [](const P& p) { return pressure(p.stress()); }},
      {{"contact_pressure", symbol, "pressure by contacts alone"},
       [](const P& p) { return pressure(p.report.stresses.contact) / p.packing.pressure_unit; }},
      {{"stress_xx", symbol, "full stress, compression positive"},
       [](const P& p) { return p.stress()[0][0]; }},
      {{"stress_yy", symbol, "full stress, compression positive"},
       [](const P& p) { return p.stress()[1][1]; }},
      {{"stress_xy", symbol, "full stress, compression positive"},
       [](const P& p) { return -shear_stress(p.stress()); }},
      {{"energy", "", "potential energy"}, [](const P& p) { return p.report.evaluation.energy.stored(); }},
      {{"mean_contacts", "", "touching neighbours of a particle, rattlers left out"},
       [](const P& p) { return p.report.numbers.mean(); }},
      {{"rattlers", "", "particles that can leave all of their contacts at once, removed until none is left"},
       [](const P& p) {
         return static_cast<double>(std::count(p.report.rattlers.begin(), p.report.rattlers.end(), 1));
       }},
      {{"residual", "", "largest net force on a vertex, or on a rigid particle"},
       [](const P& p) { return largest_net_force(p.packing.system, p.report.evaluation.force); }},
      {{"tolerance", "", "residual at which its minimisation was done"},
       [](const P& p) { return p.work.last.tolerance; }},
      {{"evaluations", "", "force evaluations so far"},
       [](const P& p) { return static_cast<double>(p.work.evaluations); }},
      {{"unsound", "", unsound_meaning},
       [](const P& p) { return static_cast<double>(p.report.soundness.bodies()); }}};
}

Frame packing_frame(const Packing<2>& packing, const PackingReport& r, Surroundings surroundings) {
  Frame frame = make_frame(packing.system, r.evaluation, r.records, packing.field->bodies()->laws());
  add_body_stresses(frame, packing, r);
  add_numbers(frame, packing, r, surroundings);
  frame.body["area"] = r.fraction.volume;
  frame.body["shape_parameter"] = r.shapes.shape_parameter;
  frame.body["contacts"] = as_numbers(r.network.contacts_of_bodies());
  frame.body["rattler"] = as_numbers(r.rattlers);
  frame.body["unsound"] = as_numbers(r.soundness.unsound);
  return frame;
}

namespace {

/// Walls and gravity as they are now, for a continuation.
void record_environment(const Packing<2>& packing, Recorder& recorder) {
  const Environment environment = environment_of(packing);
  for_each_wall(environment, [&](const std::string& name, bool stands) {
    recorder.value(environment_group, {name, "", "1: this wall stands where the cell is not periodic"},
                   stands);
  });
  recorder.value(environment_group, {"gravity", "", "acceleration downward"}, -environment.gravity[gradient]);
}

}  // namespace

Environment environment_of(const Packing<2>& packing) {
  Environment e;
  if (const auto& walls = packing.field->walls()) e.stands = walls->stands;
  e.gravity = packing.field->external().gravity;
  return e;
}

void record_packing(Packing<2>& packing, const JamProgress<2>& progress, Recorder& recorder,
                    Surroundings surroundings, const PresentMotion<2>& now) {
  const PackingReport r = report_packing(packing, now);
  recorder.frame(packing_frame(packing, r, surroundings));
  const PackingInstant instant{packing, r, progress};
  const bool moves = instant.moves(), open = surroundings == Surroundings::open;
  packing_observables(packing.pressure_symbol).record(instant, recorder, [&](std::string_view name) {
    const bool of_cell =
        name == "packing_fraction" || name.find("pressure") != name.npos || name.starts_with("stress");
    return !(open && of_cell) && !(moves && one_of({"tolerance", "evaluations"})(name));
  });
  const auto number = [&](const char* name, const char* meaning, double value) {
    recorder.value("results", {name, "", meaning}, value);
  };
  if (moves) number("kinetic_energy", "kinetic energy", kinetic_energy(packing.system, r.evaluation).total());
  number("particle_contacts", "pairs of particles that touch, rattlers left out", r.numbers.pairs);
  number("vertex_contacts", "vertices that touch another particle", static_cast<double>(r.contacts.size()));
  // Friction and links hold more than one push a contact does.
  if (!open && packing.field->interactions().empty())
    number("contacts_beyond_isostatic", "vertex contacts more than a just rigid packing needs",
           r.constraints.excess());
  if (const auto shape = mean_shape_parameter(r.shapes))
    number("mean_shape_parameter", "mean p^2/(4 pi a) of the polygons", *shape);
  if (packing.outline == Outline::smooth)
    number("feature_violations",
           "vertices near a part of a boundary that is no simple arc, where corners and edges do "
           "not add up to one contact",
           packing.field->bodies()->feature_violations());
  else if (r.soundness.longest_edge > 0)
    number("longest_edge",
           "longest edge over the distance at which the vertices at its ends touch; from 2 on others pass",
           r.soundness.longest_edge);
  if (!moves) {
    number("minimisations", "minimisations", static_cast<double>(progress.minimisations));
    number("unconverged", "minimisations that stopped before the tolerance",
           static_cast<double>(progress.unconverged));
  }
  warn(r, progress, recorder);
  record_environment(packing, recorder);
  recorder.final_state(packing.system, r.evaluation);
}

void hand_over_packing(Packing<2>& packing, Recorder& recorder) {
  hand_over(packing, recorder);  // whatever can be said of it
  try {
    const PackingReport r = report_packing(packing);
    JamProgress<2> work;
    work.minimisations = 1;  // it rests: no kinetic part
    packing_observables(packing.pressure_symbol)
        .record({packing, r, work}, recorder,
                one_of({"packing_fraction", "pressure", "contact_pressure", "energy", "residual"}));
    recorder.frame(packing_frame(packing, r));
  } catch (const Error&) {  // the run already ends for another reason, which is the one to report
  }
}

void hand_over(Packing<2>& packing, Recorder& recorder) {
  Evaluation<2> evaluation;
  packing.field->evaluate(packing.system, Detail::energies, evaluation);
  record_environment(packing, recorder);
  recorder.final_state(packing.system, evaluation);
}

}  // namespace supple
