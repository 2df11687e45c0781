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

TEST(ElementStrain, HoldsWhatEveryTermMust) {
  testing::check_term<ElementStrain<2>, 2>(draw_element<2>);
  testing::check_term<ElementStrain<3>, 3>(draw_element<3>);
}

}  // namespace
}  // namespace supple
