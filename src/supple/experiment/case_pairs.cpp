/// Names of species and of the sections of their contacts.
#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "supple/experiment/case.hpp"

namespace supple {

std::string species_section(std::size_t index) { return fmt::format("species.{}", index + 1); }

std::string name_of_species(const Case& c, std::size_t index) {
  const std::string& name = c.species[index].name;
  return name.empty() ? fmt::format("{}", index + 1) : name;
}

std::string pair_section(const ContactOfSpecies& pair) {
  return fmt::format("contact.{}.{}", pair.first, pair.second);
}

ContactOfSpecies& contact_between(Case& c, std::string first, std::string second) {
  if (second < first) std::swap(first, second);
  const auto names = [](const ContactOfSpecies& p) { return std::tie(p.first, p.second); };
  auto at = std::find_if(c.pairs.begin(), c.pairs.end(),
                         [&](const ContactOfSpecies& p) { return names(p) >= std::tie(first, second); });
  if (at == c.pairs.end() || names(*at) != std::tie(first, second)) {
    at = c.pairs.emplace(at);
    at->first = first;
    at->second = second;
  }
  return *at;
}

std::string kind_of_section(std::string_view section) {
  if (section.starts_with("species.")) return "species";
  return section.starts_with("contact.") ? "contact.A.B" : std::string(section);
}

Case every_section() {
  Case c;
  c.species.resize(1);
  contact_between(c, "A", "B");
  return c;
}

}  // namespace supple
