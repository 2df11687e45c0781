#include "supple/contact/laws/list.hpp"

#include <string>

#include "supple/core/error.hpp"

namespace supple {

const std::vector<NamedLaw>& elastic_laws() {
  using P = ElasticParameters;
  static const std::vector<NamedLaw> all{
      {"divergent", [](const P& p) -> Repulsion { return Divergent(p.central_share); }, false},
      {"linear", [](const P&) -> Repulsion { return Linear(); }, true},
      {"hertz", [](const P&) -> Repulsion { return Hertz(); }, true},
      {"plateau",
       [](const P& p) -> Repulsion {
         return Plateau(p.central_share, p.plateau_begin, p.plateau_end, p.plateau_slope);
       },
       false},
      {"expression",
       [](const P& p) -> Repulsion { return Tabulated(p.formula, p.central_share, p.formula_is); }, false},
      {"adhesive", [](const P& p) -> Repulsion { return Adhesive(p.attraction_range); }, true},
  };
  return all;
}

Repulsion make_elastic(std::string_view name, const ElasticParameters& parameters) {
  for (const NamedLaw& law : elastic_laws())
    if (law.name == name) return law.make(parameters);
  throw input_error("no elastic law '" + std::string(name) + "'");
}

std::vector<std::string_view> laws_of_discs() {
  std::vector<std::string_view> names;
  for (const NamedLaw& law : elastic_laws()) names.push_back(law.name);
  return names;
}

std::vector<std::string_view> laws_of_bodies() {
  std::vector<std::string_view> names;
  for (const NamedLaw& law : elastic_laws())
    if (law.for_bodies) names.push_back(law.name);
  return names;
}

}  // namespace supple
