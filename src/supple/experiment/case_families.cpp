/// What keys of deformable particles follow from their family.
#include <fmt/format.h>

#include <algorithm>

#include "supple/experiment/bodies_of_case.hpp"
#include "supple/experiment/case.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/experiment/used_keys.hpp"

namespace supple {

namespace {

/// A0 = 1.04, or 1 % above the least where few vertices cannot have that: at the least itself a floppy
/// particle has one zero mode more [MacKeith 2025, section 9.2], and no minimisation ends soon.
double floppy_shape_parameter(const Case& c, const ParticleKind& p) {
  return std::max(1.04, 1.01 * least_shape_parameter(c, p));
}

void complete_family(const Case& c, const std::string& section, ParticleKind& p) {
  const auto unless_given = [&](const char* key, auto& value, auto of_family) {
    if (!c.is_given(fmt::format("{}.{}", section, key))) value = of_family;
  };
  const bool flat = c.bodies.dimensions == 2;
  if (!flat) unless_given("vertices", p.vertices, 42);
  if (p.family == "network") {
    unless_given("vertices", p.vertices, flat ? 80 : 400);
    if (!flat) unless_given("diameter_ratio", p.diameter_ratio, 1.2);  // its edges differ in length
    if (c.is_given(section + ".E")) unless_given("k_s", p.k_s, 0.0);
  }
  if (p.family == "floppy") {
    unless_given("k_b", p.k_b, 0.0);
    if (p.shape_parameter == 0 && p.shape_ratio == 0)
      unless_given("A0", p.shape_parameter, floppy_shape_parameter(c, p));
  }
  if (p.family == "droplet") {
    unless_given("k_b", p.k_b, 0.0);
    if (flat) unless_given("k_l", p.k_l, 0.1);
    else unless_given("k_a", p.k_a, 0.1);
    unless_given("gamma", p.gamma, 0.2);
  }
}

}  // namespace

void resolve_family(Case& c) {
  if (const Matter& matter = *experiment_of(c).matter; !c.is_given("physics") && asked_matter(c) != &matter)
    c.general.physics = matter.physics;
  const bool shears_bodies = experiment_of(c).matter == &body_matter() && uses(c, "box.plates");
  if (shears_bodies && !c.is_given("box.plates")) c.box.plates = "none";
  complete_family(c, "bodies", c.bodies);
  for (std::size_t k = 0; k < c.species.size(); ++k) complete_family(c, species_section(k), c.species[k]);
}

}  // namespace supple
