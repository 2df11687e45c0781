/// Elastic elements that fill a square or a cube, under a uniform deformation x -> F x.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "supple/core/random.hpp"
#include "supple/energy/element_strain.hpp"
#include "supple/energy/term.hpp"

namespace supple {
namespace {

template <int Dim>
struct Block {
  std::vector<Vec<Dim>> node;
  std::vector<bool> within;  ///< not on a side
  std::vector<std::array<std::int32_t, Dim + 1>> element;
};

/// A square or cube of edge 1, each of its side^Dim cells cut along its diagonal into Dim! elements (one for
/// each order in which a path along edges goes from its lowest to its highest corner), the nodes within
/// moved.
template <int Dim>
Block<Dim> block(int side) {
  Block<Dim> b;
  RandomStream draw(3, Purpose::test);
  const int nodes = side + 1;
  int count = 1, cells = 1;
  for (int d = 0; d < Dim; ++d) count *= nodes, cells *= side;
  for (int n = 0; n < count; ++n) {
    Vec<Dim> x;
    bool within = true;
    for (int d = 0, rest = n; d < Dim; ++d, rest /= nodes) {
      x[d] = rest % nodes;
      within = within && rest % nodes != 0 && rest % nodes != side;
    }
    for (int d = 0; d < Dim; ++d) x[d] = (x[d] + (within ? draw.uniform(-0.2, 0.2) : 0)) / side;
    b.node.push_back(x);
    b.within.push_back(within);
  }
  for (int cell = 0; cell < cells; ++cell) {
    std::array<int, Dim> order;
    std::iota(order.begin(), order.end(), 0);
    do {
      int site = 0;
      for (int d = 0, rest = cell, stride = 1; d < Dim; ++d, rest /= side, stride *= nodes)
        site += rest % side * stride;
      std::array<std::int32_t, Dim + 1> element{site};
      for (int k = 0; k < Dim; ++k) {
        int stride = 1;
        for (int d = 0; d < order[k]; ++d) stride *= nodes;
        element[k + 1] = site += stride;
      }
      Vec<Dim> x[Dim + 1];
      for (int k = 0; k <= Dim; ++k) x[k] = b.node[element[k]];
      if (simplex_volume(x) < 0) std::swap(element[0], element[1]);
      b.element.push_back(element);
    } while (std::next_permutation(order.begin(), order.end()));
  }
  return b;
}

/// Energy per volume and first stress P = F (lambda tr(eps) I + 2 mu eps) of a uniform deformation.
template <int Dim>
double density(const Mat<Dim>& F, const LameConstants& c, Mat<Dim>& P) {
  Mat<Dim> eps, S;
  double trace = 0, square = 0;
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j < Dim; ++j) {
      for (int a = 0; a < Dim; ++a) eps[i][j] += 0.5 * F[a][i] * F[a][j];
      if (i == j) eps[i][j] -= 0.5, trace += eps[i][j];
      square += eps[i][j] * eps[i][j];
    }
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j < Dim; ++j) S[i][j] = 2 * c.mu * eps[i][j] + (i == j ? c.lambda * trace : 0);
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j < Dim; ++j)
      for (int a = 0; a < Dim; ++a) P[i][j] += F[i][a] * S[a][j];
  return 0.5 * c.lambda * trace * trace + c.mu * square;
}

template <int Dim>
void check_uniform_deformation(const Mat<Dim>& F) {
  const Block<Dim> b = block<Dim>(3);
  const LameConstants material = lame_constants<Dim>({2, 0.3});
  Mat<Dim> P, found;
  const double expected = density(F, material, P);
  std::vector<Vec<Dim>> force(b.node.size());
  double sum = 0;
  for (const auto& element : b.element) {
    Vec<Dim> x[Dim + 1], g[Dim + 1];
    for (int k = 0; k <= Dim; ++k) x[k] = b.node[element[k]];
    const auto p = ElementStrain<Dim>::at_rest(x, material);
    for (Vec<Dim>& point : x) point = F * point;
    const double energy = ElementStrain<Dim>::gradient(x, p, g);
    EXPECT_NEAR(energy, ElementStrain<Dim>::rest_volume(p) * expected, 1e-14);
    sum += energy;
    for (int k = 0; k <= Dim; ++k) {
      force[element[k]] -= g[k];
      found.add_outer(1, g[k], b.node[element[k]]);
    }
  }
  EXPECT_NEAR(sum, expected, 1e-12);
  // The volume is 1: the sum of dE/dx X is the first stress. Nodes within are in balance.
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j < Dim; ++j) EXPECT_NEAR(found[i][j], P[i][j], 1e-12);
  int within = 0;
  for (std::size_t i = 0; i < b.node.size(); ++i)
    if (b.within[i]) {
      EXPECT_LT(norm(force[i]), 1e-13);
      ++within;
    }
  EXPECT_GT(within, 0);
}

