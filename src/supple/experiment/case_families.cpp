/// What keys of deformable particles follow from their family.
#include <fmt/format.h>

#include <algorithm>

#include "supple/experiment/case.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/experiment/used_keys.hpp"
#include "supple/model/polygons.hpp"

namespace supple {

namespace {

/// A0 = 1.04, or 1 % above the least where few vertices cannot have that: at the least itself a floppy
/// particle has one zero mode more [MacKeith 2025, section 9.2], and no minimisation ends soon.
double floppy_shape_parameter(int vertices) { return std::max(1.04, 1.01 * least_shape_parameter(vertices)); }

void complete_family(const Case& c, const std::string& section, ParticleKind& p) {
  const auto unless_given = [&](const char* key, double& value, double of_family) {
    if (!c.is_given(fmt::format("{}.{}", section, key))) value = of_family;
  };
  if (p.family == "floppy") {
    unless_given("k_b", p.k_b, 0);
    if (p.shape_parameter == 0 && p.shape_ratio == 0)
      unless_given("A0", p.shape_parameter, floppy_shape_parameter(p.vertices));
  }
  if (p.family == "droplet") {
    unless_given("k_b", p.k_b, 0);
    unless_given("k_l", p.k_l, 0.1);
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
