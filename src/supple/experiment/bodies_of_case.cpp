#include "supple/experiment/bodies_of_case.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <vector>

#include "supple/build/surfaces.hpp"
#include "supple/core/error.hpp"
#include "supple/core/parallel.hpp"
#include "supple/core/random.hpp"
#include "supple/energy/perimeter.hpp"
#include "supple/experiment/random_centres.hpp"
#include "supple/model/add_sites.hpp"
#include "supple/model/bodies.hpp"
#include "supple/model/polygons.hpp"
#include "supple/model/sanity.hpp"
#include "supple/observe/packing_fraction.hpp"
#include "supple/observe/plain_area.hpp"
#include "supple/observe/soundness.hpp"

namespace supple {

namespace {

using std::numbers::pi;

Outline outline_of(const Case& c) { return c.contact.kind == "smooth" ? Outline::smooth : Outline::rough; }

double preferred_area(const Species& s) { return s.diameter * s.diameter; }

/// With edges too long for it the regular polygon is a saddle: it would stay one to rounding. A small push
/// lets it buckle, another one each particle.
bool buckles(const Case& c, const ParticleKind& p) {
  return is_soft(p) && preferred_shape_parameter(c, p) > least_shape_parameter(c, p) * (1 + 1e-9);
}

/// Whether each particle of the kind is another one.
bool is_drawn(const Case& c, const ParticleKind& p) { return buckles(c, p) || p.family == "network"; }

/// Largest push of a vertex, over its distance from the centre: a quarter of an edge at most, or a ring of
/// very many vertices would be a saw with teeth longer than the vertices are wide.
double largest_push(int vertices) { return std::min(0.01, 0.5 * std::sin(pi / vertices)); }

void add_solid_particle(const Case& c, const Species& species, int body, const Vec2& centre, double angle,
                        System<2>& system) {
  const SolidSpec spec = solid_spec(species);
  SolidMesh<2> mesh = solid_mesh<2>(spec, species.vertices, network_seed(c.general.seed, body));
  const Vec2 turn = species.diameter * Vec2{std::cos(angle), std::sin(angle)};
  for (Vec2& x : mesh.node)
    x = centre + Vec2{turn[0] * x[0] - turn[1] * x[1], turn[1] * x[0] + turn[0] * x[1]};
  add_solid(system, mesh, species.diameter_ratio, spec);
}

/// Adds the particle `body` of the case, of this species, about a centre.
void add_particle(const Case& c, const Species& species, int body, const Vec2& centre, System<2>& system) {
  const double area = preferred_area(species);
  if (is_disc(species)) return add_disc_body(system, centre, std::sqrt(area / pi));
  RandomStream draw(static_cast<std::uint64_t>(c.general.seed), Purpose::body_angle,
                    static_cast<std::uint64_t>(body));
  const int index = system.topology.body_count(system.state.size());
  if (is_solid(species)) return add_solid_particle(c, species, body, centre, draw.uniform(0, 2 * pi), system);
  add_polygon(system, centre, area, species.vertices, draw.uniform(0, 2 * pi), species.diameter_ratio,
              shape_spec(c, species));
  if (is_rigid(species)) return make_rigid(system, index);
  if (species.k_perimeter > 0) {
    const std::vector<double>& edges = system.shape.rest_facet;
    const double rest = std::accumulate(edges.end() - species.vertices, edges.end(), 0.0);
    const double stiffness =
        c.bodies.stiffness == "relative" ? species.k_perimeter / (rest * rest) : species.k_perimeter;
    set_body_term(system.terms, Perimeter::name, index, std::array{stiffness, rest});
  }
  if (!buckles(c, species)) return;
  const double push = largest_push(species.vertices);
  for (int i = system.topology.begin[index]; i < system.topology.begin[index + 1]; ++i)
    system.state.position[i] += push * draw.uniform(-1, 1) * (system.state.position[i] - centre);
}

/// The place of each particle's species in the case.
std::vector<std::int32_t> places_of_bodies(const Case& c) {
  std::vector<std::int32_t> places;
  for (std::size_t k = 0; k < c.species.size(); ++k)
    places.insert(places.end(), static_cast<std::size_t>(c.species[k].count), static_cast<std::int32_t>(k));
  return places;
}

/// The species of each particle.
std::vector<const Species*> species_of_bodies(const std::vector<Species>& all) {
  std::vector<const Species*> of_body;
  for (const Species& s : all) of_body.insert(of_body.end(), static_cast<std::size_t>(s.count), &s);
  return of_body;
}

/// The widest particle of the case.
double widest_particle(const Case& c, const std::vector<Species>& all) {
  double widest = 0;
  int first = 0;
  for (const Species& s : all) {
    System<2> alone;
    add_particle(c, s, first, {}, alone);
    const double width = 2 * outer_radius(alone, 0);
    alone.box.length = {width, width};
    require_sane(alone, "these particles");
    widest = std::max(widest, width);
    first += s.count;
  }
  return widest;
}

struct LooseBody {
  double area = 0, radius = 0;
};

/// One particle with nothing else as far as `apart` of it.
LooseBody measure_alone(const Case& c, const Species& species, int body, const Vec2& centre, double apart) {
  System<2> alone;
  add_particle(c, species, body, centre, alone);
  alone.box.length = {apart, apart};
  return {packing_fraction(alone, outline_of(c)).volume[0], outer_radius(alone, 0)};
}

/// The same of a body of a system. In closed form; or about the origin in a cell
/// that it fills, as outlines that nearly touch themselves want a small tolerance, which follows the cell.
LooseBody measure_here(const Case& c, const Species& species, int body, const System<2>& system, int index) {
  const int first = system.topology.body_begin(index);
  const std::span ring(system.state.position.data() + first,
                       static_cast<std::size_t>(system.topology.boundary_size(index)));
  const double radius = outer_radius(system, index);
  if (const auto area = plain_area(ring, system.state.radius[first], outline_of(c))) return {*area, radius};
  return measure_alone(c, species, body, {}, 4 * radius);
}

/// The same, made for this alone.
LooseBody measure_here(const Case& c, const Species& species, int body) {
  System<2> alone;
  add_particle(c, species, body, {}, alone);
  return measure_here(c, species, body, alone, 0);
}

/// One of each species that the case does not draw.
std::map<const Species*, LooseBody> measure_kinds(const Case& c, const std::vector<Species>& all) {
  std::map<const Species*, LooseBody> found;
  for (const Species& s : all)
    if (!is_drawn(c, s)) found[&s] = measure_here(c, s, 0);
  return found;
}

}  // namespace

std::vector<Species> species_of(const Case& c) {
  if (!c.species.empty()) return c.species;
  const Bodies& b = c.bodies;
  const auto large_count = static_cast<int>(std::lround(b.large_fraction * b.count));
  Species small{b, 1, {}}, large{b, b.size_ratio, {}}, disc{b, 1, {}};
  small.count = b.count - large_count;
  large.count = large_count;
  if (b.vertex_rule == "scaled" && b.dimensions == 2)
    large.vertices = static_cast<int>(std::lround(b.size_ratio * b.vertices));
  if (b.shape_ratio_large > 0) large.shape_ratio = b.shape_ratio_large;
  disc.family = "disc";
  disc.count = is_disc(b) ? 0 : b.discs;
  std::vector<Species> all;
  for (const Species& s : {small, large, disc})
    if (s.count > 0) all.push_back(s);
  return all;
}

bool is_disc(const ParticleKind& kind) { return kind.family == "disc" || kind.family == "sphere"; }
bool is_rigid(const ParticleKind& kind) {
  return kind.family == "rough_disc" || kind.family == "rough_sphere";
}
bool is_solid(const ParticleKind& kind) { return kind.family == "network" || kind.family == "elastic"; }
bool is_soft(const ParticleKind& kind) { return !is_disc(kind) && !is_rigid(kind) && !is_solid(kind); }

SolidSpec solid_spec(const ParticleKind& kind) {
  return {kind.family == "network" ? Filling::network : Filling::elements,
          kind.k_s,
          {kind.young_modulus, kind.poisson_ratio}};
}

double least_shape_parameter(const Case& c, const ParticleKind& kind) {
  if (c.bodies.dimensions == 2) return least_shape_parameter(kind.vertices);
  if (is_disc(kind) || nearest_geodesic(kind.vertices) != kind.vertices) return 1;
  const TriangleMesh mesh = geodesic_icosahedron(kind.vertices);
  const std::vector<double> areas = face_areas(mesh);
  return surface_shape_parameter(std::accumulate(areas.begin(), areas.end(), 0.0), enclosed_volume(mesh));
}

double preferred_shape_parameter(const Case& c, const ParticleKind& kind) {
  if (!is_soft(kind)) return 0;
  return kind.shape_ratio > 0 ? kind.shape_ratio * least_shape_parameter(c, kind) : kind.shape_parameter;
}

ShapeSpec shape_spec(const Case& c, const ParticleKind& kind) {
  const bool flat = c.bodies.dimensions == 2;
  return {flat ? kind.k_a : kind.k_v,
          flat ? kind.k_l : kind.k_a,
          kind.k_b,
          kind.gamma,
          c.bodies.stiffness == "relative" ? StiffnessKind::relative : StiffnessKind::absolute,
          preferred_shape_parameter(c, kind)};
}

bool has_polygons(const Case& c) {
  const std::vector<Species> all = species_of(c);
  return std::any_of(all.begin(), all.end(), [](const Species& s) { return !is_disc(s); });
}
bool has_soft(const Case& c) {
  const std::vector<Species> all = species_of(c);
  return std::any_of(all.begin(), all.end(), [](const Species& s) { return is_soft(s); });
}

std::string families_of(const Case& c) {
  if (c.species.empty()) return c.bodies.family;
  std::vector<std::string> names;
  for (const Species& s : c.species) names.push_back(fmt::format("{} {}", s.count, s.family));
  return fmt::format("{}", fmt::join(names, ", "));
}

SampleSize sample_size(const Case& c) {
  SampleSize count;
  for (const Species& s : species_of(c)) {
    count.bodies += s.count;
    count.sites += std::int64_t{s.count} * (is_disc(s) ? 1 : s.vertices + (s.family == "elastic" ? 1 : 0));
  }
  return count;
}

LooseBodies loose_bodies(const Case& c, double packing_fraction_wanted, const Enclosure& enclosure,
                         const System<2>* set_apart) {
  const std::vector<Species> all = species_of(c);
  const std::vector<const Species*> species = species_of_bodies(all);
  const auto bodies = static_cast<int>(species.size());
  LooseBodies loose;
  const double pitch = std::max(1e2, 1.1 * widest_particle(c, all));
  const double apart = std::max(1e4, 2 * pitch) * bodies;
  std::vector<double> area(static_cast<std::size_t>(bodies));
  loose.radius.resize(area.size());
  std::map<const Species*, LooseBody> kinds;
  if (set_apart) kinds = measure_kinds(c, all);
  for_chunks(bodies, [&](std::int64_t, std::int64_t begin, std::int64_t end) {
    for (auto b = static_cast<int>(begin); b < end; ++b) {
      const auto known = kinds.find(species[b]);
      const auto measured = [&] {
        if (is_drawn(c, *species[b]))
          return set_apart ? measure_here(c, *species[b], b, *set_apart, b) : measure_here(c, *species[b], b);
        // Every packing follows, to the last bit, from areas there.
        return known != kinds.end() ? known->second : measure_alone(c, *species[b], b, {pitch * b, 0}, apart);
      };
      const LooseBody body = measured();
      area[b] = body.area;
      loose.radius[b] = body.radius;
    }
  });
  for (const double a : area) loose.area += a;
  Box<2>& cell = loose.cell;
  cell.periodic = enclosure.periodic;
  const double width = std::sqrt(loose.area / packing_fraction_wanted / enclosure.aspect_ratio);
  cell.length = {width, enclosure.aspect_ratio * width};
  const double widest = 2 * *std::max_element(loose.radius.begin(), loose.radius.end());
  const double least = cell.periodic[0] ? 2 * widest : widest;
  const double shorter = std::min(cell.length[0], cell.length[1]);
  if (shorter < least)
    throw input_error(
        fmt::format("{} particles at packing fraction {} in a {} cell", bodies, packing_fraction_wanted,
                    cell.periodic[0] ? "periodic" : "walled"),
        fmt::format("the cell is {:.3g} wide and the largest particle {:.3g}: it {}", shorter, widest,
                    cell.periodic[0] ? "would meet a neighbour on two sides" : "does not fit in"),
        "raise bodies.N");
  return loose;
}

namespace {

void reserve_for(const Case& c, System<2>& system) {
  const SampleSize count = sample_size(c);
  reserve_polygons(system, static_cast<std::size_t>(count.bodies), static_cast<std::size_t>(count.sites));
}

}  // namespace

System<2> particles_apart(const Case& c) {
  const std::vector<Species> all = species_of(c);
  const std::vector<const Species*> species = species_of_bodies(all);
  const auto bodies = static_cast<int>(species.size());
  const double pitch = 2 * widest_particle(c, all);
  const auto side = static_cast<int>(std::ceil(std::sqrt(bodies)));
  System<2> system;
  reserve_for(c, system);
  system.box.length = {pitch * side, pitch * side};
  for (int b = 0; b < bodies; ++b)
    add_particle(c, *species[b], b, {pitch * (b % side + 0.5), pitch * (b / side + 0.5)}, system);
  system.species = places_of_bodies(c);
  return system;
}

System<2> random_packing(const Case& c, double packing_fraction_wanted, const Enclosure& enclosure,
                         const std::function<bool()>& stop_requested) {
  const LooseBodies loose = loose_bodies(c, packing_fraction_wanted, enclosure);
  const std::vector<Vec2> centre = random_centres(loose.radius, loose.cell, c.general.seed, stop_requested);
  const std::vector<Species> all = species_of(c);
  const std::vector<const Species*> species = species_of_bodies(all);
  System<2> system;
  reserve_for(c, system);
  system.box = loose.cell;
  for (std::size_t b = 0; b < species.size(); ++b)
    add_particle(c, *species[b], static_cast<int>(b), centre[b], system);
  system.species = places_of_bodies(c);
  if (const Soundness s = look_at(system, outline_of(c));
      s.inside + s.crossing > 0 && c.contact.unsound == "stop")
    throw input_error(fmt::format("random particles at packing fraction {}", packing_fraction_wanted),
                      fmt::format("there is no room, of {} particles: {}", species.size(), s.what()),
                      "start at a lower one, and compress");
  return system;
}

}  // namespace supple
