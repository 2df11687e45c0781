#include "supple/experiment/adopt_state.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "supple/core/error.hpp"
#include "supple/core/field.hpp"
#include "supple/experiment/given_packing.hpp"
#include "supple/model/sanity.hpp"

namespace supple {

namespace {

struct NumberOfAState {
  const char* name;
  Range range;
};
constexpr NumberOfAState numbers_of_a_state[] = {
    {"k", positive},
    {"nu", not_negative},
    {"k_t", not_negative},
    {"nu_t", not_negative},
    {"mu", not_negative},
    {"central_repulsion_coefficient", fraction},
    {"permanent_ratio_central", not_negative},
    {"permanent_ratio_tangential", not_negative},
    {contact_stiffness, positive},
    {"dt", positive},
    {"cool_factor", {0, 1, true, false}},
    {"steps", not_negative},
    {"f", not_negative},
    {"amplitude", not_negative},
    {"pre", not_negative},
    {"periods", not_negative},
    {"post", not_negative},
};

/// The numbers beside the system have ranges, as the keys that they stand for.
void require_sane_numbers(const InitialState& initial) {
  const auto look = [](const std::string& name, double x) {
    for (const NumberOfAState& number : numbers_of_a_state) {
      if (number.name != name || (number.range.contains(x) && is_computable(x))) continue;
      throw input_error(
          fmt::format("the state to start from cannot be computed with: its {} is {:.6g}", name, x),
          number.range.contains(x)
              ? fmt::format("numbers are from {:g} to {:g} here", least_number, most_number)
              : "it must be " + describe(number.range),
          "look for a wrong unit or a damaged number");
    }
  };
  for_each_constant(initial.material, [&](const char* name, const auto& constant) {
    if (constant) look(name, *constant);
  });
  if (initial.contact) look(contact_stiffness, initial.contact->stiffness);
  for (const auto& [name, x] : initial.protocol) look(name, x);
}

/// What the discs themselves say of how they were made, and of what.
HeldKeys keys_of_discs(const InitialState& initial) {
  const System<2>& s = initial.system;
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

HeldKeys keys_of_bodies(const System<2>& s) {
  return {{"bodies.N", static_cast<std::int64_t>(s.topology.body_count(s.state.size()))}};
}

void refuse_other_matter(const Case& c, const std::string& file, bool bodies) {
  if (bodies && !is_deformable(c))
    throw input_error(file + " holds deformable particles", "the case is about discs of microgels",
                      "set physics = \"deformable\", or leave physics away");
  if (!bodies && is_deformable(c))
    throw input_error(file + " holds discs of microgels", "the case is about deformable particles",
                      "start from a run of these, or from a packing");
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

}  // namespace

Case adopt_state(Case c, const InitialState* initial) {
  if (!initial) return c;
  require_sane(initial->system, "the state to start from");  // before anything is computed from its numbers
  require_sane_numbers(*initial);
  const bool bodies = !initial->system.topology.begin.empty();
  const std::string& file = c.initial.packing.empty() ? c.initial.state : c.initial.packing;
  HeldKeys held = initial->keys;
  // A heap that falls anew needs a drag, and one that was simulated without has none to hand on.
  if (const auto drag = held.find("motion.damping");
      c.general.experiment == "slump" && drag != held.end() && drag->second == KeyValue(0.0))
    held.erase(drag);
  if (!c.is_given("physics"))
    if (const auto physics = held.find("physics"); physics != held.end())
      c.general.physics = std::get<std::string>(physics->second);
  refuse_other_matter(c, file, bodies);
  adopt_keys(c, held, bodies ? keys_of_bodies(initial->system) : keys_of_discs(*initial), file);
  if (bodies) adopt_bodies(c, *initial);
  if (c.general.experiment == "slump" && !c.is_given("motion.damping") && held.count("motion.damping") == 0)
    c.motion.damping = std::sqrt(c.slump.gravity);
  return c;
}

}  // namespace supple
