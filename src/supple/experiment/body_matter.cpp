#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "supple/build/surfaces.hpp"
#include "supple/core/duration.hpp"
#include "supple/experiment/bodies_of_case.hpp"
#include "supple/experiment/cost.hpp"
#include "supple/experiment/given_packing.hpp"
#include "supple/experiment/matter.hpp"
#include "supple/experiment/pairs_of_case.hpp"
#include "supple/experiment/used_keys.hpp"

namespace supple {

namespace {

/// What would be known only after hours, or when memory is used up.
void check_cost(const Case& c, Problems& problems) {
  const SampleSize count = sample_size(c);
  if (count.sites <= most_sites) return;
  const double sites = static_cast<double>(count.sites);
  const std::string of_each =
      c.species.empty() ? fmt::format(" of {} vertices", c.bodies.vertices) : std::string();
  add_problem(
      problems, c, fmt::format("{} particles{} are {:.3g} vertices", count.bodies, of_each, sites),
      fmt::format("a run can have {:g}; these would need about {:.3g} GB of memory, and to jam them {}",
                  1.0 * most_sites, sites * bytes_per_site * 1e-9, describe_seconds(seconds_to_jam(sites))),
      c.species.empty() ? "lower bodies.N or bodies.vertices" : "lower N or vertices of species");
}

/// Vertices within the width of each vertex on its own ring, of all of them: about as many of another ring
/// each one touches, and remembers, where two particles meet.
double vertices_within_widths(const Case& c) {
  double sum = 0;
  for (const Species& s : species_of(c)) {
    if (is_disc(s)) continue;
    const double least = least_shape_parameter(c, s);
    const double given = s.shape_ratio > 0 ? s.shape_ratio * least : s.shape_parameter;
    const double wanted = is_soft(s) ? std::max(given, least) : least;
    const double edges = s.diameter_ratio * std::sqrt(wanted / least);             // those of the regular one
    const double within = c.bodies.dimensions == 2 ? edges : 3.6 * edges * edges;  // six at one edge
    sum += 1.0 * s.count * s.vertices * std::clamp(within, 1.0, 1.0 * s.vertices);
  }
  return sum;
}

/// The same as check_cost, of vertices that reach over very many edges.
void check_widths(const Case& c, Problems& problems) {
  constexpr double most = 10.0 * most_sites;
  const double within = vertices_within_widths(c);
  if (within <= most) return;
  add_problem(
      problems, c, fmt::format("vertices reach over {:.3g} others of their own ring", within),
      fmt::format("a run can have {:g} such pairs; each vertex touches as many of another particle", most),
      c.species.empty() ? "lower bodies.diameter_ratio, bodies.A0 or bodies.vertices"
                        : "lower diameter_ratio, A0 or vertices of species");
}

/// The kinds of particles that the case describes, with the sections that do.
std::vector<std::pair<std::string, const ParticleKind*>> kinds_of(const Case& c) {
  std::vector<std::pair<std::string, const ParticleKind*>> kinds;
  for (std::size_t k = 0; k < c.species.size(); ++k) kinds.emplace_back(species_section(k), &c.species[k]);
  if (kinds.empty()) kinds.emplace_back("bodies", &c.bodies);
  return kinds;
}

void check_ratio(const Case& c, const std::string& key, double ratio, Problems& problems) {
  if (ratio > 0 && ratio < 1)
    add_problem(problems, c, fmt::format("{} = {}", key, ratio), "no polygon is rounder than the regular one",
                "give 1 or more, or 0 for the default");
}

/// What particles of so many dimensions are made of.
void check_dimensions(const Case& c, const std::string& section, const ParticleKind& p, Problems& problems) {
  const bool flat = c.bodies.dimensions == 2;
  const auto refuse = [&](const std::string& what, const std::string& why, const std::string& to_do) {
    add_problem(problems, c, fmt::format("{}.{} with bodies.dim = {}", section, what, c.bodies.dimensions),
                why, to_do);
  };
  for (const auto& [disc, sphere] : {std::pair("disc", "sphere"), std::pair("rough_disc", "rough_sphere")}) {
    if (flat && p.family == sphere)
      refuse(fmt::format("family = \"{}\"", sphere), "spheres are of three dimensions",
             fmt::format("set family = \"{}\", or bodies.dim = 3", disc));
    if (!flat && p.family == disc)
      refuse(fmt::format("family = \"{}\"", disc), "discs are of two dimensions",
             fmt::format("set family = \"{}\"", sphere));
  }
  if (const int nearest = nearest_geodesic(p.vertices);
      !flat && !is_disc(p) && p.family != "network" && nearest != p.vertices)
    refuse(fmt::format("vertices = {}", p.vertices),
           "a geodesic sphere has 12, 42, 162, 642 ... of them: triangles of an icosahedron cut into four",
           fmt::format("take {}", nearest));
}

void check_kind(const Case& c, const std::string& section, const ParticleKind& p, Problems& problems) {
  const bool flat = c.bodies.dimensions == 2;
  const double least = least_shape_parameter(c, p);
  if (!is_disc(p) && p.shape_parameter > 0 && p.shape_parameter < least * (1 - 1e-12))
    add_problem(problems, c,
                fmt::format("{0}.A0 = {1} with {0}.vertices = {2}", section, p.shape_parameter, p.vertices),
                flat ? fmt::format("p^2/(4 pi a) of a polygon is at least N tan(pi/N)/pi = {:.6f}", least)
                     : fmt::format("s^1.5/(6 sqrt(pi) v) of the geodesic sphere is {:.6f}", least),
                flat ? "raise A0, or 0 for the regular polygon" : "raise A0, or 0 for the geodesic sphere");
  if (c.is_given(section + ".A0") && p.shape_ratio > 0)
    add_problem(problems, c, fmt::format("{0}.A0 and {0}.A0_ratio", section),
                "the second is the first over that of the regular polygon", "leave one away");
  if (!is_disc(p)) check_ratio(c, section + ".A0_ratio", p.shape_ratio, problems);
  if (p.family == "network" && c.is_given(section + ".E") && p.k_s > 0)
    add_problem(problems, c, fmt::format("{0}.E and {0}.k_s", section), "one follows from the other",
                "leave one away");
  if (p.family == "network" && p.k_s == 0 && !c.is_given(section + ".E"))
    add_problem(problems, c, fmt::format("{0}.k_s = 0", section), "nothing keeps the network together",
                "raise it, or give E");
  if (const double most = flat ? 1 : 0.5; p.family == "elastic" && p.poisson_ratio >= most)
    add_problem(problems, c, fmt::format("{}.nu = {}", section, p.poisson_ratio),
                "a material that keeps its volume has 0.5", "give less than 0.5");
  if (is_rigid(p) && c.contact.kind == "smooth")
    add_problem(problems, c,
                fmt::format("{}.family = \"{}\" with contact.kind = \"smooth\"", section, p.family),
                flat ? "a rough disc is a ring of vertices" : "a rough sphere is a surface of vertices",
                flat ? "set contact.kind = \"rough\", or family = \"disc\" for smooth discs"
                     : "set contact.kind = \"rough\", or family = \"sphere\" for smooth spheres");
}

/// Keys of [bodies] that say what [[species]] say.
void check_species(const Case& c, Problems& problems) {
  const auto is_of_species = [](const std::string& key) {
    return kind_of_section(section_of(key)) == "species";
  };
  if (std::none_of(c.given.begin(), c.given.end(), is_of_species)) return;  // none, or those of a state
  for (const Field<Bodies>& field : fields<Bodies>()) {
    const std::string key = fmt::format("bodies.{}", field.name);
    const bool of_all = field.name == "dim" || field.name == "stiffness" || field.name == "yield_strain" ||
                        field.name == "flow_time";
    if (!of_all && c.is_given(key))
      add_problem(problems, c, key + " with [[species]]", "these say what particles there are",
                  "give it in [[species]] in its place");
  }
}

void check_bodies(const Case& c, Start start, Problems& problems) {
  if (c.initial.state.empty() && c.initial.packing.empty()) {
    check_cost(c, problems);
    if (problems.empty()) check_widths(c, problems);
  }
  for (const auto& [section, kind] : kinds_of(c)) {
    if (start == Start::nothing) check_dimensions(c, section, *kind, problems);
    check_kind(c, section, *kind, problems);
  }
  if (!is_disc(c.bodies) && uses(c, "bodies.A0_ratio_large"))
    check_ratio(c, "bodies.A0_ratio_large", c.bodies.shape_ratio_large, problems);
  check_species(c, problems);
  check_pairs(c, problems);
  if (!c.initial.state.empty() && !c.initial.packing.empty())
    add_problem(problems, c, "initial.state and initial.packing", "a run starts from one of them",
                "leave one away");
}

void doubt_kind(const Case& c, const std::string& section, const ParticleKind& p, Doubts& doubts) {
  const bool flat = c.bodies.dimensions == 2;
  if (p.family == "floppy" && p.k_b > 0)
    doubts.push_back(fmt::format("{}.k_b > 0: floppy particles have none, these are shells", section));
  if (flat && !is_disc(p) && c.contact.kind == "rough" && p.diameter_ratio < 1)
    doubts.push_back(fmt::format(
        "{}.diameter_ratio = {}: edges are {:.3g} times as long as vertices are wide{}", section,
        p.diameter_ratio, 1 / p.diameter_ratio,
        p.diameter_ratio > 0.5
            ? "; from 2 on, stretched edges among them, vertices of others pass between two vertices"
            : ", so that vertices of other particles pass between two vertices"));
  if (const double k = flat ? p.k_l : p.k_a; is_soft(p) && p.gamma > 0 && k < 0.1 * p.gamma)
    doubts.push_back(
        fmt::format("{0}.gamma = {1} with {2} = {3}: {4} tension alone does not keep vertices apart. They "
                    "gather, and edges get so long that others pass; give {2} of 0.1 gamma or more",
                    section, p.gamma, flat ? "k_l" : "k_a", k, flat ? "line" : "surface"));
}

void doubt_bodies(const Case& c, Doubts& doubts) {
  for (const auto& [section, kind] : kinds_of(c)) doubt_kind(c, section, *kind, doubts);
  doubt_pairs(c, doubts);
}

HeldKeys keys_of_bodies(const InitialState& initial) {
  HeldKeys keys{{"bodies.N", std::int64_t{body_count(initial.system)}},
                {"bodies.dim", std::int64_t{dimensions_of(initial.system)}}};
  std::map<std::int32_t, std::int64_t> count;
  std::visit(
      [&](const auto& system) {
        for (const std::int32_t species : system.species) ++count[species];
      },
      initial.system);
  for (const auto& [species, n] : count) keys[species_section(static_cast<std::size_t>(species)) + ".N"] = n;
  return keys;
}

void adopt_bodies(Case& c, const InitialState& initial) {
  if (initial.contact) {
    if (!c.is_given("contact.k_c")) c.contact.k_c = initial.contact->stiffness;
    if (!c.is_given("bodies.stiffness"))
      c.bodies.stiffness = initial.contact->relative ? "relative" : "absolute";
  }
  std::visit([&](const auto& system) { adopt_stiffness(c, system); }, initial.system);
  const double weight = -initial.environment.gravity[gradient];
  if (weight > 0 && !c.is_given("slump.gravity")) c.slump.gravity = weight;
}

std::string describe_bodies(const Case& c, const InitialState* initial) {
  if (!initial) return fmt::format("{} particles ({})", sample_size(c).bodies, families_of(c));
  return fmt::format("{} particles of a file", body_count(initial->system));
}

}  // namespace

const Matter& body_matter() {
  static const Matter bodies{.name = "deformable particles",
                             .physics = "deformable",
                             .is_held = has_bodies,
                             .check = check_bodies,
                             .doubt = doubt_bodies,
                             .known = keys_of_bodies,
                             .adopt = adopt_bodies,
                             .curves = {{"plates", "plates"}, {"total", "total"}, {"virial", "virial"}},
                             .sites = [](const Case& c) { return sample_size(c).sites; },
                             .describe = describe_bodies};
  return bodies;
}

}  // namespace supple
