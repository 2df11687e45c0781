/// All conservative terms of bodies.
#pragma once
#include <tuple>

#include "supple/energy/bond_stretch.hpp"
#include "supple/energy/element_strain.hpp"
#include "supple/energy/enclosed_volume.hpp"
#include "supple/energy/facet_stretch.hpp"
#include "supple/energy/facet_tension.hpp"
#include "supple/energy/hinge_bend.hpp"
#include "supple/energy/perimeter.hpp"

namespace supple {

/// Terms of a few sites (a stencil) each.
template <int Dim>
using Terms =
    std::tuple<FacetStretch<Dim>, FacetTension<Dim>, HingeBend<Dim>, BondStretch<Dim>, ElementStrain<Dim>>;
/// Terms of a whole body.
using BodyTerms = std::tuple<EnclosedVolume, Perimeter>;

}  // namespace supple
