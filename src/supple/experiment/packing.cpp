#include "supple/experiment/packing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "supple/contact/rough_contacts.hpp"
#include "supple/contact/smooth_contacts.hpp"
#include "supple/core/error.hpp"
#include "supple/core/random.hpp"
#include "supple/energy/collapse.hpp"
#include "supple/experiment/given_packing.hpp"
#include "supple/experiment/sound_states.hpp"
#include "supple/force/polygon_shape.hpp"
#include "supple/model/bodies.hpp"
#include "supple/model/polygons.hpp"
#include "supple/model/sanity.hpp"
#include "supple/observe/shape_measures.hpp"

namespace supple {

namespace {

using std::numbers::pi;

bool has_polygons(const Bodies& b) { return b.family != "disc"; }

/// p^2/(4 pi a) that a particle of n vertices prefers; 0: of the regular polygon.
double preferred_shape_parameter(const Bodies& b, int n, bool large) {
  if (b.family == "rough_disc") return 0;
  const double ratio = large && b.shape_ratio_large > 0 ? b.shape_ratio_large : b.shape_ratio;
  return ratio > 0 ? ratio * least_shape_parameter(n) : b.shape_parameter;
}

ShapeSpec shape_spec(const Bodies& b, int n, bool large) {
  return {b.k_a,
          b.k_l,
          b.k_b,
          b.gamma,
          b.stiffness == "relative" ? StiffnessKind::relative : StiffnessKind::absolute,
          preferred_shape_parameter(b, n, large)};
}

Harmonic contact_law(const Case& c) { return {c.contact.k_c, c.bodies.stiffness == "relative"}; }

/// Preferred areas: small particles 1, large ones size_ratio^2, then the extra discs.
struct Sizes {
  int particles, large;
  double ratio;
  explicit Sizes(const Bodies& b)
      : particles(b.count),
        large(static_cast<int>(std::lround(b.large_fraction * b.count))),
        ratio(b.size_ratio) {}
  bool is_large(int body) const { return body >= particles - large && body < particles; }
  double area(int body) const { return is_large(body) ? ratio * ratio : 1; }
};

/// Adds the particle `body` of the case about a centre.
void add_particle(const Case& c, int body, const Vec2& centre, System<2>& system) {
  const Bodies& b = c.bodies;
  const Sizes sizes(b);
  const double area = sizes.area(body);
  if (!has_polygons(b) || body >= b.count) return add_disc_body(system, centre, std::sqrt(area / pi));
  const int n = sizes.is_large(body) && b.vertex_rule == "scaled"
                    ? static_cast<int>(std::lround(b.size_ratio * b.vertices))
                    : b.vertices;
  RandomStream draw(static_cast<std::uint64_t>(c.general.seed), Purpose::body_angle,
                    static_cast<std::uint64_t>(body));
  const ShapeSpec shape = shape_spec(b, n, sizes.is_large(body));
  add_polygon(system, centre, area, n, draw.uniform(0, 2 * pi), b.diameter_ratio, shape);
  if (b.family == "rough_disc") return make_rigid(system, body);
  if (shape.shape_parameter <= least_shape_parameter(n) * (1 + 1e-9)) return;
  // With edges too long for it the regular polygon is a saddle: it would stay one to rounding. A small push
  // lets it buckle.
  for (int i = system.topology.begin[body]; i < system.topology.begin[body + 1]; ++i)
    system.state.position[i] += 0.01 * draw.uniform(-1, 1) * (system.state.position[i] - centre);
}

/// Random positions in the cell, moved apart and away from its walls, as soft discs of these radii, until
/// none overlap or as far as can be.
std::vector<Vec2> random_centres(const std::vector<double>& radius, const Box<2>& box, std::int64_t seed) {
  System<2> discs;
  discs.box = box;
  for (std::size_t k = 0; k < radius.size(); ++k) {
    RandomStream draw(static_cast<std::uint64_t>(seed), Purpose::body_position, k);
    const double x = draw.uniform(0, box.length[0]);
    add_disc_body(discs, {x, draw.uniform(0, box.length[1])}, 1.02 * radius[k]);
  }
  ForceField field(std::make_shared<RoughContacts>(Harmonic{1, true}));
  field.set_walls({.repulsion = Harmonic{4, true}});
  BodyObjective objective(discs, field, {1e-3, 1e-8});
  std::vector<double> x = objective.coordinates();
  MinimiseSpec spec;
  spec.method = Minimiser::fire;
  spec.max_evaluations = 20000;
  minimise(objective, x, spec);
  return discs.state.position;
}

/// Of this shape of the cell: height over width, periodic or between walls. Its lengths follow from the
/// packing fraction.
struct Enclosure {
  double aspect_ratio = 1;
  std::array<bool, 2> periodic{true, true};
};

System<2> random_packing(const Case& c, double packing_fraction_wanted, const Enclosure& enclosure = {}) {
  const int bodies = c.bodies.count + (has_polygons(c.bodies) ? c.bodies.discs : 0);
  System<2> sample;  // far apart, for sizes
  sample.box.length = {1e4 * bodies, 1e4 * bodies};
  for (int b = 0; b < bodies; ++b) add_particle(c, b, {1e2 * b, 0}, sample);
  const Outline outline = c.contact.kind == "smooth" ? Outline::smooth : Outline::rough;
  double area = 0;
  for (double a : packing_fraction(sample, outline).area) area += a;
  std::vector<double> radius;
  for (int b = 0; b < bodies; ++b) radius.push_back(outer_radius(sample, b));
  Box<2> box;
  box.periodic = enclosure.periodic;
  const double width = std::sqrt(area / packing_fraction_wanted / enclosure.aspect_ratio);
  box.length = {width, enclosure.aspect_ratio * width};
  const double widest = 2 * *std::max_element(radius.begin(), radius.end());
  const double least = box.periodic[0] ? 2 * widest : widest;
  const double shorter = std::min(box.length[0], box.length[1]);
  if (shorter < least)
    throw input_error(
        fmt::format("{} particles at packing fraction {} in a {} cell", bodies, packing_fraction_wanted,
                    box.periodic[0] ? "periodic" : "walled"),
        fmt::format("the cell is {:.3g} wide and the largest particle {:.3g}: it {}", shorter, widest,
                    box.periodic[0] ? "would meet a neighbour on two sides" : "does not fit in"),
        "raise bodies.N");
  const std::vector<Vec2> centre = random_centres(radius, box, c.general.seed);
  System<2> system;
  system.box = box;
  for (int b = 0; b < bodies; ++b) add_particle(c, b, centre[b], system);
  if (const Soundness s = look_at(system, outline); s.inside + s.crossing > 0 && c.contact.unsound == "stop")
    throw input_error(fmt::format("random particles at packing fraction {}", packing_fraction_wanted),
                      fmt::format("there is no room, of {} particles: {}", bodies, s.what()),
                      "start at a lower one, and compress");
  return system;
}

double mean_radius(const System<2>& system) {
  double sum = 0;
  for (double r : system.state.radius) sum += r;
  return sum / system.state.size();
}

}  // namespace

std::shared_ptr<ForceField> make_body_field(const Case& c) {
  const Harmonic law = contact_law(c);
  std::shared_ptr<BodyContacts> contacts;
  if (c.contact.kind == "smooth") contacts = std::make_shared<SmoothContacts>(law);
  else contacts = std::make_shared<RoughContacts>(law);
  auto field = std::make_shared<ForceField>(std::move(contacts));
  field->terms().add(std::make_shared<PolygonShape>());
  return field;
}

WallLaw wall_law(const Case& c) {
  WallLaw walls;
  walls.repulsion = contact_law(c);
  walls.repulsion.stiffness *= c.contact.k_p;
  walls.floor_friction = c.contact.floor_friction;
  return walls;
}

namespace {

void check_initial(const InitialState* initial) {
  if (initial && initial->system.topology.begin.empty())
    throw input_error("the state to start from holds no bodies", "its discs are of the microgel model",
                      "start from a run of deformable particles, or from [bodies]");
  if (initial && initial->system.box.strain_rate != 0)
    throw input_error("the state to start from is being sheared", "bodies move in a cell that is not");
}

bool is_periodic(const System<2>& system) { return system.box.periodic[0] && system.box.periodic[1]; }

/// What acts on particles of a state from outside: walls where its cell is not periodic, and gravity.
void surround(const Case& c, const Environment& environment, Packing& p) {
  p.field->external().gravity = environment.gravity;
  if (is_periodic(p.system)) return;
  WallLaw walls = wall_law(c);
  walls.stands = environment.stands;
  p.field->set_walls(walls);
}

/// Of all polygons and discs.
double area_of_shapes(const System<2>& system) {
  const std::vector<double> areas = measure_shapes(system).area;
  return std::accumulate(areas.begin(), areas.end(), 0.0);
}

std::string what_to_do_about_start(const Soundness& s) {
  if (!s.has_areas()) return "order the sites of a particle counter-clockwise round its area, unwrapped";
  const bool only_open = s.inside + s.crossing == 0;
  return fmt::format("{}, or go on with contact.unsound = \"mark\"",
                     only_open ? "give wider vertices (bodies.diameter_ratio) or contact.kind = \"smooth\""
                               : "move them apart");
}

/// Input error where line tension would shrink a particle to a point.
void check_tension(const System<2>& s) {
  const Topology<2>& t = s.topology;
  for (std::size_t b = 0; b < s.shape.stiffness.size(); ++b) {
    const ShapeStiffness& k = s.shape.stiffness[b];
    if (!(k.tension > 0)) continue;
    const auto begin = static_cast<std::size_t>(t.facet_begin[b]), end = static_cast<std::size_t>(t.facet_begin[b + 1]);
    const double most = collapsing_tension(k, s.shape.rest_volume[b],
                                           std::span(s.shape.rest_facet).subspan(begin, end - begin));
    if (k.tension < most) continue;
    throw input_error(
        fmt::format("the line tension of particle {} is {:.4g} times what its area and edges bear", b, k.tension / most),
        "it has no equilibrium: it shrinks to a point",
        fmt::format("lower bodies.gamma below {:.4g} of what it is, or raise bodies.k_a or bodies.k_l", most / k.tension));
  }
}

/// What the case says of these particles.
Packing packing_of(const Case& c, System<2> system) {
  require_sane(system, "this packing");
  check_tension(system);
  Packing p;
  p.system = std::move(system);
  p.field = make_body_field(c);
  p.outline = c.contact.kind == "smooth" ? Outline::smooth : Outline::rough;
  p.on_unsound = c.contact.unsound == "mark" ? OnUnsound::mark : OnUnsound::stop;
  if (const Soundness s = look_at(p); must_stop(p, s))
    throw input_error("the packing to start from: " + s.what(), "", what_to_do_about_start(s));
  const Harmonic law = contact_law(c);
  const auto& stiffness = p.system.shape.stiffness;
  double smallest = 0;
  for (std::size_t b = 0; b < stiffness.size(); ++b) {
    const double area = p.system.shape.rest_volume[b];
    if (stiffness[b].volume == 0 || (smallest > 0 && area >= smallest)) continue;
    smallest = area;
    p.pressure_unit = stiffness[b].volume * area;
  }
  if (smallest == 0) {
    p.pressure_unit =
        law.spring(2 * *std::min_element(p.system.state.radius.begin(), p.system.state.radius.end()));
    p.pressure_symbol = law.relative ? "k_c/sigma^2" : "k_c";
  }
  p.shape_area = area_of_shapes(p.system);
  p.covered_area = packing_fraction(p.system, p.outline).total * p.system.box.volume();
  p.minimise.method = minimiser_named(c.minimise.method);
  p.minimise.max_evaluations = c.minimise.max_evaluations;
  p.contact_pressure = c.jamming.pressure_kind == "contact";
  p.tolerance.relative = c.minimise.force_tolerance;
  p.tolerance.least = c.minimise.least_force > 0 ? c.minimise.least_force
                                                 : c.minimise.force_tolerance * c.jamming.pressure *
                                                       p.pressure_unit * 2 * mean_radius(p.system);
  return p;
}

/// The particles of a state with the stiffnesses of the case.
System<2> given_system(const Case& c, const InitialState& initial) {
  System<2> system = initial.system;
  give_stiffness(c, system);
  return system;
}

}  // namespace

Packing make_packing(const Case& c, const InitialState* initial, double packing_fraction_wanted) {
  check_initial(initial);
  Packing p = packing_of(c, initial ? given_system(c, *initial) : random_packing(c, packing_fraction_wanted));
  if (initial) surround(c, initial->environment, p);
  return p;
}

Packing make_boxed_packing(const Case& c, const InitialState* initial, double packing_fraction_wanted,
                           double aspect_ratio) {
  check_initial(initial);
  if (initial && (initial->system.box.periodic[0] || initial->system.box.periodic[1]))
    throw input_error("the state to start from is periodic",
                      fmt::format("{} needs a box of walls", c.general.experiment),
                      "start from a run between walls, or from [bodies]");
  if (initial && !(initial->environment.is_closed() && initial->environment.gravity == Vec2{}))
    throw input_error("the state to start from lies under gravity, or without some of the walls",
                      fmt::format("{} is about particles between four walls, without weight", c.general.experiment),
                      "start from a run of it, or from [bodies]");
  const Enclosure walled{aspect_ratio, {false, false}};
  Packing p =
      packing_of(c, initial ? given_system(c, *initial) : random_packing(c, packing_fraction_wanted, walled));
  WallLaw walls = wall_law(c);
  walls.floor_friction = 0;  // friction has no energy to minimise
  p.field->set_walls(walls);
  return p;
}

Packing make_periodic_packing(const Case& c, const InitialState* initial) {
  if (initial && !is_periodic(initial->system))
    throw input_error("the state to start from lies between walls",
                      fmt::format("{} shrinks a periodic cell", c.general.experiment),
                      "start from a periodic packing");
  return make_packing(c, initial, c.jamming.packing_fraction);
}

double covered_fraction(const Packing& packing) {
  return packing.outline == Outline::rough ? rough_sum(packing.system).total
                                           : packing_fraction(packing.system, packing.outline).total;
}

PackingState observe(Packing& packing) {
  Evaluation<2> all, contacts;
  packing.field->evaluate(packing.system, Detail::energies, all);
  contacts.force.resize(all.force.size());
  contacts.torque.resize(all.force.size());
  packing.field->bodies()->evaluate(packing.system, Detail::energies, contacts);
  const double scale = 1 / (packing.system.box.volume() * packing.pressure_unit);
  PackingState s;
  s.packing_fraction =
      packing.covered_area * (area_of_shapes(packing.system) / packing.shape_area) / packing.system.box.volume();
  s.stress = scale * all.virial;
  s.full_pressure = 0.5 * (s.stress[0][0] + s.stress[1][1]);
  s.contact_pressure = 0.5 * scale * (contacts.virial[0][0] + contacts.virial[1][1]);
  s.pressure = packing.contact_pressure ? s.contact_pressure : s.full_pressure;
  s.energy = all.energy.stored();
  return s;
}

}  // namespace supple
