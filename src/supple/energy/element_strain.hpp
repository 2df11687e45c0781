#pragma once
#include <fmt/core.h>

#include <string_view>
#include <tuple>

#include "supple/core/error.hpp"
#include "supple/core/field.hpp"
#include "supple/energy/elastic_constants.hpp"
#include "supple/geometry/simplex.hpp"

namespace supple {

/// Strain energy of a triangle in 2D, a tetrahedron in 3D, of isotropic elastic material [MacKeith 2025, eq.
/// 9.15-9.17; the material of St. Venant and Kirchhoff]:
///     E = v0 [(lambda/2) (tr eps)^2 + mu eps:eps],   eps = (J^T J - I)/2,   J = Y X^-1.
/// The columns of X and of Y are the vectors from the last of the sites to the others, at rest and now; v0 =
/// det X/Dim! is the area (volume) at rest. lambda and mu [energy/length^Dim] are Lame's constants of
/// elastic_constants.hpp. The energy depends on the lengths of edges alone, and therefore knows no difference
/// between an element and its mirror image: whether it is inverted, `orientation` says.
template <int Dim>
struct ElementStrain {
  static constexpr std::string_view name = "element_strain";
  static constexpr int arity = Dim + 1;
  struct Param {
    double lambda, mu;
    double inverse[Dim * Dim];  ///< X^-1 [1/length], row after row
  };
  static constexpr auto fields =
      std::tuple{Field<Param>{"lambda", &Param::lambda, "energy/length^Dim", "Lame's first constant"},
                 Field<Param>{"mu", &Param::mu, "energy/length^Dim", "shear modulus mu", not_negative}};

  /// The parameters of an element whose sites are at x [length] where it is at rest. Input error unless its
  /// area (volume, simplex_volume) is positive.
  static Param at_rest(const Vec<Dim> (&x)[arity], const LameConstants& material) {
    if (const double v0 = simplex_volume(x); !(v0 > 0 && v0 < 1e300))
      throw input_error(fmt::format("an elastic element with the {} {}", Dim == 2 ? "area" : "volume", v0),
                        "at rest it must be positive",
                        Dim == 2 ? "order its corners counter-clockwise"
                                 : "order its first three corners counter-clockwise as seen from outside");
    const Mat<Dim> inverse = inverse_of_edges(simplex_edges(x));
    Param p{material.lambda, material.mu, {}};
    for (int k = 0; k < Dim; ++k)
      for (int m = 0; m < Dim; ++m) p.inverse[k * Dim + m] = inverse[k][m];
    return p;
  }

  /// Area (volume) at rest, v0 [length^Dim].
  static double rest_volume(const Param& p) {
    constexpr double factorial = Dim == 2 ? 2 : 6;
    return 1 / (factorial * determinant(inverse_matrix(p)));
  }

  /// det J, by how much the area (volume) has grown: below 0 where the element is turned inside out.
  static double orientation(const Vec<Dim> (&x)[arity], const Param& p) {
    constexpr double factorial = Dim == 2 ? 2 : 6;
    return factorial * simplex_volume(x) * determinant(inverse_matrix(p));
  }

  template <class S>
  static S energy(const VecOf<S, Dim> (&x)[arity], const Param& p) {
    S J[Dim][Dim], strain[Dim][Dim];
    deform(x, p, J);
    find_strain(J, strain);
    return rest_volume(p) * density(strain, p);
  }

  /// By the first stress J (lambda tr(eps) I + 2 mu eps), the derivative of the energy per volume by J: its
  /// product with the transpose of X^-1 has the gradient at corner k as column k.
  static double gradient(const Vec<Dim> (&x)[arity], const Param& p, Vec<Dim> (&g)[arity]) {
    Vec<Dim> J[Dim], P[Dim];  // columns
    for (int m = 0; m < Dim; ++m) {
      J[m] = p.inverse[m] * (x[0] - x[Dim]);
      for (int k = 1; k < Dim; ++k) J[m] += p.inverse[k * Dim + m] * (x[k] - x[Dim]);
    }
    const double v0 = rest_volume(p);
    double trace = 0, square = 0;
    for (int m = 0; m < Dim; ++m) {
      const double strain = 0.5 * (dot(J[m], J[m]) - 1);
      trace += strain;
      square += strain * strain;
      P[m] = (2 * p.mu * v0 * strain) * J[m];
    }
    for (int m = 1; m < Dim; ++m)
      for (int n = 0; n < m; ++n) {
        const double twice = dot(J[m], J[n]), shear = p.mu * v0 * twice;
        square += 0.5 * twice * twice;
        P[m] += shear * J[n];
        P[n] += shear * J[m];
      }
    for (int m = 0; m < Dim; ++m) P[m] += (v0 * p.lambda * trace) * J[m];
    g[Dim] = {};
    for (int k = 0; k < Dim; ++k) {
      g[k] = p.inverse[k * Dim] * P[0];
      for (int m = 1; m < Dim; ++m) g[k] += p.inverse[k * Dim + m] * P[m];
      g[Dim] -= g[k];
    }
    return v0 * (0.5 * p.lambda * trace * trace + p.mu * square);
  }

 private:
  static Mat<Dim> inverse_matrix(const Param& p) {
    Mat<Dim> inverse;
    for (int k = 0; k < Dim; ++k)
      for (int m = 0; m < Dim; ++m) inverse[k][m] = p.inverse[k * Dim + m];
    return inverse;
  }

  template <class S>
  static void deform(const VecOf<S, Dim> (&x)[arity], const Param& p, S (&J)[Dim][Dim]) {
    const SimplexEdges<S, Dim> edges = simplex_edges(x);
    for (int a = 0; a < Dim; ++a)
      for (int m = 0; m < Dim; ++m) {
        J[a][m] = edges.y[0][a] * p.inverse[m];
        for (int k = 1; k < Dim; ++k) J[a][m] += edges.y[k][a] * p.inverse[k * Dim + m];
      }
  }

  /// eps = (J^T J - I)/2.
  template <class S>
  static void find_strain(const S (&J)[Dim][Dim], S (&strain)[Dim][Dim]) {
    for (int m = 0; m < Dim; ++m)
      for (int n = 0; n <= m; ++n) {
        S sum = J[0][m] * J[0][n];
        for (int a = 1; a < Dim; ++a) sum += J[a][m] * J[a][n];
        strain[m][n] = strain[n][m] = 0.5 * (m == n ? sum - 1.0 : sum);
      }
  }

  /// Energy per area (volume) at rest.
  template <class S>
  static S density(const S (&strain)[Dim][Dim], const Param& p) {
    S trace = strain[0][0], square = strain[0][0] * strain[0][0];
    for (int m = 1; m < Dim; ++m) {
      trace += strain[m][m];
      square += strain[m][m] * strain[m][m];
      for (int n = 0; n < m; ++n) square += 2.0 * (strain[m][n] * strain[m][n]);
    }
    return 0.5 * p.lambda * (trace * trace) + p.mu * square;
  }
};

}  // namespace supple
