/// Measures of a simplex, a triangle in 2D or a tetrahedron in 3D, with its last corner as the origin.
#pragma once
#include "supple/geometry/facet.hpp"

namespace supple {

/// Corners of a simplex but the last, as seen from the last: y_k = x_k - x_Dim [length].
template <class S, int Dim>
struct SimplexEdges {
  VecOf<S, Dim> y[Dim];
};

/// The edges from the last corner to the others [length].
template <class S, int Dim, std::size_t N>
SimplexEdges<S, Dim> simplex_edges(const VecOf<S, Dim> (&x)[N]) {
  static_assert(N == Dim + 1, "a simplex has one corner more than there are dimensions");
  SimplexEdges<S, Dim> edges;
  for (int k = 0; k < Dim; ++k) edges.y[k] = x[k] - x[Dim];
  return edges;
}

/// Signed area of a triangle [length^2], positive where its corners are counter-clockwise; signed volume of a
/// tetrahedron [length^3], positive where the last corner lies on the inner side of the other three, if these
/// are counter-clockwise as seen from outside.
template <class S, int Dim, std::size_t N>
S simplex_volume(const VecOf<S, Dim> (&x)[N]) {
  return facet_volume(simplex_edges(x).y);
}

/// The inverse of the matrix X whose columns are the edges y_k [1/length]; its row k is the gradient of the
/// weight of corner k, which is linear, 1 at this corner and 0 at the others. Where the simplex is flat, X
/// has no inverse, and the numbers are not finite.
inline Mat<2> inverse_of_edges(const SimplexEdges<double, 2>& edges) {
  const auto& [a, b] = edges.y;
  const double d = 1 / cross(a, b);
  return {{{b[1] * d, -b[0] * d}, {-a[1] * d, a[0] * d}}};
}
inline Mat<3> inverse_of_edges(const SimplexEdges<double, 3>& edges) {
  const auto& [a, b, c] = edges.y;
  const Vec3 row[3] = {cross(b, c), cross(c, a), cross(a, b)};
  const double d = 1 / dot(a, row[0]);
  Mat<3> inverse;
  for (int k = 0; k < 3; ++k)
    for (int m = 0; m < 3; ++m) inverse[k][m] = row[k][m] * d;
  return inverse;
}

}  // namespace supple
