/// Bodies of many sites in a sheared cell: nothing tears them.
#include "supple/model/body_flow.hpp"

#include <gtest/gtest.h>

#include "supple/contact/rough_contacts.hpp"
#include "supple/contact/smooth_contacts.hpp"
#include "supple/model/rigid.hpp"
#include "tests/support/polygons.hpp"

namespace supple {
namespace {

using testing::polygon_field;
using testing::random_polygons;

System<2> sheared_polygons() {
  System<2> s = random_polygons();
  s.box.strain_rate = 0.3;
  RandomStream stream(3, Purpose::test);
  for (int i = 0; i < s.state.size(); ++i) {
    s.state.velocity[i] = {stream.uniform(-1, 1), stream.uniform(-1, 1)};
    s.state.mass[i] = stream.uniform(0.5, 2);
  }
  return s;
}

TEST(BodyFlow, MotionOfARigidlyTurningRingIsThatRotation) {
  System<2> s = random_polygons();
  const Vec2 velocity{0.2, -0.7};
  const double spin = 1.3;
  const Vec2 centre = body_motion(s, 2).centre;
  for (int i = s.topology.body_begin(2); i < s.topology.body_end(2); ++i)
    s.state.velocity[i] = velocity + spin * turned_left(s.state.position[i] - centre);
  const BodyMotion m = body_motion(s, 2);
  EXPECT_NEAR(norm(m.velocity - velocity), 0, 1e-14);
  EXPECT_NEAR(m.spin, spin, 1e-14);
  EXPECT_EQ(m.mass, s.topology.body_size(2));
}

TEST(BodyFlow, ChangeOfTheRateMovesCentresWithTheFlowAndTurnsWithItsVorticity) {
  System<2> s = sheared_polygons();
  const System<2> before = s;
  set_strain_rate(s, 0.3 + 0.5);
  for (int b = 0; b < s.topology.body_count(s.state.size()); ++b) {
    const BodyMotion was = body_motion(before, b), is = body_motion(s, b);
    const double rise = was.centre[gradient] - 0.5 * s.box.length[gradient];
    EXPECT_NEAR(is.velocity[flow] - was.velocity[flow], 0.5 * rise, 1e-13);
    EXPECT_NEAR(is.velocity[gradient], was.velocity[gradient], 1e-13);
    EXPECT_NEAR(is.spin - was.spin, -0.25, 1e-13);
    for (int i = s.topology.body_begin(b); i + 1 < s.topology.body_end(b);
         ++i) {  // its edges keep their rates
      const Vec2 edge = s.state.position[i + 1] - s.state.position[i];
      const auto rate = [&](const System<2>& of) {
        return dot(edge, of.state.velocity[i + 1] - of.state.velocity[i]);
      };
      EXPECT_NEAR(rate(s), rate(before), 1e-13);
    }
  }
}

TEST(BodyFlow, DragTakesTheMotionOfBodiesAndLeavesThatOfTheirShapes) {
  System<2> s = sheared_polygons();
  const System<2> before = s;
  damp(s, 0.25, Drag::bodies);
  for (int b = 0; b < s.topology.body_count(s.state.size()); ++b) {
    const BodyMotion was = body_motion(before, b), is = body_motion(s, b);
    const Vec2 u = s.box.flow_velocity(was.centre);
    EXPECT_NEAR(norm(is.velocity - u - 0.25 * (was.velocity - u)), 0, 1e-13);
    EXPECT_NEAR(is.spin + 0.15, 0.25 * (was.spin + 0.15), 1e-13);
    for (int i = s.topology.body_begin(b); i < s.topology.body_end(b); ++i) {
      const auto own = [&](const System<2>& of, const BodyMotion<2>& m) {
        return of.state.velocity[i] - m.velocity - m.spin * turned_left(of.state.position[i] - m.centre);
      };
      EXPECT_NEAR(norm(own(s, is) - own(before, was)), 0, 1e-13);
    }
  }
}

TEST(BodyFlow, DragOfSitesActsOnEachRelativeToTheFlowThereAndOnRigidBodiesAsWholes) {
  System<2> s = sheared_polygons();
  make_rigid(s, 3);
  s.state.mobility[2] = Mobility::fixed;
  const System<2> before = s;
  damp(s, 0.25, Drag::sites);
  for (int i = 0; i < s.state.size(); ++i) {
    if (s.topology.begin[3] <= i && i < s.topology.begin[4]) continue;
    const Vec2 u = s.box.flow_velocity(s.state.position[i]), was = before.state.velocity[i];
    const Vec2 expected = i == 2 ? was : u + 0.25 * (was - u);
    EXPECT_LT(norm(s.state.velocity[i] - expected), 1e-14);
  }
  const Vec2 u = s.box.flow_velocity(s.rigid.centre[0]);
  EXPECT_LT(norm(s.rigid.velocity[0] - u - 0.25 * (before.rigid.velocity[0] - u)), 1e-14);
  EXPECT_NEAR(s.rigid.spin[0] + 0.15, 0.25 * (before.rigid.spin[0] + 0.15), 1e-15);
}

class Crossing : public ::testing::TestWithParam<bool> {
 protected:
  ForceField<2> field() const {
    const Harmonic law{1, true};
    if (GetParam()) return polygon_field(SmoothContacts(law));
    return polygon_field(RoughContacts<2>(law));
  }
};

TEST_P(Crossing, ABodyGoesToTheOtherSideInOnePieceAndFeelsTheSameForces) {
  System<2> s = sheared_polygons();
  s.box.strain = 1.37;
  for (Vec2& x : s.state.position) x += Vec2{0.4 * s.box.length[0], -0.55 * s.box.length[1]};
  const System<2> before = s;
  Evaluation<2> there, here;
  field().evaluate(s, Detail::energies, there);
  ASSERT_TRUE(wrap_bodies(s));
  EXPECT_FALSE(wrap_bodies(s));
  field().evaluate(s, Detail::energies, here);
  ASSERT_GT(there.energy.elastic, 0);
  EXPECT_NEAR(here.energy.stored(), there.energy.stored(), 1e-12);
  for (int d = 0; d < 2; ++d)
    for (int e = 0; e < 2; ++e) EXPECT_NEAR(here.virial[d][e], there.virial[d][e], 1e-11);
  for (int i = 0; i < s.state.size(); ++i) EXPECT_NEAR(norm(here.force[i] - there.force[i]), 0, 1e-12);
  for (int b = 0; b < s.topology.body_count(s.state.size()); ++b) {
    const Vec2 centre = body_motion(s, b).centre;
    for (int d = 0; d < 2; ++d) EXPECT_TRUE(0 <= centre[d] && centre[d] < s.box.length[d]);
    const int first = s.topology.body_begin(b);
    const Vec2 moved = s.state.position[first] - before.state.position[first],
               gained = s.state.velocity[first] - before.state.velocity[first];
    EXPECT_NEAR(gained[flow], s.box.strain_rate * moved[gradient], 1e-12);
    EXPECT_EQ(gained[gradient], 0);
    for (int i = first; i < s.topology.body_end(b); ++i) {
      EXPECT_NEAR(norm(s.state.position[i] - before.state.position[i] - moved), 0, 1e-13);
      EXPECT_NEAR(norm(s.state.velocity[i] - before.state.velocity[i] - gained), 0, 1e-13);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(RoughAndSmooth, Crossing, ::testing::Bool());

TEST(BodyFlow, LinksAndContactsFollowTheirBodiesToTheSameImages) {
  System<2> s = sheared_polygons();
  const auto site = [&](int b) { return s.topology.body_begin(b) + 1; };
  for (Vec2& x : s.state.position) x += Vec2{1.3 * s.box.length[0], 0.62 * s.box.length[1]};
  s.links = {{site(0), site(3), {2, -1, 0}, 1, 0}, {site(4), site(5), {0, 0, 0}, 1, 0}};
  s.touches.rows = {{{site(1), site(2), TouchOn::site, {0, 1, 0}}, ContactState::stick, 0.1},
                    {{site(2), 7, TouchOn::body, {-1, 0, 0}}, ContactState::slip, 0.2},
                    {{site(5), 0, TouchOn::body, {0, 0, 0}}, ContactState::slip, 0.3}};
  const auto vectors = [&] {
    std::vector<Vec2> r;
    const auto add = [&](int from, int to, const std::array<std::int32_t, 3>& n) {
      Vec2 v = s.state.position[to] - s.state.position[from];
      s.box.lattice().subtract({1.0 * n[0], 1.0 * n[1]}, v);
      r.push_back(v);
    };
    for (const Link& link : s.links) add(link.first, link.second, link.cells);
    std::vector<Touch> rows = s.touches.rows;
    std::sort(rows.begin(), rows.end(),
              [](const Touch& a, const Touch& b) { return a.elongation < b.elongation; });
    for (const Touch& t : rows)
      add(t.key.on == TouchOn::site ? t.key.other : s.topology.body_begin(t.key.other), t.key.site,
          t.key.cells);
    return r;
  };
  const std::vector<Vec2> before = vectors();
  ASSERT_TRUE(wrap_bodies(s));
  const std::vector<Vec2> after = vectors();
  for (std::size_t k = 0; k < before.size(); ++k) EXPECT_NEAR(norm(after[k] - before[k]), 0, 1e-12) << k;
  EXPECT_TRUE(std::is_sorted(s.touches.rows.begin(), s.touches.rows.end(),
                             [](const Touch& a, const Touch& b) { return a.key < b.key; }));
}

}  // namespace
}  // namespace supple
