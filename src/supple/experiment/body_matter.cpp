#include <fmt/format.h>

#include "supple/core/duration.hpp"
#include "supple/experiment/bodies_of_case.hpp"
#include "supple/experiment/cost.hpp"
#include "supple/experiment/given_packing.hpp"
#include "supple/experiment/matter.hpp"
#include "supple/model/polygons.hpp"

namespace supple {

namespace {

/// What would be known only after hours, or when memory is used up.
void check_cost(const Case& c, Problems& problems) {
  const BodySizes sizes(c.bodies);
  if (sizes.sites() <= most_sites) return;
  const double sites = static_cast<double>(sizes.sites());
  add_problem(
      problems, c,
      fmt::format("{} particles of {} vertices are {:.3g} vertices", sizes.bodies(), c.bodies.vertices,
                  sites),
      fmt::format("a run can have {:g}; these would need about {:.3g} GB of memory, and to jam them {}",
                  1.0 * most_sites, sites * bytes_per_site * 1e-9, describe_seconds(seconds_to_jam(sites))),
      "lower bodies.N or bodies.vertices");
}

void check_shape(const Case& c, Problems& problems) {
  const Bodies& b = c.bodies;
  const bool polygons = b.family != "disc";
  const double least = least_shape_parameter(b.vertices);
  if (polygons && b.shape_parameter > 0 && b.shape_parameter < least * (1 - 1e-12))
    add_problem(problems, c,
                fmt::format("bodies.A0 = {} with bodies.vertices = {}", b.shape_parameter, b.vertices),
                fmt::format("p^2/(4 pi a) of a polygon is at least N tan(pi/N)/pi = {:.6f}", least),
                "raise A0, or 0 for the regular polygon");
  if (c.is_given("bodies.A0") && b.shape_ratio > 0)
    add_problem(problems, c, "bodies.A0 and bodies.A0_ratio",
                "the second is the first over that of the regular polygon", "leave one away");
  for (const auto& [key, ratio] :
       {std::pair{"A0_ratio", b.shape_ratio}, {"A0_ratio_large", b.shape_ratio_large}})
    if (polygons && ratio > 0 && ratio < 1)
      add_problem(problems, c, fmt::format("bodies.{} = {}", key, ratio),
                  "no polygon is rounder than the regular one", "give 1 or more, or 0 for the default");
}

void check_bodies(const Case& c, Start, Problems& problems) {
  if (c.initial.state.empty() && c.initial.packing.empty()) check_cost(c, problems);
  check_shape(c, problems);
  if (!c.initial.state.empty() && !c.initial.packing.empty())
    add_problem(problems, c, "initial.state and initial.packing", "a run starts from one of them",
                "leave one away");
  if (c.bodies.family == "rough_disc" && c.contact.kind == "smooth")
    add_problem(problems, c, "bodies.family = \"rough_disc\" with contact.kind = \"smooth\"",
                "a rough disc is a ring of vertices",
                "set contact.kind = \"rough\", or family = \"disc\" for smooth discs");
}

void doubt_bodies(const Case& c, Doubts& doubts) {
  const Bodies& b = c.bodies;
  const bool soft = b.family != "disc" && b.family != "rough_disc";
  if (soft && b.family == "floppy" && b.k_b > 0)
    doubts.push_back("bodies.k_b > 0: floppy particles have none, these are shells");
  if (b.family != "disc" && c.contact.kind == "rough" && b.diameter_ratio < 1)
    doubts.push_back(fmt::format(
        "bodies.diameter_ratio = {}: edges are {:.3g} times as long as vertices are wide{}", b.diameter_ratio,
        1 / b.diameter_ratio,
        b.diameter_ratio > 0.5
            ? "; from 2 on, stretched edges among them, vertices of others pass between two vertices"
            : ", so that vertices of other particles pass between two vertices"));
  if (soft && b.gamma > 0 && b.k_l < 0.1 * b.gamma)
    doubts.push_back(
        fmt::format("bodies.gamma = {} with k_l = {}: line tension alone does not keep vertices apart. "
                    "They gather, and edges get so long that others pass; give k_l of 0.1 gamma or more",
                    b.gamma, b.k_l));
}

HeldKeys keys_of_bodies(const InitialState& initial) {
  const System<2>& s = initial.system;
  return {{"bodies.N", static_cast<std::int64_t>(s.topology.body_count(s.state.size()))}};
}

void adopt_bodies(Case& c, const InitialState& initial) {
  if (initial.contact) {
    if (!c.is_given("contact.k_c")) c.contact.k_c = initial.contact->stiffness;
    if (!c.is_given("bodies.stiffness"))
      c.bodies.stiffness = initial.contact->relative ? "relative" : "absolute";
  }
  adopt_stiffness(c, initial.system);
  const double weight = -initial.environment.gravity[gradient];
  if (weight > 0 && !c.is_given("slump.gravity")) c.slump.gravity = weight;
}

std::string describe_bodies(const Case& c, const InitialState* initial) {
  if (!initial) return fmt::format("{} particles ({})", BodySizes(c.bodies).bodies(), c.bodies.family);
  const System<2>& s = initial->system;
  return fmt::format("{} particles of a file", s.topology.body_count(s.state.size()));
}

}  // namespace

const Matter& body_matter() {
  static const Matter bodies{.name = "deformable particles",
                             .physics = "deformable",
                             .is_held = [](const System<2>& s) { return !s.topology.begin.empty(); },
                             .check = check_bodies,
                             .doubt = doubt_bodies,
                             .known = keys_of_bodies,
                             .adopt = adopt_bodies,
                             .curves = {{"total", "total"}, {"virial", "virial"}},
                             .sites = [](const Case& c) { return BodySizes(c.bodies).sites(); },
                             .describe = describe_bodies};
  return bodies;
}

}  // namespace supple
