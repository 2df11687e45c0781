#include "supple/force/terms.hpp"

#include <gtest/gtest.h>

#include "supple/core/error.hpp"
#include "supple/core/random.hpp"
#include "supple/energy/list.hpp"
#include "supple/force/force_field.hpp"
#include "supple/model/discs.hpp"

namespace supple {
namespace {

/// A ring of n sites, not quite round, and its edges.
System<2> ring(int n) {
  System<2> system;
  system.state.resize(n);
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * 3.14159265358979 * i / n;
    const double r = 1 + 0.1 * RandomStream(1, Purpose::test, static_cast<std::uint64_t>(i)).uniform();
    system.state.position[i] = {r * std::cos(angle), r * std::sin(angle)};
    system.topology.facet.push_back({i, (i + 1) % n});
  }
  return system;
}

Evaluation<2> evaluate(const TermSet<2>& terms, const System<2>& system, Detail detail = Detail::energies) {
  Evaluation<2> out;
  out.force.assign(system.state.size(), Vec2{});
  terms.evaluate(system, detail, out);
  return out;
}

TEST(TermSet, AddsTheTermsOfEachStencilWithItsOwnParameters) {
  const System<2> system = ring(5);
  std::vector<FacetStretch<2>::Param> params;
  for (int k = 0; k < 5; ++k) params.push_back({1.0 + k, 0.1 * k});
  TermSet<2> terms;
  terms.add(FacetStretch<2>{}, system.topology.facet, params);
  terms.add(FacetStretch<2>{}, system.topology.facet, {{2, 0}});
  double first = 0, second = 0;
  for (int k = 0; k < 5; ++k) {
    const Vec2 edge[2] = {system.state.position[k], system.state.position[(k + 1) % 5]};
    first += FacetStretch<2>::energy(edge, params[k]);
    second += FacetStretch<2>::energy(edge, {2, 0});
  }
  const auto parts = terms.energies(system);
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].first, "facet_stretch");
  EXPECT_DOUBLE_EQ(parts[0].second, first);
  EXPECT_DOUBLE_EQ(parts[1].second, second);
  EXPECT_DOUBLE_EQ(evaluate(terms, system).energy.terms, first + second);
  EXPECT_EQ(evaluate(terms, system, Detail::forces).force, evaluate(terms, system).force);
  EXPECT_EQ(evaluate(terms, system, Detail::forces).energy.terms, 0);
}

TEST(TermSet, ForceIsMinusTheSlopeOfTheWholeEnergy) {
  System<2> system = ring(7);
  TermSet<2> terms;
  terms.add(FacetStretch<2>{}, system.topology.facet, {{3, 0.4}});
  const Evaluation<2> out = evaluate(terms, system);
  for (int i = 0; i < 7; ++i)
    for (int d = 0; d < 2; ++d) {
      const double h = 1e-6;
      double& x = system.state.position[i][d];
      const double x0 = x;
      x = x0 + h;
      const double above = terms.energies(system)[0].second;
      x = x0 - h;
      const double below = terms.energies(system)[0].second;
      x = x0;
      EXPECT_NEAR(out.force[i][d], -(above - below) / (2 * h), 1e-8);
    }
}

TEST(TermSet, GivesTheSameBitsForOneAndTwoThreads) {
  const System<2> system = ring(3000);
  TermSet<2> terms;
  terms.add(FacetStretch<2>{}, system.topology.facet, {{3, 0.001}});
  const Evaluation<2> one = evaluate(terms, system);
  thread_count() = 2;
  const Evaluation<2> two = evaluate(terms, system);
  thread_count() = 1;
  EXPECT_EQ(one.force, two.force);
  EXPECT_EQ(one.energy.terms, two.energy.terms);
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b) EXPECT_EQ(one.virial[a][b], two.virial[a][b]);
}

TEST(TermSet, ActsBesideContactsInTheForceField) {
  Box<2> box;
  box.length = {20, 20};
  System<2> system =
      listed_discs(box, {{5, 5}, {8, 5}, {9, 5}}, {1, 1, 1}, 1);  // a spring, then an overlap of 1
  const PairStiffness stiffness{10, 0, 10, 0};
  ForceField<2> field(
      DiscContacts(Divergent(0), {stiffness, stiffness, Tensile(), 0, Slip::clamp, LeverArm::distance}));
  field.terms().add(FacetStretch<2>{}, {{0, 1}}, {{4, 2.5}});
  Evaluation<2> out;
  field.evaluate(system, Detail::energies, out);
  EXPECT_DOUBLE_EQ(out.force[0][0], 4 * 0.5);
  EXPECT_DOUBLE_EQ(out.force[1][0], -4 * 0.5 - 10);
  EXPECT_DOUBLE_EQ(out.force[2][0], 10);
  EXPECT_DOUBLE_EQ(out.energy.stored(), 0.5 * 4 * 0.25 + 0.5 * 10);
  EXPECT_DOUBLE_EQ(out.virial[0][0],
                   -4 * 0.5 * 3 + 10 * 1);  // tension of the spring, compression of the contact
}

TEST(TermSet, MismatchedStencilsAreInputErrors) {
  System<2> system = ring(4);
  TermSet<2> terms;
  EXPECT_THROW(terms.add(FacetStretch<2>{}, system.topology.facet, {{1, 0}, {2, 0}}), Error);
  EXPECT_THROW(terms.add(FacetStretch<2>{}, {{0, -1}}, {{1, 0}}), Error);
  terms.add(FacetStretch<2>{}, {{0, 9}}, {{1, 0}});
  EXPECT_THROW(evaluate(terms, system), Error);
}

}  // namespace
}  // namespace supple
