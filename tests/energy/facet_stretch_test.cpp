#include "supple/energy/facet_stretch.hpp"

#include "tests/support/term_check.hpp"

namespace supple {
namespace {

template <int Dim>
void draw(RandomStream& stream, Vec<Dim> (&x)[Dim], typename FacetStretch<Dim>::Param& p) {
  testing::draw_points(stream, x);
  p = {stream.uniform(0.5, 3), stream.uniform(0, 1)};
}

TEST(FacetStretch, HoldsWhatEveryTermMust) {
  testing::check_term<FacetStretch<2>, 2>(draw<2>);
  testing::check_term<FacetStretch<3>, 3>(draw<3>);
}

TEST(FacetStretch, IsASpringInTwoDimensionsAndAnAreaInThree) {
  const Vec2 edge[2] = {{1, 1}, {4, 5}};
  EXPECT_DOUBLE_EQ(FacetStretch<2>::energy(edge, {2, 3}), 4);
  Vec2 gradient[2];
  term_gradient<FacetStretch<2>, 2>(edge, {2, 3}, gradient);
  EXPECT_LT(norm(gradient[1] - 2 * (5 - 3) * Vec2{0.6, 0.8}), 1e-15);

  const Vec3 triangle[3] = {{0, 0, 1}, {3, 0, 1}, {0, 4, 1}};
  EXPECT_DOUBLE_EQ(FacetStretch<3>::energy(triangle, {2, 5}), 1);
}

TEST(FacetStretch, DeclaresItsParameters) {
  const auto& [stiffness, rest] = FacetStretch<3>::fields;
  EXPECT_EQ(stiffness.name, "stiffness");
  EXPECT_EQ(rest.unit, "length^(Dim-1)");
  FacetStretch<3>::Param p{7, 8};
  EXPECT_EQ(p.*std::get<double FacetStretch<3>::Param::*>(rest.member), 8);
}

}  // namespace
}  // namespace supple
