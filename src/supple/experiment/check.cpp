#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "supple/core/duration.hpp"
#include "supple/core/error.hpp"
#include "supple/experiment/bodies_of_case.hpp"
#include "supple/experiment/case.hpp"
#include "supple/experiment/cost.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/experiment/used_keys.hpp"
#include "supple/model/discs.hpp"
#include "supple/model/polygons.hpp"
#include "supple/model/sanity.hpp"

namespace supple {

namespace {

using Problems = std::vector<std::string>;

void add(Problems& problems, const Case& c, const std::string& what, const std::string& why,
         const std::string& to_do) {
  const std::string place = c.origin.empty() ? "" : c.origin + ": ";
  problems.push_back(input_error(place + what, why, to_do).what());
}

/// Of a number that cannot be computed with, a run would say no more than that a force is not finite.
void check_numbers(const Case& c, Problems& problems) {
  for_each_key(c, [&]<class P>(const std::string& key, const Field<P>& field, const P& values) {
    const auto* member = std::get_if<double P::*>(&field.member);
    if (!member || is_computable(values.**member)) return;
    add(problems, c, fmt::format("{} = {:.6g} cannot be computed with", key, values.**member),
        fmt::format("numbers are from {:g} to {:g} here", least_number, most_number),
        "look for a wrong unit or number");
  });
}

/// Experiments on discs alone have no deformable particles.
void check_matter(const Case& c, Problems& problems) {
  const Experiment& e = experiment_of(c);
  if (!is_deformable(c) || !e.bodies.empty()) return;
  std::vector<std::string> others;
  for (const Experiment& other : experiments())
    if (!other.bodies.empty()) others.push_back(other.name);
  add(problems, c,
      fmt::format("{} with experiment = \"{}\"",
                  c.initial.packing.empty() ? "physics = \"deformable\"" : "initial.packing", e.name),
      "it is about discs of microgels",
      fmt::format("leave it away, or choose another experiment: {}", fmt::join(others, ", ")));
}

/// A disc must not meet itself, nor a neighbour on two sides, across the periodic boundary.
void check_packing(const Case& c, Problems& problems) {
  const Particles& p = c.particles;
  const DiscSpec spec{p.discs, p.packing_fraction, p.bimodal_factor, c.material.density};
  const std::vector<double> radii =
      bimodal_radii(spec, c.box.width * c.box.height, static_cast<std::uint64_t>(c.general.seed));
  const double diameter = 2 * *std::max_element(radii.begin(), radii.end());
  const double shortest = std::min(c.box.width, c.box.height);
  if (diameter <= 0.5 * shortest) return;
  add(problems, c,
      fmt::format("particles.packing_fraction = {} cannot be reached with N = {}", p.packing_fraction,
                  p.discs),
      fmt::format("the largest disc would be {:.3g} m across, more than half of the cell's {:.3g} m, and "
                  "meet itself or "
                  "a neighbour twice across the boundary",
                  diameter, shortest),
      "raise particles.N or lower particles.packing_fraction");
}

void check_material(const Case& c, Problems& problems) {
  const Material& m = c.material;
  if (m.elastic_law == "expression" && m.elastic_expression.empty())
    add(problems, c, "material.elastic_law = \"expression\" without material.elastic_expression",
        "there is no law to use", "give one, for example elastic_expression = \"k*(d0-d)\"");
  if (m.elastic_law == "plateau" && m.plateau_begin >= m.plateau_end)
    add(problems, c,
        fmt::format("material.plateau_begin = {} is not below plateau_end = {}", m.plateau_begin,
                    m.plateau_end),
        "compression runs from plateau_end down to plateau_begin", "exchange them or move them apart");
}

void check_shear(const Case& c, Problems& problems) {
  if (c.general.experiment == "oscillatory_shear" && c.box.boundary != "lees_edwards")
    add(problems, c, fmt::format("box.boundary = \"{}\" cannot be sheared", c.box.boundary),
        "oscillatory_shear strains the cell",
        "set boundary = \"lees_edwards\", or experiment = \"dynamics\"");
  if (c.general.experiment == "dynamics" && c.box.boundary != "lees_edwards" && c.shear.rate != "0")
    add(problems, c,
        fmt::format("shear.rate = \"{}\" in a cell with boundary = \"{}\"", c.shear.rate, c.box.boundary),
        "only Lees-Edwards boundaries can be sheared", "set boundary = \"lees_edwards\" or rate = \"0\"");
  if (c.general.experiment == "dynamics" && !c.is_given("time.steps") && c.time.steps == 0 &&
      c.initial.state.empty())
    add(problems, c, "time.steps is missing", "dynamics records that many steps", "set steps in [time]");
}

/// What would be known only after hours, or when memory is used up.
void check_cost(const Case& c, Problems& problems) {
  const BodySizes sizes(c.bodies);
  if (sizes.sites() <= most_sites) return;
  const double sites = static_cast<double>(sizes.sites());
  add(problems, c,
      fmt::format("{} particles of {} vertices are {:.3g} vertices", sizes.bodies(), c.bodies.vertices,
                  sites),
      fmt::format("a run can have {:g}; these would need about {:.3g} GB of memory, and to jam them {}",
                  1.0 * most_sites, sites * bytes_per_site * 1e-9, describe_seconds(seconds_to_jam(sites))),
      "lower bodies.N or bodies.vertices");
}

/// Deformable particles: what one key cannot know of another.
void check_bodies(const Case& c, Problems& problems) {
  if (c.initial.state.empty() && c.initial.packing.empty()) check_cost(c, problems);
  const Bodies& b = c.bodies;
  const bool polygons = b.family != "disc";
  const double least = least_shape_parameter(b.vertices);
  if (polygons && b.shape_parameter > 0 && b.shape_parameter < least * (1 - 1e-12))
    add(problems, c, fmt::format("bodies.A0 = {} with bodies.vertices = {}", b.shape_parameter, b.vertices),
        fmt::format("p^2/(4 pi a) of a polygon is at least N tan(pi/N)/pi = {:.6f}", least),
        "raise A0, or 0 for the regular polygon");
  if (c.is_given("bodies.A0") && b.shape_ratio > 0)
    add(problems, c, "bodies.A0 and bodies.A0_ratio",
        "the second is the first over that of the regular polygon", "leave one away");
  for (const auto& [key, ratio] :
       {std::pair{"A0_ratio", b.shape_ratio}, {"A0_ratio_large", b.shape_ratio_large}})
    if (polygons && ratio > 0 && ratio < 1)
      add(problems, c, fmt::format("bodies.{} = {}", key, ratio),
          "no polygon is rounder than the regular one", "give 1 or more, or 0 for the default");
  if (!c.initial.state.empty() && !c.initial.packing.empty())
    add(problems, c, "initial.state and initial.packing", "a run starts from one of them", "leave one away");
  if (c.is_given("physics") && c.general.physics != "deformable")
    add(problems, c,
        fmt::format("physics = \"{}\" with experiment = \"{}\"", c.general.physics, c.general.experiment),
        "it is about deformable particles", "leave physics away");
  if (b.family == "rough_disc" && c.contact.kind == "smooth")
    add(problems, c, "bodies.family = \"rough_disc\" with contact.kind = \"smooth\"",
        "a rough disc is a ring of vertices",
        "set contact.kind = \"rough\", or family = \"disc\" for smooth discs");
  if (c.general.experiment == "compression" && c.compression.highest_pressure <= c.jamming.pressure)
    add(problems, c,
        fmt::format("compression.highest_pressure = {} is not above jamming.pressure = {}",
                    c.compression.highest_pressure, c.jamming.pressure),
        "compression goes from the one to the other", "raise the first or lower the second");
}

std::vector<std::string> find_body_doubts(const Case& c) {
  std::vector<std::string> doubts = find_idle_keys(c);
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
  if (c.general.experiment == "slump" && c.motion.damping == 0)
    doubts.push_back("motion.damping = 0: nothing ever settles");
  return doubts;
}

}  // namespace

void check(const Case& c) { check(c, nullptr); }

void check(const Case& c, const InitialState* initial) {
  Problems problems;
  check_numbers(c, problems);
  check_matter(c, problems);
  if (!problems.empty()) throw input_error(fmt::format("{}", fmt::join(problems, "\n")));
  const bool from_file = initial || !c.initial.state.empty() || !c.initial.packing.empty();
  problems = find_useless_keys(c, from_file ? Start::state : Start::nothing);
  if (is_deformable(c)) {
    check_bodies(c, problems);
  } else {
    check_material(c, problems);
    check_shear(c, problems);
    if (!from_file) check_packing(c, problems);
  }
  if (!problems.empty()) throw input_error(fmt::format("{}", fmt::join(problems, "\n")));
}

std::vector<std::string> find_doubts(const Case& c) {
  if (is_deformable(c)) return find_body_doubts(c);
  std::vector<std::string> doubts = find_idle_keys(c);
  const bool shear = c.general.experiment == "oscillatory_shear";
  if (c.initial.state.empty() && c.particles.packing_fraction < 0.84)
    doubts.push_back(fmt::format(
        "particles.packing_fraction = {} is below jamming (about 0.84): expect no modulus at rest",
        c.particles.packing_fraction));
  const bool published = c.general.physics == "particleshear-1.0.2";
  if (shear && published && c.shear.pre_periods == 0)
    doubts.push_back("shear.pre_periods = 0: drift and offset cannot be removed");
  if (shear && c.shear.periods < 2)
    doubts.push_back(
        fmt::format("shear.periods = {}: the first period is transient and there is no second to demodulate",
                    c.shear.periods));
  else if (shear && !published && c.shear.periods < 4)
    doubts.push_back(
        fmt::format("shear.periods = {}: no error of G' and G'', as the cycles after the first are fewer "
                    "than three",
                    c.shear.periods));
  return doubts;
}

}  // namespace supple
