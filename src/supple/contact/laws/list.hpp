/// All repulsion laws of discs.
#pragma once
#include <variant>

#include "supple/contact/laws/disc.hpp"
#include "supple/contact/laws/elastic.hpp"

namespace supple {

using Repulsion = std::variant<Divergent, Hertz, Plateau>;

}  // namespace supple
