#include "supple/experiment/pairs_of_case.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <optional>

#include "supple/core/error.hpp"
#include "supple/core/nearest_name.hpp"

namespace supple {

namespace {

std::vector<std::string> names_of_species(const Case& c) {
  std::vector<std::string> names;
  for (std::size_t k = 0; k < c.species.size(); ++k) names.push_back(name_of_species(c, k));
  return names;
}

std::optional<std::int32_t> place_of(const Case& c, const std::string& name) {
  const std::vector<std::string> names = names_of_species(c);
  const auto at = std::find(names.begin(), names.end(), name);
  if (at == names.end()) return std::nullopt;
  return static_cast<std::int32_t>(at - names.begin());
}

/// Whether it is a number.
bool is_place(const std::string& name) {
  return std::all_of(name.begin(), name.end(), [](unsigned char x) { return std::isdigit(x) != 0; });
}

/// What is wrong with the pair; empty: nothing.
std::string mistake_in(const Case& c, const ContactOfSpecies& pair, std::string& to_do) {
  const std::vector<std::string> names = names_of_species(c);
  if (names.empty()) {
    to_do = "describe the particles by [[species]], or leave the section away";
    return "there are no [[species]]";
  }
  for (const std::string& name : {pair.first, pair.second}) {
    if (place_of(c, name)) continue;
    const auto near = is_place(name) ? std::nullopt : nearest_name(name, names);
    to_do = near ? fmt::format("did you mean \"{}\"?", *near)
                 : fmt::format("the species are {}", fmt::join(names, ", "));
    return fmt::format("there is no species \"{}\"", name);
  }
  return "";
}

/// The pair with the keys of [contact] and [material] in the places of those that are not given.
ContactOfSpecies completed(const Case& c, const ContactOfSpecies& pair) {
  ContactOfSpecies all = pair;
  const std::string section = pair_section(pair);
  const auto unless_given = [&](const char* key, auto& value, const auto& common) {
    if (!c.is_given(fmt::format("{}.{}", section, key))) value = common;
  };
  unless_given("law", all.law, c.contact.law);
  unless_given("attraction_range", all.attraction_range, c.contact.attraction_range);
  unless_given("k_c", all.k_c, c.contact.k_c);
  unless_given("friction", all.friction, c.material.friction);
  unless_given("relative_viscosity", all.relative_viscosity, c.material.relative_viscosity);
  return all;
}

BodyLaw elastic_law(const Case& c, double k_c, const std::string& law, double attraction_range) {
  return {Harmonic{k_c, c.bodies.stiffness == "relative"},
          make_elastic(law, {.attraction_range = attraction_range})};
}

bool is_plain(const std::string& name) {
  return std::all_of(name.begin(), name.end(),
                     [](unsigned char x) { return std::isalnum(x) || x == '_' || x == '-'; });
}

void check_name(const Case& c, std::size_t index, Problems& problems) {
  const std::string& name = c.species[index].name;
  if (name.empty()) return;
  const std::string what = fmt::format("{}.name = \"{}\"", species_section(index), name);
  const Fields<ContactOfBodies>& keys = fields<ContactOfBodies>();
  if (!is_plain(name))
    add_problem(problems, c, what, "it stands in sections [contact.A.B]", "use letters, digits, - and _");
  else if (is_place(name))
    add_problem(problems, c, what, "numbers are the places of species without a name", "use a word");
  else if (std::any_of(keys.begin(), keys.end(), [&](const auto& field) { return field.name == name; }))
    add_problem(problems, c, what, fmt::format("contact.{} is a key", name), "use another word");
  for (std::size_t k = 0; k < index; ++k)
    if (c.species[k].name == name)
      add_problem(problems, c, what, fmt::format("{} has this name, too", species_section(k)),
                  "give each its own name");
}

}  // namespace

std::vector<PairOfSpecies> pairs_of(const Case& c) {
  std::vector<PairOfSpecies> all;
  for (const ContactOfSpecies& pair : c.pairs) {
    std::string to_do;
    if (const std::string mistake = mistake_in(c, pair, to_do); !mistake.empty())
      throw input_error(fmt::format("[{}]", pair_section(pair)), mistake, to_do);
    all.push_back({*place_of(c, pair.first), *place_of(c, pair.second), completed(c, pair)});
  }
  return all;
}

ContactLaws contact_laws(const Case& c) {
  const ContactOfBodies& t = c.contact;
  ContactLaws laws = elastic_law(c, t.k_c, t.law, t.attraction_range);
  for (const PairOfSpecies& pair : pairs_of(c))
    laws.set(pair.first, pair.second,
             elastic_law(c, pair.contact.k_c, pair.contact.law, pair.contact.attraction_range));
  return laws;
}

void check_pairs(const Case& c, Problems& problems) {
  for (std::size_t k = 0; k < c.species.size(); ++k) check_name(c, k, problems);
  for (const ContactOfSpecies& pair : c.pairs) {
    std::string to_do;
    if (const std::string mistake = mistake_in(c, pair, to_do); !mistake.empty())
      add_problem(problems, c, fmt::format("[{}]", pair_section(pair)), mistake, to_do);
  }
}

void doubt_pairs(const Case& c, Doubts& doubts) {
  for (const PairOfSpecies& pair : pairs_of(c)) {
    const std::string section = pair_section(pair.contact);
    if (c.is_given(section + ".attraction_range") && pair.contact.law != "adhesive")
      doubts.push_back(
          fmt::format("{0}.attraction_range has no effect without {0}.law = \"adhesive\"", section));
    bool any = false;
    for (const auto& field : fields<ContactOfSpecies>())
      any = any || c.is_given(fmt::format("{}.{}", section, field.name));
    if (!any) doubts.push_back(fmt::format("[{}] has no keys: these contacts are as all others", section));
  }
}

}  // namespace supple
