/// init, check, list.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>
#include <optional>

#include "beside.hpp"
#include "commands.hpp"
#include "supple/core/duration.hpp"
#include "supple/core/error.hpp"
#include "supple/core/nearest_name.hpp"
#include "supple/core/text_columns.hpp"
#include "supple/experiment/adopt_state.hpp"
#include "supple/experiment/cost.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/experiment/used_keys.hpp"
#include "supple/io/state/packing_file.hpp"
#include "supple/io/state/state_file.hpp"
#include "supple/io/text/case_file.hpp"
#include "supple/io/text/progress.hpp"

namespace supple::command {

namespace {

using Json = nlohmann::ordered_json;

/// The text, quoted so that a shell takes it as one word.
std::string as_word(const std::string& name) {
  const auto plain = [](unsigned char c) {
    return std::isalnum(c) || std::string_view("_./-+=,:@%").find(c) != std::string_view::npos;
  };
  if (std::all_of(name.begin(), name.end(), plain)) return name;
  std::string word = "'";
  for (const char c : name) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

std::optional<double> find(const std::vector<Derived>& derived, const std::string& name) {
  for (const Derived& d : derived)
    if (d.name.name == name) return d.value;
  return std::nullopt;
}

double site_count(const Case& c, const std::optional<InitialState>& initial) {
  return static_cast<double>(initial ? supple::site_count(initial->system)
                                     : experiment_of(c).matter->sites(c));
}

template <class P>
Json parameter_json(const std::string& key, const Field<P>& field, const P& defaults) {
  Json j{{"name", field.name},
         {"unit", field.unit},
         {"meaning", field.meaning},
         {"range", describe(field.range)},
         {"experiments", users_of(key)}};
  std::visit([&](auto member) { j["default"] = defaults.*member; }, field.member);
  if (!field.choices.empty()) j["choices"] = field.choices;
  return j;
}

Json parameters_json(const std::string& only) {
  Json sections = Json::object();
  const Case defaults = every_section();
  for_each_section(defaults, [&](std::string_view section, const auto& parameters) {
    const std::string name = section.empty() ? "general" : kind_of_section(section);
    if (!only.empty() && only != name) return;
    for (const auto& field : fields<std::decay_t<decltype(parameters)>>())
      sections[name].push_back(parameter_json(
          (section.empty() ? "" : fmt::format("{}.", section)) + std::string(field.name), field, parameters));
  });
  return sections;
}

/// The commented case, or its part from the line [section] to the next one; "general": what stands above any
/// section.
std::string section_text(const std::string& section) {
  const std::string text = write_case(every_section(), CaseStyle::all);
  if (section.empty()) return text;
  const std::string title = section == "species" ? "[[species]]" : "[" + section + "]";
  const auto begin = section == "general" ? 0 : text.find("\n" + title) + 1;
  const auto end = text.find("\n[", begin);
  return text.substr(begin, end == text.npos ? end : end - begin);
}

/// The experiments of this name, one for each kind of particles.
std::vector<Experiment> experiments_of(const std::string& name) {
  std::vector<Experiment> rows;
  for (const Experiment& e : experiments())
    if (e.name == name) rows.push_back(e);
  return rows;
}

std::string meaning_of(const std::string& name) {
  std::vector<std::string> meanings;
  for (const Experiment& e : experiments_of(name)) meanings.push_back(e.meaning);
  return fmt::format("{}", fmt::join(meanings, "; "));
}

/// A case of the experiment in which everything else has its default.
Case case_of(const Experiment& e) {
  Case c;
  c.general.experiment = e.name;
  c.general.physics = e.matter->physics;
  resolve_family(c);
  e.complete(c);
  return c;
}

/// The keys that an experiment uses, on each kind of particles.
void list_used(const std::string& name, Format format) {
  const std::vector<Experiment> rows = experiments_of(name);
  Json j{{"experiment", name}, {"meaning", meaning_of(name)}, {"keys", Json::array()}};
  const Case defaults;
  for_each_key(defaults, [&](const std::string& key, const auto&, const auto&) {
    if (std::any_of(rows.begin(), rows.end(), [&](const Experiment& e) { return uses(case_of(e), key); }))
      j["keys"].push_back(key);
  });
  if (format == Format::json) return fmt::print("{}\n", j.dump(2));
  for (const Experiment& e : rows) {
    const std::string of = rows.size() > 1 ? fmt::format(" of {}", e.matter->name) : "";
    fmt::print("{}{}: {}\n\n", name, of, e.meaning);
    fmt::print("{}{}", write_case(case_of(e), CaseStyle::commented), &e == &rows.back() ? "" : "\n");
  }
}

}  // namespace

std::optional<InitialState> load_initial(const Case& c) {
  return load_initial(c, c.initial.packing.empty() ? c.initial.state : c.initial.packing);
}

std::optional<InitialState> load_initial(const Case& c, const std::string& copy) {
  if (copy.empty()) return std::nullopt;
  if (!c.initial.packing.empty()) return as_initial(read_any_packing_json(copy));
  return read_state(copy);
}

std::vector<Derived> derive_case(const Case& c, const std::optional<InitialState>& initial) {
  try {
    return derive(c, initial ? &*initial : nullptr);
  } catch (const Error& e) {
    throw Error(e.kind(), fmt::format("{}: {}", c.origin, e.what()));
  }
}

LoadedCase load_case(const CaseChoice& choice) {
  Case c = read_case(choice.path, choice.set);
  if (choice.threads > 0) c.general.threads = choice.threads;
  resolve_family(c);
  std::optional<InitialState> initial = load_initial(c);
  const std::string origin = c.origin;
  try {
    c = adopt_state(std::move(c), initial ? &*initial : nullptr);
  } catch (const Error& e) {
    throw Error(e.kind(), fmt::format("{}: {}", origin, e.what()));
  }
  supple::check(c);
  return {std::move(c), std::move(initial)};
}

void init(const std::string& experiment, const std::string& physics, const std::string& path,
          Existing existing) {
  const std::vector<std::string> names = experiment_names();
  if (std::find(names.begin(), names.end(), experiment) == names.end()) {
    const auto near = nearest_name(experiment, names);
    throw input_error(fmt::format("there is no experiment '{}'", experiment), "",
                      near ? fmt::format("did you mean '{}'?", *near) : "choose from " + join_names(names));
  }
  Case c;
  c.general.experiment = experiment;
  if (!physics.empty()) {
    c.general.physics = physics;
    c.given.insert("physics");
  }
  const Experiment& e = experiment_of(c);
  if (const Matter* asked = asked_matter(c); asked && asked != e.matter)
    throw input_error(fmt::format("experiment '{}' with physics '{}'", experiment, physics),
                      fmt::format("it is about {}", e.matter->name), "leave --physics away");
  resolve_family(c);
  e.complete(c);
  e.set_first(c);
  c.given = e.first_keys;
  const std::string text = write_case(c, CaseStyle::commented);
  if (path == "-") {
    fmt::print("{}", text);
    return;
  }
  const std::string name = path.empty() ? experiment + ".toml" : path;
  NewFile file(name, existing);
  file.write(text);
  file.commit();
  fmt::print("wrote {0}\nnext: supple check {1} && supple run {1}\n", name, as_word(name));
}

void check(const CaseChoice& choice, Format format) {
  const auto [c, initial] = load_case(choice);
  std::vector<std::string> doubts = find_doubts(c);
  const std::vector<Derived> derived = derive_case(c, initial);
  const auto steps = find(derived, "steps");
  const auto evaluations = find(derived, "evaluations");
  const double estimate =
      (steps.value_or(0) * seconds_per_disc_step + evaluations.value_or(0) * seconds_per_site_evaluation) *
      site_count(c, initial) / c.general.threads;
  if (estimate > 30 * 86400.0)
    doubts.push_back(fmt::format("the run would take about {}: lower the number of particles or steps",
                                 describe_seconds(estimate)));

  if (format == Format::json) {
    Json j{{"case", choice.path}, {"experiment", c.general.experiment}, {"physics", c.general.physics}};
    for (const Derived& d : derived)
      j["derived"][d.name.name] = {{"value", d.value}, {"unit", d.name.unit}, {"meaning", d.name.meaning}};
    if (steps || evaluations) j["estimated_seconds"] = estimate;
    j["warnings"] = doubts;
    fmt::print("{}\n", j.dump(2));
    return;
  }
  fmt::print("{}: sound\n{} of {}, seed {}\n\n", choice.path, c.general.experiment,
             experiment_of(c).matter->describe(c, initial ? &*initial : nullptr), c.general.seed);
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> meanings;
  const auto add = [&](const std::string& name, const std::string& value, const std::string& unit,
                       const std::string& meaning) {
    rows.push_back({name, fmt::format("{:>12} {}", value, unit)});
    meanings.push_back(meaning);
  };
  for (const Derived& d : derived)
    add(d.name.name, fmt::format("{:.6g}", d.value), d.name.unit, d.name.meaning);
  if (steps || evaluations)
    add("time to run", describe_seconds(estimate), "",
        steps ? "without preparation, roughly" : "within a factor of about two");
  for (std::size_t i = 0; i < rows.size(); ++i)
    fmt::print("{}", table_row(rows[i], widths_of(rows), meanings[i]));
  for (const std::string& doubt : doubts) fmt::print("\n{}", hang_words("", "warning: " + doubt, 0));
}

void list(const std::string& what, Format format) {
  const std::vector<std::string> names = experiment_names();
  if (std::find(names.begin(), names.end(), what) != names.end()) return list_used(what, format);
  const Json sections = parameters_json(what);
  if (sections.empty()) {
    std::vector<std::string> choices;
    const Json every = parameters_json("");
    for (const auto& [name, parameters] : every.items()) choices.push_back(name);
    choices.insert(choices.end(), names.begin(), names.end());
    const auto near = nearest_name(what, choices);
    throw input_error(fmt::format("there is no section or experiment '{}'", what), "",
                      near ? fmt::format("did you mean '{}'?", *near) : "choose from " + join_names(choices));
  }
  Json all{{"parameters", sections}};
  if (what.empty())
    for (const std::string& name : names) all["experiments"][name] = meaning_of(name);
  if (format == Format::json) {
    fmt::print("{}\n", all.dump(2));
    return;
  }
  if (what.empty()) {
    fmt::print("Experiments\n");
    for (const std::string& name : names) fmt::print("{}", table_row({name}, {20}, meaning_of(name)));
    fmt::print("\nParameters, as in a case\n\n");
  }
  fmt::print("{}", section_text(what));
}

}  // namespace supple::command