TEST(AffineStrain, GivesTheEnergyAndStressOfFiniteStrain) {
  check_uniform_deformation<2>({{{1.3, 0.2}, {-0.4, 0.8}}});
  check_uniform_deformation<3>({{{1.3, 0.2, -0.1}, {-0.4, 0.8, 0.3}, {0.1, 0.25, 1.1}}});
}

/// d2E/dF_ij dF_kl at rest, per volume: sum of x_j x_l times the second derivatives by coordinates i and k.
template <int Dim>
void check_elastic_tensor() {
  const Block<Dim> b = block<Dim>(2);
  const LameConstants c = lame_constants<Dim>({2, 0.3});
  double C[Dim][Dim][Dim][Dim]{};
  for (const auto& element : b.element) {
    Vec<Dim> x[Dim + 1];
    for (int k = 0; k <= Dim; ++k) x[k] = b.node[element[k]];
    const auto h = term_hessian<ElementStrain<Dim>, Dim>(x, ElementStrain<Dim>::at_rest(x, c));
    for (int m = 0; m <= Dim; ++m)
      for (int n = 0; n <= Dim; ++n)
        for (int i = 0; i < Dim; ++i)
          for (int j = 0; j < Dim; ++j)
            for (int k = 0; k < Dim; ++k)
              for (int l = 0; l < Dim; ++l) C[i][j][k][l] += h[m * Dim + i][n * Dim + k] * x[m][j] * x[n][l];
  }
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j < Dim; ++j)
      for (int k = 0; k < Dim; ++k)
        for (int l = 0; l < Dim; ++l)
          EXPECT_NEAR(C[i][j][k][l],
                      c.lambda * (i == j && k == l) + c.mu * ((i == k && j == l) + (i == l && j == k)),
                      1e-10);
}

TEST(AffineStrain, GivesTheElasticTensorOfTheMaterial) {
  check_elastic_tensor<2>();
  check_elastic_tensor<3>();
}

/// Small strains: a bar under tension (E and nu), and a change of size (bulk modulus lambda + 2 mu/Dim).
template <int Dim>
void check_small_strain() {
  const double E = 2, nu = 0.3, strain = 1e-6;
  const LameConstants c = lame_constants<Dim>({E, nu});
  Mat<Dim> bar, swollen;
  for (int d = 0; d < Dim; ++d) {
    bar[d][d] = 1 - nu * strain;
    swollen[d][d] = 1 + strain;
  }
  bar[0][0] = 1 + strain;
  const Block<Dim> b = block<Dim>(2);
  double of_bar = 0, of_swollen = 0;
  for (const auto& element : b.element) {
    Vec<Dim> x[Dim + 1], y[Dim + 1];
    for (int k = 0; k <= Dim; ++k) x[k] = b.node[element[k]];
    const auto p = ElementStrain<Dim>::at_rest(x, c);
    for (int k = 0; k <= Dim; ++k) y[k] = bar * x[k];
    of_bar += ElementStrain<Dim>::energy(y, p);
    for (int k = 0; k <= Dim; ++k) y[k] = swollen * x[k];
    of_swollen += ElementStrain<Dim>::energy(y, p);
  }
  EXPECT_NEAR(of_bar / (0.5 * strain * strain), E, 1e-5 * E);
  EXPECT_NEAR(of_swollen / (0.5 * Dim * Dim * strain * strain), c.lambda + 2 * c.mu / Dim, 1e-5 * E);
}

TEST(AffineStrain, GivesTheModuliOfSmallStrain) {
  check_small_strain<2>();
  check_small_strain<3>();
}

}  // namespace
}  // namespace supple
