#include "supple/energy/bond_stretch.hpp"
#include "supple/energy/element_strain.hpp"
#include "tests/support/term_check.hpp"

namespace supple {
namespace {

template <int Dim>
void draw_bond(RandomStream& stream, Vec<Dim> (&x)[2], typename BondStretch<Dim>::Param& p) {
  testing::draw_points(stream, x);
  p = {stream.uniform(0.5, 3), stream.uniform(0, 1)};
}

/// A simplex at rest that is not flat.
template <int Dim>
void draw_rest(RandomStream& stream, Vec<Dim> (&x)[Dim + 1]) {
  do testing::draw_points(stream, x);
  while (simplex_volume(x) < 0.1);
}

template <int Dim>
void draw_element(RandomStream& stream, Vec<Dim> (&x)[Dim + 1], typename ElementStrain<Dim>::Param& p) {
  draw_rest(stream, x);
  p = ElementStrain<Dim>::at_rest(x, {stream.uniform(-0.2, 2), stream.uniform(0.5, 3)});
  for (Vec<Dim>& point : x)
    for (int d = 0; d < Dim; ++d) point[d] += stream.uniform(-0.4, 0.4);
}

TEST(BondStretch, HoldsWhatEveryTermMust) {
  testing::check_term<BondStretch<2>, 2>(draw_bond<2>);
  testing::check_term<BondStretch<3>, 3>(draw_bond<3>);
}

TEST(BondStretch, IsASpring) {
  const Vec3 x[2] = {{1, 1, 7}, {4, 5, 7}};
  EXPECT_DOUBLE_EQ(BondStretch<3>::energy(x, {2, 3}), 4);
  Vec3 g[2];
  BondStretch<3>::gradient(x, {2, 3}, g);
  EXPECT_LT(norm(g[1] - 2 * (5 - 3) * Vec3{0.6, 0.8, 0}), 1e-15);
}

TEST(BondStretch, BetweenSitesAtOnePlaceHasItsEnergyAndNoForce) {
  const Vec2 x[2] = {{1, 2}, {1, 2}};
  const BondStretch<2>::Param p{3, 2};
  Vec2 g[2] = {{9, 9}, {9, 9}}, by_jets[2];
  EXPECT_EQ(BondStretch<2>::gradient(x, p, g), 6);
  EXPECT_EQ(BondStretch<2>::energy(x, p), 6);
  EXPECT_EQ((jet_gradient<BondStretch<2>, 2>(x, p, by_jets)), 6);
  for (int a = 0; a < 2; ++a) {
    EXPECT_EQ(g[a], Vec2{});
    EXPECT_EQ(by_jets[a], Vec2{});
  }
  for (const auto& row : term_hessian<BondStretch<2>, 2>(x, p))
    for (const double h : row) EXPECT_TRUE(std::isfinite(h));
}

TEST(ElementStrain, HoldsWhatEveryTermMust) {
  testing::check_term<ElementStrain<2>, 2>(draw_element<2>);
  testing::check_term<ElementStrain<3>, 3>(draw_element<3>);
}

template <int Dim>
void check_rest_and_orientation() {
  RandomStream stream(2, Purpose::test);
  Vec<Dim> x[Dim + 1], moved[Dim + 1], g[Dim + 1];
  draw_rest<Dim>(stream, x);
  const auto p = ElementStrain<Dim>::at_rest(x, {1.5, 0.5});
  EXPECT_NEAR(ElementStrain<Dim>::rest_volume(p), simplex_volume(x), 1e-15);
  EXPECT_NEAR(ElementStrain<Dim>::energy(x, p), 0, 1e-28);
  EXPECT_NEAR(ElementStrain<Dim>::orientation(x, p), 1, 1e-14);
  for (int a = 0; a <= Dim; ++a) {
    moved[a] = 1.1 * x[a];
    moved[a][0] *= 1.2;
  }
  EXPECT_NEAR(ElementStrain<Dim>::orientation(moved, p), 1.2 * std::pow(1.1, Dim), 1e-13);
  const double energy = ElementStrain<Dim>::gradient(moved, p, g);
  // The mirror image has the same energy, and its forces are mirrored: only the orientation tells.
  Vec<Dim> mirrored[Dim + 1], image[Dim + 1];
  for (int a = 0; a <= Dim; ++a) {
    mirrored[a] = moved[a];
    mirrored[a][1] *= -1;
  }
  EXPECT_NEAR(ElementStrain<Dim>::gradient(mirrored, p, image), energy, 1e-14);
  EXPECT_NEAR(ElementStrain<Dim>::orientation(mirrored, p), -1.2 * std::pow(1.1, Dim), 1e-13);
  for (int a = 0; a <= Dim; ++a) {
    image[a][1] *= -1;
    EXPECT_LT(norm(image[a] - g[a]), 1e-14);
  }
}

TEST(ElementStrain, KnowsItsRestStateAndWhetherItIsInverted) {
  check_rest_and_orientation<2>();
  check_rest_and_orientation<3>();
}

TEST(ElementStrain, RefusesAnInvertedOrFlatElementAtRest) {
  const Vec2 clockwise[3] = {{0, 0}, {0, 1}, {1, 0}}, flat[3] = {{0, 0}, {1, 1}, {2, 2}};
  EXPECT_THROW(ElementStrain<2>::at_rest(clockwise, {1, 1}), Error);
  EXPECT_THROW(ElementStrain<2>::at_rest(flat, {1, 1}), Error);
  const Vec3 inward[4] = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, -1}};
  EXPECT_THROW(ElementStrain<3>::at_rest(inward, {1, 1}), Error);
}

}  // namespace
}  // namespace supple
