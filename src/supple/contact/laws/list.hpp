/// All elastic laws of contacts.
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

/// range_of the law that it is.
inline double range_of(const Repulsion& law) {
  return std::visit([](const auto& l) { return range_of(l); }, law);
}

/// What laws are made from, beside k: each one takes what it knows.
struct ElasticParameters {
  double central_share = 1;  ///< c of Divergent, Plateau and formulas
  double plateau_begin = 0.3, plateau_end = 0.8, plateau_slope = 0.1;  ///< Plateau
  double attraction_range = 0.1;                                       ///< Adhesive
  RepulsionFunction formula = {};
  std::string formula_is = {};  ///< for errors: what the formula is and where it was given
};

/// A law by the name that cases choose it by.
struct NamedLaw {
  std::string_view name;
  Repulsion (*make)(const ElasticParameters&);
  bool for_bodies;  ///< whether contacts of bodies of many sites take it
};
const std::vector<NamedLaw>& elastic_laws();

/// The law of this name. Input error where there is none.
Repulsion make_elastic(std::string_view name, const ElasticParameters& parameters = {});
/// Names of the laws of discs; of the laws of bodies.
std::vector<std::string_view> laws_of_discs();
std::vector<std::string_view> laws_of_bodies();

}  // namespace supple
