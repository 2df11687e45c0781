#include "supple/experiment/experiments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "supple/core/error.hpp"
#include "supple/core/parallel.hpp"
#include "supple/experiment/adopt_state.hpp"

namespace supple {

std::vector<std::string> experiment_names() {
  std::vector<std::string> names;
  for (const Experiment& e : experiments())
    if (std::find(names.begin(), names.end(), e.name) == names.end()) names.push_back(e.name);
  return names;
}

const Experiment* find_experiment(std::string_view name, const Matter& matter) {
  for (const Experiment& e : experiments())
    if (e.name == name && e.matter == &matter) return &e;
  return nullptr;
}

std::vector<const Matter*> every_matter() {
  std::vector<const Matter*> all;
  for (const Experiment& e : experiments())
    if (std::find(all.begin(), all.end(), e.matter) == all.end()) all.push_back(e.matter);
  return all;
}

std::vector<std::string> physics_names() {
  std::vector<std::string> names;
  for (const Matter* m : every_matter()) names.emplace_back(m->physics);
  return names;
}

const Matter* asked_matter(const Case& c) {
  if (!c.initial.packing.empty()) return &body_matter();
  if (c.is_given("bodies.dim") && c.bodies.dimensions == 3)
    if (find_experiment(c.general.experiment, body_matter())) return &body_matter();
  // The default of the key says nothing.
  if (!c.is_given("physics") && c.general.physics == General{}.physics) return nullptr;
  for (const Matter* m : every_matter())
    if (m->physics == c.general.physics) return m;
  return nullptr;
}

const Experiment& experiment_of(const Case& c) {
  const std::string& name = c.general.experiment;
  if (const Matter* matter = asked_matter(c))
    if (const Experiment* e = find_experiment(name, *matter)) return *e;
  for (const Experiment& e : experiments())
    if (e.name == name) return e;
  throw input_error("no experiment '" + name + "'");
}

int dimensions_of(const Case& c) { return uses(c, "bodies.dim") ? c.bodies.dimensions : 2; }

std::vector<Derived> derive(const Case& c, const InitialState* initial) {
  const Case adopted = adopt_state(c, initial);
  check(adopted, initial);
  const WithThreads threads(adopted.general.threads);
  std::vector<Derived> all = experiment_of(adopted).derive.of(dimensions_of(adopted))(adopted, initial);
  for (const Derived& d : all)
    if (!std::isfinite(d.value))
      throw input_error(fmt::format("{} of this case would be {}", d.name.name, d.value), d.name.meaning,
                        "look for a wrong unit or number");
  return all;
}

void run(const Case& c, const InitialState* initial, Recorder& recorder) {
  const Case adopted = adopt_state(c, initial);
  check(adopted, initial);
  const WithThreads threads(adopted.general.threads);
  experiment_of(adopted).run.of(dimensions_of(adopted))(adopted, initial, recorder);
}

}  // namespace supple
