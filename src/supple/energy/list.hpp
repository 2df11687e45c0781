/// All conservative terms of bodies.
#pragma once
#include <tuple>

#include "supple/energy/facet_stretch.hpp"

namespace supple {

template <int Dim>
using Terms = std::tuple<FacetStretch<Dim>>;

}  // namespace supple
