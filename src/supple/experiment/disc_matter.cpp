#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "supple/experiment/matter.hpp"
#include "supple/experiment/suspension.hpp"
#include "supple/model/discs.hpp"

namespace supple {

namespace {

/// A disc must not meet itself, nor a neighbour on two sides, across the periodic boundary.
void check_packing(const Case& c, Problems& problems) {
  const Particles& p = c.particles;
  const DiscSpec spec{p.discs, p.packing_fraction, p.bimodal_factor, c.material.density};
  const std::vector<double> radii =
      bimodal_radii(spec, c.box.width * c.box.height, static_cast<std::uint64_t>(c.general.seed));
  const double diameter = 2 * *std::max_element(radii.begin(), radii.end());
  const double shortest = std::min(c.box.width, c.box.height);
  if (diameter <= 0.5 * shortest) return;
  add_problem(problems, c,
              fmt::format("particles.packing_fraction = {} cannot be reached with N = {}", p.packing_fraction,
                          p.discs),
              fmt::format("the largest disc would be {:.3g} m across, more than half of the cell's {:.3g} m, "
                          "and meet itself or a neighbour twice across the boundary",
                          diameter, shortest),
              "raise particles.N or lower particles.packing_fraction");
}

void check_material(const Case& c, Problems& problems) {
  const Material& m = c.material;
  if (m.elastic_law == "expression" && m.elastic_expression.empty())
    add_problem(problems, c, "material.elastic_law = \"expression\" without material.elastic_expression",
                "there is no law to use", "give one, for example elastic_expression = \"k*(d0-d)\"");
  if (m.elastic_law == "plateau" && m.plateau_begin >= m.plateau_end)
    add_problem(problems, c,
                fmt::format("material.plateau_begin = {} is not below plateau_end = {}", m.plateau_begin,
                            m.plateau_end),
                "compression runs from plateau_end down to plateau_begin",
                "exchange them or move them apart");
}

void check_discs(const Case& c, Start start, Problems& problems) {
  check_material(c, problems);
  if (start == Start::nothing) check_packing(c, problems);
}

void doubt_discs(const Case& c, Doubts& doubts) {
  if (c.initial.state.empty() && c.particles.packing_fraction < 0.84)
    doubts.push_back(fmt::format(
        "particles.packing_fraction = {} is below jamming (about 0.84): expect no modulus at rest",
        c.particles.packing_fraction));
}

/// What the discs themselves say of how they were made, and of what.
HeldKeys keys_of_discs(const InitialState& initial) {
  const System<2>& s = system_of<2>(initial);
  const Units& u = initial.units;
  double area = 0, mass = 0;  // of a unit of depth
  for (const double r : s.state.radius) area += std::numbers::pi * r * r;
  for (const double m : s.state.mass) mass += m;
  HeldKeys keys{{"particles.N", static_cast<std::int64_t>(s.state.size())},
                {"particles.packing_fraction", area / s.box.volume()},
                {"box.width", s.box.length[flow] * u.length},
                {"box.height", s.box.length[gradient] * u.length},
                {"material.density", mass / area * u.density()}};
  const MaterialConstants& m = initial.material;
  if (m.k)  // of links, (pi/8) E (S1-8)
    keys["material.young_modulus"] =
        *m.k * m.permanent_ratio_central.value_or(1) * u.stiffness() * 8 / std::numbers::pi;
  return keys;
}

std::string describe_discs(const Case& c, const InitialState* initial) {
  const int discs = initial ? site_count(initial->system) : c.particles.discs;
  return fmt::format("{} discs, {} model", discs, c.general.physics);
}

}  // namespace

const Matter& disc_matter() {
  static const Matter discs{.name = "discs of microgels",
                            .physics = "documented",
                            .suspension = &documented_model(),
                            .is_held = [](const AnySystem& s) { return !has_bodies(s); },
                            .check = check_discs,
                            .doubt = doubt_discs,
                            .known = keys_of_discs,
                            .adopt = [](Case&, const InitialState&) {},
                            .curves = {{"plates", "plates"}, {"total", "total"}, {"virial", "virial"}},
                            .sites = [](const Case& c) { return std::int64_t{c.particles.discs}; },
                            .describe = describe_discs};
  return discs;
}

}  // namespace supple
