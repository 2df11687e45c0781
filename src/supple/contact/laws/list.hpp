/// All elastic laws of contacts, by the names by which cases choose them.
#pragma once
#include <string_view>
#include <variant>
#include <vector>

#include "supple/contact/laws/adhesive.hpp"
#include "supple/contact/laws/disc.hpp"
#include "supple/contact/laws/elastic.hpp"
#include "supple/contact/laws/tabulated.hpp"

namespace supple {

using Repulsion = std::variant<Linear, Divergent, Hertz, Plateau, Tabulated, Adhesive>;

/// range_of() for the law that is held.
inline double range_of(const Repulsion& law) {
  return std::visit([](const auto& l) { return range_of(l); }, law);
}

/// The parameters of laws, beside k; each law takes those that it has.
struct ElasticParameters {
  double central_share = 1;  ///< c of Divergent, Plateau and formulas
  double plateau_begin = 0.3, plateau_end = 0.8, plateau_slope = 0.1;  ///< Plateau
  double attraction_range = 0.1;                                       ///< Adhesive
  RepulsionFunction formula = {};
  std::string formula_is = {};  ///< what the formula is and where it was given, for errors
};

/// A law, and the name by which cases choose it.
struct NamedLaw {
  std::string_view name;
  Repulsion (*make)(const ElasticParameters&);
  bool for_bodies;  ///< whether contacts of bodies of many sites take it
};
const std::vector<NamedLaw>& elastic_laws();

/// The law of this name. Throws an input error where there is none.
Repulsion make_elastic(std::string_view name, const ElasticParameters& parameters = {});
/// Names of the laws that discs may have, and of those that bodies of many sites may have.
std::vector<std::string_view> laws_of_discs();
std::vector<std::string_view> laws_of_bodies();

}  // namespace supple
