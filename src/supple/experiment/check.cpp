#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "supple/core/error.hpp"
#include "supple/experiment/case.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/experiment/used_keys.hpp"
#include "supple/model/sanity.hpp"

namespace supple {

namespace {

/// Refuses numbers that cannot be computed with, because a run would only say that a force is not finite.
void check_numbers(const Case& c, Problems& problems) {
  for_each_key(c, [&]<class P>(const std::string& key, const Field<P>& field, const P& values) {
    const auto* member = std::get_if<double P::*>(&field.member);
    if (!member || is_computable(values.**member)) return;
    add_problem(problems, c, fmt::format("{} = {:.6g} cannot be computed with", key, values.**member),
                fmt::format("numbers are from {:g} to {:g} here", least_number, most_number),
                "look for a wrong unit or number");
  });
}

/// Refuses an experiment that is not about the particles that the case asks for.
void check_matter(const Case& c, Problems& problems) {
  const Experiment& e = experiment_of(c);
  const Matter* asked = asked_matter(c);
  if (!asked || asked == e.matter) return;
  std::vector<std::string> others;
  for (const Experiment& other : experiments())
    if (other.matter == asked) others.push_back(other.name);
  const std::string key = c.initial.packing.empty() ? fmt::format("physics = \"{}\"", c.general.physics)
                                                    : std::string("initial.packing");
  add_problem(problems, c, fmt::format("{} with experiment = \"{}\"", key, e.name),
              fmt::format("it is about {}", e.matter->name),
              fmt::format("leave it away, or choose another experiment: {}", fmt::join(others, ", ")));
}

/// Refuses an experiment in more dimensions than it can be done in.
void check_dimensions(const Case& c, Problems& problems) {
  if (experiment_of(c).run.of(dimensions_of(c))) return;
  std::vector<std::string> others;
  for (const Experiment& other : experiments())
    if (other.run.of(c.bodies.dimensions)) others.push_back(other.name);
  add_problem(
      problems, c,
      fmt::format("bodies.dim = {} with experiment = \"{}\"", c.bodies.dimensions, c.general.experiment),
      "it is done in two dimensions",
      fmt::format("leave it away, or choose another experiment: {}", fmt::join(others, ", ")));
}

}  // namespace

void check(const Case& c) { check(c, nullptr); }

void check(const Case& c, const InitialState* initial) {
  Problems problems;
  check_numbers(c, problems);
  check_matter(c, problems);
  check_dimensions(c, problems);
  if (!problems.empty()) throw input_error(fmt::format("{}", fmt::join(problems, "\n")));
  const bool from_file = initial || !c.initial.state.empty() || !c.initial.packing.empty();
  const Start start = from_file ? Start::state : Start::nothing;
  problems = find_useless_keys(c, start);
  const Experiment& e = experiment_of(c);
  e.matter->check(c, start, problems);
  e.check(c, problems);
  if (!problems.empty()) throw input_error(fmt::format("{}", fmt::join(problems, "\n")));
}

std::vector<std::string> find_doubts(const Case& c) {
  const Experiment& e = experiment_of(c);
  Doubts doubts = find_idle_keys(c);
  e.matter->doubt(c, doubts);
  e.doubt(c, doubts);
  return doubts;
}

}  // namespace supple
