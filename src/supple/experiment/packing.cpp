#include "supple/experiment/packing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "supple/build/solid_bodies.hpp"
#include "supple/build/surfaces.hpp"
#include "supple/contact/edge_cover.hpp"
#include "supple/contact/rough_contacts.hpp"
#include "supple/contact/smooth_contacts.hpp"
#include "supple/contact/smooth_surfaces.hpp"
#include "supple/core/error.hpp"
#include "supple/energy/collapse.hpp"
#include "supple/experiment/pairs_of_case.hpp"
#include "supple/experiment/sound_states.hpp"
#include "supple/experiment/used_keys.hpp"
#include "supple/force/body_terms.hpp"
#include "supple/force/polygon_shape.hpp"
#include "supple/force/solid_terms.hpp"
#include "supple/force/surface_shape.hpp"
#include "supple/model/sanity.hpp"
#include "supple/observe/body_stress.hpp"
#include "supple/observe/shape_measures.hpp"

namespace supple {

void keep(Keeper& k, MinimiseReport& report) {
  k("converged", report.converged);
  k("ending", report.ending);
  k("evaluations", report.evaluations);
  k("iterations", report.iterations);
  k("factorisations", report.factorisations);
  k("energy", report.energy);
  k("residual", report.residual);
  k("tolerance", report.tolerance);
  k("reason", report.reason);
}

template <int Dim>
void Packing<Dim>::keep(Keeper& k) {
  k("system", system);
  k("pressure_unit", pressure_unit);
  k("pressure_symbol", pressure_symbol);
  k("relative_tolerance", tolerance.relative);
  k("least_tolerance", tolerance.least);
  k("covered_area", covered_area);
  k("shape_area", shape_area);
  k("cell", cell);
  k("relaxed", relaxed);
  if (k.restores()) field->invalidate();
}

namespace {

Harmonic springs_of(const Case& c) { return {c.contact.k_c, c.bodies.stiffness == "relative"}; }

template <int Dim>
double mean_radius(const System<Dim>& system) {
  double sum = 0;
  for (double r : system.state.radius) sum += r;
  return sum / system.state.size();
}

}  // namespace

template <int Dim>
ForceField<Dim> make_body_field(const Case& c) {
  using Smooth = std::conditional_t<Dim == 2, SmoothContacts, SmoothSurfaces>;
  using WholeShape = std::conditional_t<Dim == 2, PolygonShape, SurfaceShape>;
  const ContactLaws laws = contact_laws(c);
  ForceField<Dim> field =
      c.contact.kind == "smooth" ? ForceField<Dim>(Smooth(laws)) : ForceField<Dim>(RoughContacts<Dim>(laws));
  field.terms().add(std::make_shared<WholeShape>());
  field.terms().add(std::make_shared<SolidTerms<Dim>>());
  field.terms().add(std::make_shared<BodyTermSet<Dim>>());
  return field;
}

template <int Dim>
WallLaw<Dim> wall_law(const Case& c) {
  WallLaw<Dim> walls;
  walls.repulsion = springs_of(c);
  walls.repulsion.stiffness *= c.contact.k_p;
  if constexpr (Dim == 2) walls.floor_friction = c.contact.floor_friction;
  return walls;
}

namespace {

/// Of all polygons and discs.
template <int Dim>
double area_of_shapes(const System<Dim>& system) {
  const std::vector<double> areas = measure_shapes(system).volume;
  return std::accumulate(areas.begin(), areas.end(), 0.0);
}

std::string what_to_do_about_start(const Soundness& s) {
  if (!s.has_areas()) return "order the sites of a particle counter-clockwise round its area, unwrapped";
  const bool only_open = s.inside + s.crossing == 0;
  return fmt::format("{}, or go on with contact.unsound = \"mark\"",
                     only_open ? "give wider vertices (bodies.diameter_ratio) or contact.kind = \"smooth\""
                               : "move them apart");
}

/// Tension [energy/length; 3D: energy/length^2] at which body b would shrink to a point.
double collapsing_tension_of(const System<2>& s, std::size_t b) {
  const auto begin = static_cast<std::size_t>(s.topology.facet_begin[b]),
             end = static_cast<std::size_t>(s.topology.facet_begin[b + 1]);
  return collapsing_tension(s.shape.stiffness[b], s.shape.rest_volume[b],
                            std::span(s.shape.rest_facet).subspan(begin, end - begin));
}
double collapsing_tension_of(const System<3>& s, std::size_t b) {
  const TriangleMesh mesh = mesh_of(s, static_cast<int>(b));
  const double to_rest = std::pow(s.shape.rest_volume[b] / enclosed_volume(mesh), 2.0 / 3);
  std::vector<double> areas = face_areas(mesh);
  for (double& a : areas) a *= to_rest;
  return collapsing_tension(s.shape.stiffness[b], s.shape.rest_volume[b], areas,
                            std::span(s.shape.rest_facet)
                                .subspan(static_cast<std::size_t>(s.topology.facet_begin[b]), areas.size()));
}

/// Input error where tension would shrink a particle to a point.
template <int Dim>
void check_tension(const System<Dim>& s) {
  for (std::size_t b = 0; b < s.shape.stiffness.size(); ++b) {
    const ShapeStiffness& k = s.shape.stiffness[b];
    if (!(k.tension > 0)) continue;
    const double most = collapsing_tension_of(s, b);
    if (k.tension < most) continue;
    throw input_error(
        fmt::format("the {} tension of particle {} is {:.4g} times what its {} bear",
                    Dim == 2 ? "line" : "surface", b, k.tension / most,
                    Dim == 2 ? "area and edges" : "volume and triangles"),
        "it has no equilibrium: it shrinks to a point",
        fmt::format("lower bodies.gamma below {:.4g} of what it is, or raise bodies.k_a or bodies.{}",
                    most / k.tension, Dim == 2 ? "k_l" : "k_v"));
  }
}

/// k_a a0 (3D: k_v v0) of the smallest deformable particle, Young's modulus of the first solid, or the
/// stiffness of contacts that k_c means.
template <int Dim>
void set_pressure_unit(const Harmonic& law, Packing<Dim>& p) {
  const auto& stiffness = p.system.shape.stiffness;
  double smallest = 0;
  for (std::size_t b = 0; b < stiffness.size(); ++b) {
    const double area = p.system.shape.rest_volume[b];
    if (stiffness[b].volume == 0 || (smallest > 0 && area >= smallest)) continue;
    smallest = area;
    p.pressure_unit = stiffness[b].volume * area;
    p.pressure_symbol = Dim == 2 ? "k_a a0" : "k_v v0";
  }
  if (smallest > 0) return;
  for (int b = 0; b < p.system.solid.bodies(); ++b)
    if (const auto constants = nominal_constants(p.system, b)) {
      p.pressure_unit = constants->young_modulus;
      p.pressure_symbol = "E";
      return;
    }
  const double sigma = 2 * *std::min_element(p.system.state.radius.begin(), p.system.state.radius.end());
  p.pressure_unit = Dim == 2 ? law.spring(sigma) : law.spring(sigma) / sigma;
  if constexpr (Dim == 2) p.pressure_symbol = law.relative ? "k_c/sigma^2" : "k_c";
  else p.pressure_symbol = law.relative ? "k_c/sigma^3" : "k_c/sigma";
}

}  // namespace

template <int Dim>
Packing<Dim> packing_of(const Case& c, System<Dim> system, Places places) {
  require_sane(system, "this packing");
  check_tension(system);
  if constexpr (Dim == 3) {
    const bool stays = uses(c, "time.steps") && c.time.steps == 0;  // nothing passes through in no steps
    const bool meet = system.topology.body_count(system.state.size()) > 1;
    if (c.contact.unsound == "stop" && !stays && meet)
      require_covered_edges(system,
                            c.contact.kind == "smooth" ? least_smooth_diameter : least_rough_diameter);
  }
  Packing<Dim> p;
  p.system = std::move(system);
  p.field = std::make_unique<ForceField<Dim>>(make_body_field<Dim>(c));
  p.outline = c.contact.kind == "smooth" ? Outline::smooth : Outline::rough;
  p.on_unsound = c.contact.unsound == "mark" ? OnUnsound::mark : OnUnsound::stop;
  const bool apart = places == Places::apart;
  if (const Soundness s = apart ? look_at_each(p.system, p.outline) : look_at(p); must_stop(p, s))
    throw input_error("the packing to start from: " + s.what(), "", what_to_do_about_start(s));
  // A packing in 3D that a file gives has the pressures of the file's own units.
  if (Dim == 3 && !c.initial.packing.empty()) p.pressure_symbol = "";
  else set_pressure_unit(springs_of(c), p);
  p.shape_area = area_of_shapes(p.system);
  p.minimise.method = minimiser_named(c.minimise.method);
  p.minimise.max_evaluations = c.minimise.max_evaluations;
  const Jamming wanted = uses(c, "jamming.pressure") ? c.jamming : Jamming{};
  p.contact_pressure = wanted.pressure_kind == "contact";
  p.tolerance.relative = c.minimise.force_tolerance;
  p.tolerance.least =
      c.minimise.least_force > 0
          ? c.minimise.least_force
          : force_by_pressure<Dim>(c.minimise.force_tolerance * wanted.pressure * p.pressure_unit,
                                   2 * mean_radius(p.system));
  p.cell = p.system.box;
  if (!apart) p.covered_area = packing_fraction(p.system, p.outline).total * p.cell.volume();
  return p;
}

template <int Dim>
double covered_fraction(const Packing<Dim>& packing) {
  if constexpr (Dim == 3)
    return packing_fraction(packing.system, packing.outline, {.relative_error = 1e-3}).total;
  else if (packing.outline == Outline::rough) return rough_sum(packing.system).total;
  else return packing_fraction(packing.system, packing.outline).total;
}

template <int Dim>
PackingState<Dim> observe(Packing<Dim>& packing) {
  Evaluation<Dim> all, contacts;
  packing.field->evaluate(packing.system, Detail::energies, all);
  contacts.force.resize(all.force.size());
  contacts.torque.resize(all.force.size());
  packing.field->bodies()->evaluate(packing.system, Detail::energies, contacts);
  const double scale = 1 / (packing.system.box.volume() * packing.pressure_unit);
  PackingState<Dim> s;
  s.packing_fraction = packing.covered_area * (area_of_shapes(packing.system) / packing.shape_area) /
                       packing.system.box.volume();
  s.stress = scale * all.virial;
  s.full_pressure = pressure(s.stress);
  s.contact_pressure = scale * pressure(contacts.virial);
  s.pressure = packing.contact_pressure ? s.contact_pressure : s.full_pressure;
  s.energy = all.energy.stored();
  return s;
}

template void Packing<2>::keep(Keeper&);
template ForceField<2> make_body_field(const Case&);
template WallLaw<2> wall_law(const Case&);
template Packing<2> packing_of(const Case&, System<2>, Places);
template double covered_fraction(const Packing<2>&);
template PackingState<2> observe(Packing<2>&);
template void Packing<3>::keep(Keeper&);
template ForceField<3> make_body_field(const Case&);
template WallLaw<3> wall_law(const Case&);
template Packing<3> packing_of(const Case&, System<3>, Places);
template double covered_fraction(const Packing<3>&);
template PackingState<3> observe(Packing<3>&);

}  // namespace supple
