/// What fills elastic solids: bonds, which are springs between two sites, and elements, triangles in 2D and
/// tetrahedra in 3D.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "supple/core/vec.hpp"

namespace supple {

/// Stiffnesses of the inside of one body: U = sum (bond/2)(r - r0)^2 over its bonds, and the strain energy
/// with Lame's constants lambda and mu over its elements (energy/bond_stretch, energy/element_strain).
struct SolidStiffness {
  double bond = 0;            ///< [energy/length^2]
  double lambda = 0, mu = 0;  ///< [energy/length^Dim]
};

/// The inside of all bodies. Bonds of body b: [bond_begin[b], bond_begin[b + 1]); elements likewise. Bodies
/// beyond the end of these have none. The sites of a solid's boundary come first in its body, then those
/// inside, which belong to no facet and touch no other body: its boundary is in between. Elements without
/// stiffness only show where a network of springs has turned inside out.
template <int Dim>
struct Solid {
  std::vector<std::int32_t> bond_begin, element_begin;
  std::vector<std::array<std::int32_t, 2>> bond;
  /// Sites of each element, ordered so that det(x_0 - x_Dim, ..., x_(Dim-1) - x_Dim) > 0 at rest.
  std::vector<std::array<std::int32_t, Dim + 1>> element;
  std::vector<SolidStiffness> stiffness;  ///< of each body
  std::vector<double> rest_bond;          ///< [length]
  /// X^-1 of each element, X the matrix with these columns at rest [1/length].
  std::vector<Mat<Dim>> rest_element;

  bool empty() const { return stiffness.empty(); }
  int bodies() const { return static_cast<int>(stiffness.size()); }
  /// Whether body b has an inside.
  bool fills(int b) const {
    return b < bodies() && (bond_begin[b] < bond_begin[b + 1] || element_begin[b] < element_begin[b + 1]);
  }
};

}  // namespace supple
