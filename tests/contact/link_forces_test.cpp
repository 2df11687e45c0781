#include "supple/contact/link_forces.hpp"

#include "tests/support/field_check.hpp"
#include "tests/support/polygons.hpp"
#include "tests/support/touching.hpp"

namespace supple {
namespace {

using namespace testing;

/// A link of the last site to that of the other body which is nearest to it, at its present distance.
void link_nearest(System<2>& system) {
  const int first_body = system.topology.begin[1], own = first_body;
  int nearest = 0;
  for (int i = 0; i < first_body; ++i)
    if (norm(system.state.position[i] - system.state.position[own]) <
        norm(system.state.position[nearest] - system.state.position[own]))
      nearest = i;
  system.links = {{nearest, own, {}, norm(system.state.position[nearest] - system.state.position[own]), 0}};
}

Evaluation<2> links_alone(const System<2>& system, const LinkLaw& law) {
  Evaluation<2> out;
  out.force.resize(static_cast<std::size_t>(system.state.size()));
  out.torque.resize(out.force.size());
  RoughContacts<2> contacts(Harmonic{1});
  LinkForces(law).evaluate(system, contacts, system.lag, Detail::energies, out);
  return out;
}

TEST(LinkForces, PowerIsWhatDashpotsLoseAndForceAndTorqueAddToZero) {
  for (Touching& t : all_touchings()) {
    SCOPED_TRACE(t.name);
    link_nearest(t.system);
    stir(t.system, 2);
    const auto e = links_alone(t.system, {100, 3, 40, 2});
    EXPECT_NEAR(power(e, t.system.state), -e.energy.viscous_power - e.energy.tangential_viscous_power, 1e-12);
    EXPECT_GT(e.energy.tangential_viscous_power, 1e-3);
    Vec2 force{};
    double torque = 0;
    Mat2 virial;
    for (int i = 0; i < t.system.state.size(); ++i) {
      const Vec2 x = t.system.state.position[i] - Vec2{50, 50};
      force += e.force[i];
      torque += cross(x, e.force[i]) + e.torque[i];
      virial.add_outer(1, e.force[i], x);
    }
    EXPECT_LT(norm(force), 1e-13);
    EXPECT_NEAR(torque, 0, 1e-12);
    for (int c = 0; c < 2; ++c)
      for (int d = 0; d < 2; ++d) EXPECT_NEAR(virial[c][d], e.virial[c][d], 1e-11);

    System<2> wound = t.system;
    wound.links[0].elongation = -0.2;
    const auto w = links_alone(wound, {100, 3, 40, 2});
    EXPECT_NEAR(std::abs(power(w, wound.state) - power(e, wound.state)),
                40 * 0.2 * std::sqrt(e.energy.tangential_viscous_power / 2), 1e-12);
  }
}

TEST(LinkForces, RigidTurnWindsUpNothing) {
  for (Touching& t : all_touchings()) {
    SCOPED_TRACE(t.name);
    link_nearest(t.system);
    ForceField<2> field(*t.contacts);
    field.add(LinkForces(LinkLaw{100, 3, 40, 2}));
    Evaluation<2> out;
    const int steps = 500;
    for (int k = 0; k < steps; ++k) {
      turn(t.system, {49, 52}, 2 * std::numbers::pi / steps, 0.01);
      field.evaluate(t.system, Detail::energies, out);
      field.commit(t.system, out);
      EXPECT_LT(std::abs(t.system.links[0].elongation), 1e-12 * t.distance);
    }
  }
}

/// A link feels its own image of the other body alone, stretched beyond half the cell, and goes on where
/// another image of either body stands in the cell.
TEST(LinkForces, KeepTheirImageAndItsVelocity) {
  System<2> system;
  system.box.length = {10, 8};
  system.box.strain = 0.2;
  system.box.strain_rate = 0.5;
  add_polygon(system, {2, 2}, 1, 6, 0.1, 0.5, {});
  add_polygon(system, {6, 7}, 1, 6, 0.7, 0.5, {});
  stir(system, 3);
  system.lag = 0.01;
  system.links = {{1, 8, {0, 1, 0}, 1, 0.1}};
  System<2> moved = system;
  for (int i = 6; i < 12; ++i) {
    moved.state.position[i] += Vec2{2 * 10 + 0.2 * 8, 8};
    moved.state.velocity[i] += moved.box.velocity_jump(1);
  }
  moved.links[0].cells = {2, 2, 0};
  const auto a = links_alone(system, {100, 3, 40, 2}), b = links_alone(moved, {100, 3, 40, 2});
  const Vec2 r = system.state.position[8] - system.state.position[1] - Vec2{0.2 * 8, 8};
  EXPECT_NEAR(a.energy.elastic, 50 * (norm(r) - 1) * (norm(r) - 1), 1e-9);
  for (int i = 0; i < 12; ++i) EXPECT_LT(norm(a.force[i] - b.force[i]), 1e-11);
  EXPECT_NEAR(a.trial_link[0], b.trial_link[0], 1e-13);
  EXPECT_NE(a.trial_link[0], 0.1);
}

/// Two linked discs, m = 1: w0^2 = 2 k and the damping rate g = eta.
TEST(LinkForces, PeriodAndDampingOfALinkedPair) {
  System<2> system;
  system.box.length = {20, 20};
  add_disc_body(system, {9, 10}, 0.5);
  add_disc_body(system, {9.9, 10}, 0.5);
  system.links = {{0, 1, {}, 0.8, 0}};
  const double k = 100, g = 1, w = std::sqrt(2 * k - g * g), dt = 2e-5;
  ForceField<2> field(RoughContacts<2>(Harmonic{1e4}));  // which must not act
  field.add(LinkForces(LinkLaw{.k = k, .eta = g}));
  Evaluation<2> out;
  State<2>& s = system.state;
  std::vector<double> maxima, times;
  double before = 0, last = 0.1;
  for (int step = 0; step < 100000; ++step) {
    field.evaluate(system, Detail::forces, out);
    field.commit(system, out);
    for (int i = 0; i < 2; ++i) {
      s.velocity[i] += dt * out.force[i];
      s.position[i] += dt * s.velocity[i];
    }
    system.lag = dt;
    const double x = s.position[1][0] - s.position[0][0] - 0.8;
    if (step > 10 && last > before && last > x) maxima.push_back(last), times.push_back(step * dt);
    before = last, last = x;
  }
  ASSERT_GE(maxima.size(), 4u);
  const double period = (times[3] - times[0]) / 3;
  EXPECT_NEAR(period, 2 * std::numbers::pi / w, 1e-4);
  EXPECT_NEAR(std::log(maxima[0] / maxima[3]) / (3 * period), g, 2e-3);
}

TEST(LinkForces, EnergyOfALinkedPairGoesIntoDashpotsAlone) {
  Touching t = touching<RoughContacts<2>>("", regular(6, 1), {1.9, 0.2}, Toucher::disc);
  link_nearest(t.system);
  stir(t.system, 5);
  t.system.shape.stiffness[0] = {1, 50, 1, 0};
  ForceField<2> field = polygon_field(*t.contacts);
  field.add(LinkForces(LinkLaw{80, 0.5, 40, 0.3}));
  const EnergyCheck coarse = check_energy(t.system, field, 1e-3, 1),
                    fine = check_energy(t.system, field, 2.5e-4, 1);
  EXPECT_GT(fine.lost, 0.05);
  EXPECT_LT(coarse.error, 3e-3);
  EXPECT_LT(fine.error, 0.4 * coarse.error);
}

/// A linked pair has no other contact: rough, that of its sites; smooth, of either site with the other's
/// body. What is not linked touches as before, and forces stay the slope of the energy.
TEST(LinkForces, LinkedPairsHaveNoOtherContact) {
  for (const bool smooth : {false, true}) {
    std::shared_ptr<BodyContacts<2>> contacts;
    if (smooth) contacts = std::make_shared<SmoothContacts>(Harmonic{2});
    else contacts = std::make_shared<RoughContacts<2>>(Harmonic{2});
    System<2> system = random_polygons({.bodies = 9, .seed = 3, .spacing = 2.0});
    add_disc_body(system, {1.3, 1.4}, 0.5);
    add_disc_body(system, {1.9, 1.5}, 0.4);
    ForceField<2> field = polygon_field(*contacts);
    Evaluation<2> out;
    field.evaluate(system, Detail::energies, out);
    const auto body = bodies_of_sites(system.topology, system.state.size());
    const auto before = contacts->records(system);
    int discs = 0;
    for (std::size_t k = 0; k < before.size(); k += 5) {
      const auto& r = before[k];
      const int own = r.weight[0] > 0 ? 0 : 1;
      Link link{r.site[1 - own], r.site[own], {r.cells[0], r.cells[1], 0}, 1, 0};
      system.links.push_back(link);
      discs += body[link.first] >= 9 && body[link.second] >= 9;
    }
    for (const auto& r : before)
      if (body[r.site[0]] >= 9 && body[r.site[1]] >= 9)
        system.links.push_back({r.site[0], r.site[1], {r.cells[0], r.cells[1], 0}, 1, 0}), ++discs;
    EXPECT_GT(discs, 0);
    const auto linked = [&](const ContactRecord<2>& r) {
      const int own = r.weight[0] > 0 ? 0 : 1;
      const std::int32_t i = r.site[own], j = r.site[1 - own];
      for (const Link& l : system.links)
        for (const bool swap : {false, true}) {
          const std::int32_t a = swap ? l.first : l.second, b = swap ? l.second : l.first,
                             sign = swap ? -1 : 1;
          if (a == i && (smooth ? body[b] == body[j] : b == j) && r.cells[0] == sign * l.cells[0] &&
              r.cells[1] == sign * l.cells[1])
            return true;
        }
      return false;
    };
    std::size_t left = 0, next = 0;
    for (const auto& r : before) left += !linked(r);
    const auto after = contacts->records(system);
    ASSERT_EQ(after.size(), left);
    ASSERT_LT(left, before.size());
    for (const auto& r : before)
      if (!linked(r)) {
        EXPECT_EQ(after[next].site, r.site);
        EXPECT_EQ(after[next++].gap, r.gap);
      }
    FieldCheck(field, system).run();  // its Hessian comes from records, its forces from the loop

    // The other image of a linked pair touches as it did.
    for (Link& l : system.links) l.cells[0] += 1;
    EXPECT_EQ(contacts->records(system).size(), before.size());
  }
}

}  // namespace
}  // namespace supple
