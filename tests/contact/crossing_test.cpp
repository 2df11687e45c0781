/// A pair that crosses the sheared boundary, one side after the other, goes on with what its contact
/// remembers.
#include <algorithm>

#include "supple/contact/disc_contacts.hpp"
#include "supple/contact/link_forces.hpp"
#include "supple/model/body_flow.hpp"
#include "tests/support/polygons.hpp"
#include "tests/support/touching.hpp"

namespace supple {
namespace {

using namespace testing;

/// A pair below the upper edge of a sheared cell, and what acts between its sides.
struct Pair {
  std::string name;
  System<2> system;
  std::function<ForceField<2>()> field;
};

const TouchLaw law{.friction = 1e9, .k_t = 40, .eta = 3, .eta_t = 2, .pull = ViscousPull::allowed};

System<2> sheared_cell() {
  System<2> s;
  s.box.length = {24, 20};
  s.box.strain = 0.37;
  s.box.strain_rate = 0.3;
  return s;
}

std::vector<Pair> all_pairs() {
  std::vector<Pair> pairs;
  for (const bool smooth : {false, true}) {
    System<2> s = sheared_cell();
    std::vector<Vec2> ring = regular(12, 1.5);
    for (Vec2& x : ring) x += Vec2{22, 17};
    add_body(s, ring, 0.4);
    add_body(s, {{22.3, 18.9}, {23.2, 20.2}, {21.4, 20.4}}, 0.4);
    const auto contacts = [smooth]() -> std::shared_ptr<BodyContacts<2>> {
      if (smooth) return std::make_shared<SmoothContacts>(Harmonic{100});
      return std::make_shared<RoughContacts<2>>(Harmonic{100});
    };
    pairs.push_back({smooth ? "vertex on boundary" : "vertex on vertex", s, [contacts] {
                       const auto c = contacts();
                       ForceField<2> field(*c);
                       field.add(TouchFriction(law));
                       return field;
                     }});
    s.links = {{3, 12, {}, 1, 0}, {4, 13, {}, 2, 0}};
    pairs.push_back({smooth ? "links, smooth" : "links, rough", s, [contacts] {
                       ForceField<2> field(*contacts());
                       field.add(LinkForces(LinkLaw{30, 1, 20, 1}));
                       return field;
                     }});
  }
  System<2> s = sheared_cell();
  s.state.resize(2);
  s.state.radius = {1, 0.8};
  s.state.position = {{23, 17.5}, {23.6, 19.1}};
  pairs.push_back({"discs", s, [] {
                     return ForceField<2>(DiscContacts(Divergent(0), {{100, 3, 40, 2}, {}, Tensile{}, 1e9}));
                   }});
  return pairs;
}

std::vector<double> memory(const System<2>& s) {
  std::vector<double> u;
  for (const Touch& touch : s.touches.rows) u.push_back(touch.elongation);
  for (const Link& link : s.links) u.push_back(link.elongation);
  for (int row = 0; row < s.pairs.size(); ++row)
    if (s.pairs.state[row] != ContactState::open) u.push_back(s.pairs.history[row]);
  std::sort(u.begin(), u.end());
  return u;
}

/// The same straight motions, once brought back into the cell and once not. What is left is the rounding of
/// positions and velocities of the size of the cell, a few 1e-16 of it a step.
TEST(Crossing, OfTheShearedBoundaryContinuesEveryElongation) {
  for (const Pair& pair : all_pairs()) {
    SCOPED_TRACE(pair.name);
    System<2> in_cell = pair.system, anywhere = pair.system;
    for (System<2>* s : {&in_cell, &anywhere})
      for (int i = 0; i < s->state.size(); ++i) {
        RandomStream draw(9, Purpose::test, static_cast<std::uint64_t>(i));
        const bool second = s->topology.begin.empty() ? i == 1 : i >= s->topology.begin[1];
        s->state.velocity[i] = Vec2{1.5, 2} + Vec2{second ? 0.12 : 0.0, 0} +
                               0.02 * Vec2{draw.uniform(-1, 1), draw.uniform(-1, 1)};
        s->state.spin[i] = 0.1;
      }
    ForceField<2> field = pair.field(), open_field = pair.field();
    Evaluation<2> out;
    const double dt = 0.01;
    double worst = 0, largest = 0;
    int crossings = 0;
    for (int step = 0; step < 300; ++step) {
      for (System<2>* s : {&in_cell, &anywhere}) {
        ForceField<2>& f = s == &in_cell ? field : open_field;
        f.evaluate(*s, Detail::energies, out);
        f.commit(*s, out);
        for (int i = 0; i < s->state.size(); ++i) s->state.position[i] += dt * s->state.velocity[i];
        s->box.strain += dt * s->box.strain_rate;
        s->lag = dt;
      }
      const Vec2 before = in_cell.state.position[0], other = in_cell.state.position.back();
      if (wrap_bodies(in_cell)) field.invalidate();
      crossings += std::abs(in_cell.state.position[0][gradient] - before[gradient]) > 1;
      crossings += std::abs(in_cell.state.position.back()[gradient] - other[gradient]) > 1;
      const std::vector<double> a = memory(in_cell), b = memory(anywhere);
      ASSERT_EQ(a.size(), b.size()) << step;
      for (std::size_t k = 0; k < a.size(); ++k) {
        worst = std::max(worst, std::abs(a[k] - b[k]));
        largest = std::max(largest, std::abs(b[k]));
      }
    }
    EXPECT_EQ(crossings, 2);
    EXPECT_GT(largest, 0.05);
    EXPECT_LT(worst, 1e-12);
  }
}

}  // namespace
}  // namespace supple
