/// All repulsion laws of discs.
#pragma once
#include <variant>

#include "supple/contact/laws/disc.hpp"
#include "supple/contact/laws/elastic.hpp"
#include "supple/contact/laws/tabulated.hpp"

namespace supple {

using Repulsion = std::variant<Divergent, Hertz, Plateau, Tabulated>;

}  // namespace supple
