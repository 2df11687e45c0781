/// What bodies with friction and viscosity do: closed forms, and the discs of the microgel model.
#include "supple/contact/disc_contacts.hpp"
#include "tests/support/polygons.hpp"
#include "tests/support/touching.hpp"

namespace supple {
namespace {

using namespace testing;

/// A disc drawn over an edge at the depth 0.2: k_t u up to mu F, then mu F, and the work beyond the spring's
/// is lost.
TEST(TouchLaw, SteadyPullMeetsTheCoulombForceAndLosesItTimesTheWay) {
  for (const Slip slip : {Slip::clamp, Slip::freeze}) {
    Touching t = touching<SmoothContacts>("", square, {0.5, -1}, Toucher::disc);
    const double mu = 0.3, k_t = 50, f_n = 100 * 0.2, dt = 1e-4, speed = 1;
    ForceField<2> field = t.field({.friction = mu, .k_t = k_t, .slip = slip});
    Evaluation<2> out;
    State<2>& s = t.system.state;
    s.velocity.back() = {speed, 0};
    double lost = 0, work = 0;
    const int steps = 10000;
    for (int k = 1; k <= steps; ++k) {
      s.position.back() += Vec2{speed * dt, 0};
      t.system.lag = dt;
      field.evaluate(t.system, Detail::energies, out);
      field.commit(t.system, out);
      lost += out.energy.sliding_power * dt;
      work -= out.force.back()[0] * speed * dt;
      const double u = speed * dt * k;
      EXPECT_NEAR(out.force.back()[0], -std::min(k_t * u, mu * f_n), 1e-9);
    }
    const double way = speed * dt * steps, elastic = mu * f_n / k_t;
    EXPECT_NEAR(lost, mu * f_n * (way - elastic), 2e-3);
    EXPECT_NEAR(work, lost + 0.5 * k_t * elastic * elastic, 2e-3);
    // The disc leaves with its spring wound up, which is lost.
    s.position.back() -= Vec2{0, 5};
    s.velocity.back() = {};
    t.system.lag = dt;
    field.evaluate(t.system, Detail::energies, out);
    EXPECT_NEAR(out.energy.sliding_power * dt, 0.5 * k_t * elastic * elastic, 1e-3);
    field.commit(t.system, out);
    EXPECT_TRUE(t.system.touches.rows.empty());
  }
}

/// Two disc bodies meet head-on, m = 1: x'' + 2 g x' + w0^2 x = 0 with w0^2 = 2 k, g = eta. Where they must
/// not pull, they part when the force is zero [Schwager & Poschel 2007, eq. 21].
TEST(TouchLaw, BounceHasTheRestitutionOfALinearDashpot) {
  for (const ViscousPull pull : {ViscousPull::never, ViscousPull::allowed}) {
    System<2> system;
    system.box.length = {20, 20};
    add_disc_body(system, {9, 10}, 0.5);
    add_disc_body(system, {10.0001, 10}, 0.5);
    system.state.velocity = {{0.05, 0}, {-0.05, 0}};
    const double k = 100, g = 3, w0 = std::sqrt(2 * k), w = std::sqrt(w0 * w0 - g * g), dt = 2e-5;
    const auto contacts = std::make_shared<RoughContacts<2>>(Harmonic{k});
    ForceField<2> field(*contacts);
    field.add(TouchFriction(TouchLaw{.eta = g, .pull = pull}));
    Evaluation<2> out;
    State<2>& s = system.state;
    for (int step = 0; step < 20000; ++step) {
      field.evaluate(system, Detail::forces, out);
      field.commit(system, out);
      for (int i = 0; i < 2; ++i) {
        s.velocity[i] += dt * out.force[i];
        s.position[i] += dt * s.velocity[i];
      }
      system.lag = dt;
    }
    const double angle = pull == ViscousPull::allowed ? 0 : std::atan(2 * g * w / (w * w - g * g));
    EXPECT_NEAR((s.velocity[1][0] - s.velocity[0][0]) / 0.1, std::exp(-g / w * (std::numbers::pi - angle)),
                2e-3);
  }
}

/// Two particles that deform rub against each other, slip, stick and part.
TEST(TouchLaw, EnergyOfParticlesThatRubGoesWhereTheBooksSay) {
  for (const bool smooth : {false, true}) {
    Touching t = smooth ? touching<SmoothContacts>("", regular(12, 2), {2.9, 0.6}, Toucher::vertex)
                        : touching<RoughContacts<2>>("", regular(12, 2), {2.9, 0.6}, Toucher::vertex);
    System<2>& system = t.system;
    for (int i = 0; i < system.state.size(); ++i)
      system.state.velocity[i] = i < 12 ? Vec2{0.5, 0.6} : Vec2{-0.5, -0.6};
    ForceField<2> field = polygon_field(*t.contacts);
    for (ShapeStiffness& k : system.shape.stiffness) k = {1, 50, 0, 0};
    for (std::size_t k = 0; k < system.topology.facet.size(); ++k) {
      const auto [a, b] = system.topology.facet[k];
      system.shape.rest_facet[k] = norm(system.state.position[b] - system.state.position[a]);
    }
    system.shape.rest_volume = {12, 2.5};
    field.add(TouchFriction(TouchLaw{0.3, 50, 0.3, 0.2}));
    const EnergyCheck coarse = check_energy(system, field, 1e-3, 3),
                      fine = check_energy(system, field, 2.5e-4, 3);
    EXPECT_GT(fine.lost, 0.1);
    EXPECT_LT(coarse.error, 0.02 * coarse.lost);
    EXPECT_LT(fine.error, 0.4 * coarse.error);
  }
}

/// A body of one site has the law of a disc of the microgel model.
TEST(TouchLaw, BodiesOfOneSiteHaveTheLawOfDiscs) {
  System<2> discs;
  discs.box.length = {6, 6};
  discs.box.strain = 0.3;
  discs.box.strain_rate = 0.8;
  System<2> bodies = discs;
  RandomStream draw(5, Purpose::test, 0);
  discs.state.resize(40);
  for (int i = 0; i < 40; ++i) {
    const Vec2 x{draw.uniform(0, 6), draw.uniform(0, 6)};
    add_disc_body(bodies, x, draw.uniform(0.3, 0.7));
    discs.state.position[i] = x;
    discs.state.radius[i] = bodies.state.radius[i];
  }
  stir(discs, 6);
  stir(bodies, 6);
  for (const double mu : {0.05, 1e9}) {
    const DiscLaw law{{100, 3, 40, 2}, {}, Tensile{}, mu};
    ForceField<2> reference(DiscContacts(Repulsion(Divergent(0)), law));
    for (const bool smooth : {false, true}) {
      std::shared_ptr<BodyContacts<2>> contacts;
      if (smooth) contacts = std::make_shared<SmoothContacts>(Harmonic{100});
      else contacts = std::make_shared<RoughContacts<2>>(Harmonic{100});
      ForceField<2> field(*contacts);
      field.add(TouchFriction(TouchLaw{mu, 40, 3, 2, Slip::clamp, ViscousPull::allowed}));
      System<2> a = discs, b = bodies;
      Evaluation<2> expected, out;
      for (System<2>* s : {&a, &b}) s->lag = 1e-9;  // moves nothing, but winds springs up
      reference.evaluate(a, Detail::energies, expected);
      reference.commit(a, expected);
      field.evaluate(b, Detail::energies, out);
      field.commit(b, out);
      for (std::size_t row = 0; row < a.pairs.history.size(); ++row) a.pairs.history[row] *= 1e8;
      for (Touch& touch : b.touches.rows) touch.elongation *= 1e8;
      reference.evaluate(a, Detail::energies, expected);
      field.evaluate(b, Detail::energies, out);
      for (int i = 0; i < 40; ++i) {
        EXPECT_LT(norm(out.force[i] - expected.force[i]), 1e-6);
        EXPECT_NEAR(out.torque[i], expected.torque[i], 1e-6);
      }
      EXPECT_NEAR(out.energy.tangential, expected.energy.tangential, 1e-6);
      EXPECT_NEAR(out.energy.viscous_power, expected.energy.viscous_power, 1e-9);
      EXPECT_NEAR(out.energy.tangential_viscous_power, expected.energy.tangential_viscous_power, 1e-9);
      for (int c = 0; c < 2; ++c)
        for (int d = 0; d < 2; ++d) EXPECT_NEAR(out.virial[c][d], expected.virial[c][d], 1e-6);
      EXPECT_GT(out.energy.tangential, 1e-3);
    }
  }
}

/// A rigid regular polygon that turns and slides under a disc: force and torque tend to those of a disc of
/// its radius, with the number of its vertices and the depth of the contact.
TEST(TouchLaw, ManySidedPolygonHasTheLawOfADisc) {
  const double inner = 1.9, rounding = 0.1, radius = inner + rounding, spin = 0.7, spin_of_disc = -1.3,
               eta = 2;
  const Vec2 velocity{0.3, -0.2};
  double error_before = 0;
  for (const double depth : {1e-1, 1e-2, 1e-3}) {
    const int n = static_cast<int>(10 / depth);
    System<2> system;
    system.box.length = {100, 100};
    std::vector<Vec2> ring;
    for (int k = 0; k < n; ++k) {
      const double angle = 2 * std::numbers::pi * (k + 0.37) / n;
      ring.push_back(Vec2{50, 50} +
                     inner / std::cos(std::numbers::pi / n) * Vec2{std::cos(angle), std::sin(angle)});
    }
    add_body(system, ring, rounding);
    const Vec2 centre{50 + radius + 0.5 - depth, 50};
    add_disc_body(system, centre, 0.5);
    for (int i = 0; i < n; ++i) system.state.velocity[i] = velocity + cross(spin, ring[i] - Vec2{50, 50});
    system.state.spin[n] = spin_of_disc;
    const auto contacts = std::make_shared<SmoothContacts>(Harmonic{100});
    ForceField<2> field(*contacts);
    field.add(TouchFriction(TouchLaw{.friction = 1e9, .eta_t = eta}));
    Evaluation<2> out;
    field.evaluate(system, Detail::forces, out);
    double torque = 0;
    for (int i = 0; i < n; ++i) torque += cross(ring[i] - Vec2{50, 50}, out.force[i]);
    // S1-3 of two discs, n from the polygon to the disc along x.
    const double v_t =
        -velocity[1] - (radius + 0.5 - depth) / (radius + 0.5) * (radius * spin + 0.5 * spin_of_disc);
    const double f_t = eta * v_t;
    const double error = std::abs(out.force[n][1] / -f_t - 1) + std::abs(torque / (f_t * radius) - 1) +
                         std::abs(out.torque[n] / (f_t * 0.5) - 1);
    EXPECT_LT(error, 6 * depth);  // who bears the overlap: the rounding, or the whole radius
    if (error_before > 0) {
      EXPECT_LT(error, 0.3 * error_before);
    }
    error_before = error;
  }
}

TEST(TouchLaw, DashpotDoesNotPullUnlessToldTo) {
  const TouchLaw law{.eta = 5}, pulls{.eta = 5, .pull = ViscousPull::allowed};
  EXPECT_EQ(respond_touch(law, 1, 2, {1, 0}, 0, 0).viscous, -2);
  EXPECT_EQ(respond_touch(pulls, 1, 2, {1, 0}, 0, 0).viscous, -5);
  EXPECT_EQ(respond_touch(law, 0.5, 2, {-1, 0}, 0, 0).viscous, 2.5);
  EXPECT_DOUBLE_EQ(viscosity(0.1, 4, 25), 1);
  EXPECT_DOUBLE_EQ(tangential_stiffness(0.5, 4), 2);
}

}  // namespace
}  // namespace supple
