#include "supple/experiment/adopt_state.hpp"

#include <fmt/format.h>

#include "supple/core/error.hpp"
#include "supple/core/field.hpp"
#include "supple/experiment/experiments.hpp"
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

void refuse_other_matter(const Case& c, const AnySystem& held, const std::string& file) {
  const Matter& wanted = *experiment_of(c).matter;
  if (wanted.is_held(held)) return;
  const Matter& there = body_matter().is_held(held) ? body_matter() : disc_matter();
  throw input_error(fmt::format("{} holds {}", file, there.name),
                    fmt::format("the case is about {}", wanted.name),
                    find_experiment(c.general.experiment, there)
                        ? fmt::format("set physics = \"{}\", or leave physics away", there.physics)
                        : fmt::format("start from a run of {}", wanted.name));
}

}  // namespace

Case adopt_state(Case c, const InitialState* initial) {
  if (initial) {
    std::visit([](const auto& system) { require_sane(system, "the state to start from"); },
               initial->system);  // before anything is computed from its numbers
    require_sane_numbers(*initial);
    if (!c.is_given("physics"))
      if (const auto physics = initial->keys.find("physics"); physics != initial->keys.end())
        c.general.physics = std::get<std::string>(physics->second);
    resolve_family(c);
    const std::string& file = c.initial.packing.empty() ? c.initial.state : c.initial.packing;
    refuse_other_matter(c, initial->system, file);
    const Matter& matter = *experiment_of(c).matter;
    adopt_keys(c, initial->keys, matter.known(*initial), file);
    matter.adopt(c, *initial);
  }
  experiment_of(c).complete(c);
  return c;
}

}  // namespace supple
