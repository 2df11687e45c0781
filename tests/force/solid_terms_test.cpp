/// Bodies with an inside in a force field, among others.
#include "supple/force/solid_terms.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "supple/contact/rough_contacts.hpp"
#include "supple/contact/smooth_contacts.hpp"
#include "supple/contact/smooth_surfaces.hpp"
#include "supple/core/parallel.hpp"
#include "supple/force/force_field.hpp"
#include "supple/force/polygon_shape.hpp"
#include "supple/force/surface_shape.hpp"
#include "supple/observe/soundness.hpp"
#include "tests/support/field_check.hpp"
#include "tests/support/solids.hpp"

namespace supple {
namespace {

using namespace testing;

template <int Dim, class Contacts>
ForceField<Dim> field_with(const Contacts& contacts) {
  using WholeShape = std::conditional_t<Dim == 2, PolygonShape, SurfaceShape>;
  ForceField<Dim> field(contacts);
  field.terms().add(std::make_shared<WholeShape>());
  field.terms().add(std::make_shared<SolidTerms<Dim>>());
  return field;
}

TEST(SolidTerms, HaveTheSlopesThatTheirEnergySaysAmongOtherBodies) {
  const Harmonic law{1, true};
  System<2> flat = solids_among_others();
  ForceField<2> rough = field_with<2>(RoughContacts<2>(law)), smooth = field_with<2>(SmoothContacts(law));
  FieldCheck(rough, flat).run();
  FieldCheck(smooth, flat).run();
  System<3> solid = solids_among_others_in_3d();
  ForceField<3> rough_3d = field_with<3>(RoughContacts<3>(law)),
                smooth_3d = field_with<3>(SmoothSurfaces(law));
  FieldCheck(rough_3d, solid).run();
  FieldCheck(smooth_3d, solid).run();
}

TEST(SolidTerms, AreAtRestAsTheyWereMade) {
  System<2> flat = solids_among_others(0);
  System<3> solid = solids_among_others_in_3d(0);
  Evaluation<2> out;
  out.force.resize(flat.state.size());
  SolidTerms<2>().evaluate(flat, Detail::energies, out);
  EXPECT_NEAR(out.energy.terms, 0, 1e-28);
  Evaluation<3> out_3d;
  out_3d.force.resize(solid.state.size());
  SolidTerms<3>().evaluate(solid, Detail::energies, out_3d);
  EXPECT_NEAR(out_3d.energy.terms, 0, 1e-28);
  for (const Vec3& f : out_3d.force) EXPECT_LT(norm(f), 1e-14);
}

/// Sites inside touch nothing, and the boundary comes first.
template <int Dim>
void expect_no_rows_inside(System<Dim> system) {
  ForceField<Dim> field = field_with<Dim>(RoughContacts<Dim>(Harmonic{1, true}));
  for (double& r : system.state.radius) r *= 1.5;  // so that some inside would reach others
  Evaluation<Dim> out;
  field.evaluate(system, Detail::forces, out);
  const std::vector<std::int32_t> body = bodies_of_sites(system.topology, system.state.size());
  const auto is_inside = [&](std::int32_t i) {
    return i >= system.topology.body_begin(body[i]) + system.topology.boundary_size(body[i]);
  };
  int inside = 0;
  for (int i = 0; i < system.state.size(); ++i) inside += is_inside(i);
  EXPECT_GT(inside, 5);
  EXPECT_GT(system.pairs.size(), 10);
  for (int row = 0; row < system.pairs.size(); ++row)
    EXPECT_FALSE(is_inside(system.pairs.first[row]) || is_inside(system.pairs.second[row])) << row;
}

TEST(SolidTerms, SitesInsideTouchNothing) {
  expect_no_rows_inside(solids_among_others());
  expect_no_rows_inside(solids_among_others_in_3d());
}

TEST(SolidTerms, HaveTheSameBitsForAnyNumberOfThreads) {
  System<2> system;
  system.box.length = {40, 40};
  const SolidSpec network{Filling::network, 0.7, {}};
  for (int b = 0; b < 16; ++b)
    add_solid(system,
              placed<2>(solid_mesh<2>(network, 30, static_cast<std::uint64_t>(b)), 1,
                        {10. * (b % 4), 10. * (b / 4)}),
              1, network);
  shake(system, 0.05);
  const auto evaluated = [&](int threads) {
    const WithThreads with(threads);
    Evaluation<2> out;
    out.force.resize(system.state.size());
    SolidTerms<2>().evaluate(system, Detail::energies, out);
    return out;
  };
  const Evaluation<2> one = evaluated(1), four = evaluated(4);
  EXPECT_EQ(one.force, four.force);
  EXPECT_EQ(one.energy.terms, four.energy.terms);
  EXPECT_EQ(one.virial[0][1], four.virial[0][1]);
}

/// The strain energy of a mirror image is that of the element: only soundness sees it.
TEST(SolidTerms, AnInvertedElementIsNoticed) {
  System<2> system;
  system.box.length = {10, 10};
  const SolidSpec elements{Filling::elements, 0, {1, 0.3}};
  add_solid(system, placed<2>(solid_mesh<2>(elements, 8, 1), 1, {5, 5}), 1, elements);
  EXPECT_TRUE(look_at(system, Outline::rough).sound());
  const Vec2 a = system.state.position[0], b = system.state.position[1];
  Vec2& centre = system.state.position.back();
  const double before = SolidTerms<2>().energy(system);
  centre = a + b - 1.0 * centre;  // beyond the edge that it is farthest from least
  EXPECT_GT(SolidTerms<2>().energy(system), before);
  for (const Soundness& s : {look_at(system, Outline::rough), look_at_each(system, Outline::rough)}) {
    EXPECT_EQ(s.inverted, 1);
    EXPECT_EQ(s.bodies(), 1);
    EXPECT_EQ(s.what(), "1 particle has folded over inside");
  }
  System<3> solid = solids_among_others_in_3d(0);
  EXPECT_EQ(look_at(solid, Outline::rough).inverted, 0);
  solid.state.position.back() += Vec3{0, 0, 0.9};
  EXPECT_EQ(look_at(solid, Outline::rough).inverted, 1);
}

}  // namespace
}  // namespace supple
