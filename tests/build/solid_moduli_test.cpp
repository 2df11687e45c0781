/// The elastic constants that solids show when they are measured.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "supple/build/surfaces.hpp"
#include "tests/support/solid_response.hpp"

namespace supple {
namespace {

using std::numbers::pi;
using testing::SolidResponse;

/// Young's modulus of the triangular lattice of springs of stiffness 1.
const double lattice_modulus = 2 / std::numbers::sqrt3;

/// A rectangle of the triangular lattice with bonds of length 1 along its rows, every second of which is
/// shifted by half a bond.
struct LatticePatch {
  int columns, rows;
  SolidMesh<2> mesh;

  LatticePatch(int n, int m) : columns(n), rows(m) {
    for (int j = 0; j < m; ++j)
      for (int i = 0; i < n; ++i) mesh.node.push_back({i + 0.5 * (j % 2), 0.5 * std::numbers::sqrt3 * j});
    for (int a = 0; a < n * m; ++a)
      for (int b = a + 1; b < std::min(n * m, a + n + 2); ++b)
        if (norm(mesh.node[b] - mesh.node[a]) < 1.1) mesh.bond.push_back({a, b});
  }
  int node(int column, int row) const { return row * columns + column; }

  /// Pulls at two opposite sides by a strain of 1 along direction d, while nodes may slide along these sides
  /// and the others are free. The springs along the first and the last row are half as stiff: in the lattice
  /// they belong to its other side too. Young's modulus is the force by the width; Poisson's ratio that of
  /// the middle third.
  ElasticConstants pull(int d) const {
    SolidResponse<2> response(mesh);
    response.add_springs([&](const auto& b) {
      const int row = b[0] / columns;
      return row == b[1] / columns && (row == 0 || row == rows - 1) ? 0.5 : 1.0;
    });
    const auto side = [&](int i) {  // -1, 0 or 1
      const int at = d == 0 ? i % columns : i / columns, last = (d == 0 ? columns : rows) - 1;
      return (at == last) - (at == 0);
    };
    Eigen::VectorXd given(2 * columns * rows);
    for (int i = 0; i < columns * rows; ++i) given[2 * i + d] = mesh.node[i][d];
    const Eigen::VectorXd u = response.solve([&](int i, int c) { return c == d && side(i) != 0; }, given,
                                             Eigen::VectorXd::Zero(given.size()));
    const Eigen::VectorXd f = response.forces_of(u);
    double force = 0;
    for (int i = 0; i < columns * rows; ++i)
      if (side(i) == 1) force += f[2 * i + d];
    double across = 0;
    const int length = d == 0 ? columns : rows, breadth = d == 0 ? rows : columns;
    for (int k = length / 3; k < 2 * length / 3; ++k) {
      const int low = d == 0 ? node(k, 0) : node(0, k),
                high = d == 0 ? node(k, rows - 1) : node(columns - 1, k);
      across += (u[2 * high + 1 - d] - u[2 * low + 1 - d]) /
                ((2 * length / 3 - length / 3) * (mesh.node[high][1 - d] - mesh.node[low][1 - d]));
    }
    // Along rows each bond across belongs to a width of sqrt(3)/2, across rows each pair of these to 1.
    const double width = d == 0 ? 0.5 * std::numbers::sqrt3 * (breadth - 1) : breadth - 0.5;
    return {force / width, -across};
  }
};

TEST(SolidModuli, OfTheTriangularLatticeAreThoseOfTheory) {
  const LatticePatch patch(48, 54);
  for (const int direction : {0, 1}) {
    const ElasticConstants found = patch.pull(direction);
    EXPECT_NEAR(found.young_modulus, lattice_modulus, 0.01 * lattice_modulus) << "direction " << direction;
    EXPECT_NEAR(found.poisson_ratio, 1.0 / 3, 0.01 / 3) << "direction " << direction;
  }
  EXPECT_NEAR(patch.pull(0).young_modulus, lattice_modulus, 1e-9);
}

TEST(SolidModuli, OfADisorderedDiscAreNearThoseOfTheTriangularLattice) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const SolidMesh<2> mesh = network_disc(1100, 1, seed);
    SolidResponse<2> disc(mesh);
    disc.add_springs([](const auto&) { return 1.0; });
    const ElasticConstants held = disc.constants_by_displacement(), pulled = disc.constants_by_tension();
    EXPECT_NEAR(held.young_modulus, 1.047 * lattice_modulus, 0.01 * lattice_modulus);
    EXPECT_NEAR(pulled.young_modulus, 1.032 * lattice_modulus, 0.01 * lattice_modulus);
    EXPECT_NEAR(held.poisson_ratio, 0.336, 0.003);
    EXPECT_NEAR(pulled.poisson_ratio, 0.33, 0.01);
    // Constraints stiffen: a uniform strain of all nodes most of all.
    EXPECT_LT(pulled.young_modulus, held.young_modulus);
    EXPECT_LT(held.young_modulus, affine_modulus(mesh, 1));
  }
}

TEST(SolidModuli, OfADisorderedBallAreSomewhatBelowAffineOnes) {
  const SolidMesh<3> mesh = network_ball(3765, 1, 1);
  SolidResponse<3> ball(mesh);
  ball.add_springs([](const auto&) { return 1.0; });
  const double affine = affine_modulus(mesh, 1);
  const ElasticConstants held = ball.constants_by_displacement(), pulled = ball.constants_by_tension();
  EXPECT_NEAR(held.young_modulus, 0.94 * affine, 0.01 * affine);
  EXPECT_NEAR(pulled.young_modulus, 0.91 * affine, 0.01 * affine);
  EXPECT_NEAR(held.poisson_ratio, 0.251, 0.004);
  EXPECT_NEAR(pulled.poisson_ratio, 0.251, 0.01);
}

/// A solid of elements under a uniform tension, and under a pressure, at its boundary alone, with its centre
/// free: the strain of each element is the same, so that the constants must come back to rounding.
template <int Dim>
void check_star(const SolidMesh<Dim>& mesh, const ElasticConstants& material) {
  SolidResponse<Dim> solid(mesh);
  solid.add_elements(lame_constants<Dim>(material));
  const ElasticConstants held = solid.constants_by_displacement(), pulled = solid.constants_by_tension();
  const auto [lambda, mu] = lame_constants<Dim>(material);
  for (const ElasticConstants& found : {held, pulled}) {
    EXPECT_NEAR(found.young_modulus, material.young_modulus, 1e-8 * material.young_modulus);
    EXPECT_NEAR(found.poisson_ratio, material.poisson_ratio, 1e-8);
  }
  EXPECT_NEAR(solid.bulk_by_pressure(), lambda + 2 * mu / Dim, 1e-8 * material.young_modulus);
}

TEST(SolidModuli, OfElementsAboutACentreAreThoseOfTheirMaterial) {
  for (const int vertices : {162, 642})
    check_star<3>(star_mesh(geodesic_icosahedron(vertices, 2.5)), {2, 0.3});
  std::vector<Vec2> ring;
  for (int k = 0; k < 60; ++k) ring.push_back({std::cos(2 * pi * k / 60), std::sin(2 * pi * k / 60)});
  check_star<2>(star_mesh(ring), {2, 0.3});
}

}  // namespace
}  // namespace supple
