#include "supple/energy/facet_tension.hpp"
#include "supple/energy/hinge_bend.hpp"
#include "supple/energy/list.hpp"
#include "tests/support/term_check.hpp"

namespace supple {
namespace {

template <int Dim>
void draw_tension(RandomStream& stream, Vec<Dim> (&x)[Dim], typename FacetTension<Dim>::Param& p) {
  testing::draw_points(stream, x);
  p = {stream.uniform(0.5, 3)};
}

template <int Dim>
void draw_hinge(RandomStream& stream, Vec<Dim> (&x)[Dim + 1], typename HingeBend<Dim>::Param& p) {
  do testing::draw_points(stream, x);  // not near a fold, where the angle jumps
  while (std::abs(hinge_angle(x)) > 3);
  p = {stream.uniform(0.5, 3), stream.uniform(-1, 1)};
}

TEST(FacetTension, HoldsWhatEveryTermMust) {
  testing::check_term<FacetTension<2>, 2>(draw_tension<2>);
  testing::check_term<FacetTension<3>, 3>(draw_tension<3>);
}

TEST(HingeBend, HoldsWhatEveryTermMust) {
  testing::check_term<HingeBend<2>, 2>(draw_hinge<2>);
  testing::check_term<HingeBend<3>, 3>(draw_hinge<3>);
}

/// A body term on a closed boundary of few sites, for the harness: a triangle, a tetrahedron.
template <class Term, int Dim>
struct OfASimplex {
  static constexpr std::string_view name = Term::name;
  static constexpr int arity = Dim + 1;
  using Param = typename Term::Param;
  template <class S>
  static S energy(const VecOf<S, Dim> (&x)[arity], const Param& p) {
    S sum(0.0);
    const auto add = [&](auto... k) {
      const VecOf<S, Dim> facet[Dim] = {x[k]...};
      sum += Term::measure(facet);
    };
    if constexpr (Dim == 2) add(0, 1), add(1, 2), add(2, 0);
    else add(0, 2, 1), add(0, 1, 3), add(1, 2, 3), add(2, 0, 3);
    return Term::energy(sum, p);
  }
};

template <class Term, int Dim>
void draw_simplex(RandomStream& stream, Vec<Dim> (&x)[Dim + 1], typename Term::Param& p) {
  testing::draw_points(stream, x);
  p = {stream.uniform(0.5, 3), stream.uniform(0, 1)};
}

TEST(BodyTerms, HoldWhatEveryTermMust) {
  std::apply(
      []<class... Term>(Term...) {
        (testing::check_term<OfASimplex<Term, 2>, 2>(draw_simplex<Term, 2>), ...);
        (testing::check_term<OfASimplex<Term, 3>, 3>(draw_simplex<Term, 3>), ...);
      },
      BodyTerms{});
}

TEST(HingeAngle, IsZeroWhereFlatAndPositiveWhereConvex) {
  const Vec2 flat[3] = {{0, 0}, {1, 0}, {3, 0}}, left[3] = {{0, 0}, {1, 0}, {1, 1}},
             right[3] = {{0, 0}, {1, 0}, {1, -1}};
  EXPECT_DOUBLE_EQ(hinge_angle(flat), 0);
  EXPECT_DOUBLE_EQ(hinge_angle(left), M_PI / 2);
  EXPECT_DOUBLE_EQ(hinge_angle(right), -M_PI / 2);
  // Faces with the outward normals +x and +y meet along z: convex; the other way round: a groove.
  const Vec3 convex[4] = {{0, 0, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}},
             groove[4] = {{0, 0, 1}, {0, 0, 0}, {-1, 0, 0}, {0, -1, 0}};
  EXPECT_DOUBLE_EQ(std::abs(hinge_angle(convex)), M_PI / 2);
  EXPECT_DOUBLE_EQ(hinge_angle(convex), -hinge_angle(groove));
}

TEST(HingeAngle, OfATetrahedronIsThatOfItsFaces) {
  const Vec3 a{1, 1, 1}, b{1, -1, -1}, c{-1, 1, -1}, d{-1, -1, 1};
  // Faces seen from outside counter-clockwise: (a, b, c) and (b, a, d).
  const Vec3 outward = cross(b - a, c - a);
  ASSERT_GT(dot(outward, a + b + c), 0);
  const Vec3 hinge[4] = {a, b, c, d};
  EXPECT_NEAR(hinge_angle(hinge), M_PI - std::acos(1.0 / 3), 1e-15);
}

}  // namespace
}  // namespace supple
