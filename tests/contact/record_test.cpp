#include "supple/contact/record.hpp"

#include <gtest/gtest.h>

#include "supple/contact/detect_discs.hpp"
#include "supple/contact/disc_contacts.hpp"
#include "supple/contact/laws/disc_record.hpp"
#include "tests/support/all_pairs.hpp"
#include "tests/support/suspension.hpp"

namespace supple {
namespace {

/// Overlapping spheres with random motion and spin in a sheared cell; every tenth pair of rows is a link.
template <int Dim>
System<Dim> random_discs_in_motion(int n, double strain, std::uint64_t seed) {
  System<Dim> system;
  system.box.strain = strain;
  system.box.strain_rate = 0.7;
  system.state.resize(n);
  for (int d = 0; d < Dim; ++d) system.box.length[d] = 5 + d;
  for (int i = 0; i < n; ++i) {
    RandomStream draw(seed, Purpose::test, static_cast<std::uint64_t>(i));
    for (int d = 0; d < Dim; ++d) {
      system.state.position[i][d] = draw.uniform(0, system.box.length[d]);
      system.state.velocity[i][d] = draw.uniform(-1, 1);
    }
    system.state.radius[i] = draw.uniform(0.4, 0.9);
    if constexpr (Dim == 2) system.state.spin[i] = draw.uniform(-2, 2);
    else
      for (int d = 0; d < Dim; ++d) system.state.spin[i][d] = draw.uniform(-2, 2);
  }
  testing::fill_all_pairs(system);
  for (std::int32_t row = 0; row < system.pairs.size(); row += 10)
    system.pairs.state[row] = ContactState::permanent;
  for (std::int32_t row = 0; row < system.pairs.size(); ++row)
    system.pairs.history[row] = RandomStream(seed, Purpose::test, stream_index(1, row)).uniform(-0.1, 0.1);
  return system;
}

template <int Dim>
Vec<Dim> random_vector(std::uint64_t index) {
  RandomStream draw(99, Purpose::test, index);
  Vec<Dim> v;
  for (int d = 0; d < Dim; ++d) v[d] = draw.uniform(-1, 1);
  return v;
}

double product(double a, double b) { return a * b; }
double product(const Vec3& a, const Vec3& b) { return dot(a, b); }

template <class Dimension>
class Record : public ::testing::Test {};
template <int D>
struct Dimension {
  static constexpr int value = D;
};
using Dimensions = ::testing::Types<Dimension<2>, Dimension<3>>;
TYPED_TEST_SUITE(Record, Dimensions);

TYPED_TEST(Record, WeightsSumToZeroAndAreTheGradientOfTheGap) {
  constexpr int dim = TypeParam::value;
  System<dim> system = random_discs_in_motion<dim>(30, 0.4, 1);
  const auto records = detect_discs(system);
  ASSERT_GT(records.size(), 20u);
  for (const auto& record : records) {
    double sum = 0;
    for (int k = 0; k < record.sites; ++k) {
      sum += record.weight[k];
      for (int d = 0; d < dim; ++d) {
        const double h = 1e-6;
        double& x = system.state.position[record.site[k]][d];
        const double x0 = x;
        x = x0 + h;
        const double above = disc_contact(system, record.row).gap;
        x = x0 - h;
        const double below = disc_contact(system, record.row).gap;
        x = x0;
        EXPECT_NEAR((above - below) / (2 * h), record.weight[k] * record.normal[d], 1e-8);
      }
    }
    EXPECT_EQ(sum, 0);
    EXPECT_NEAR(norm(record.normal), 1, 1e-15);
  }
}

TYPED_TEST(Record, AnyForceGivesNoNetForceNorTorque) {
  constexpr int dim = TypeParam::value;
  const System<dim> system = random_discs_in_motion<dim>(30, -0.3, 2);
  for (const auto& record : detect_discs(system)) {
    std::vector<Vec<dim>> force(30);
    std::vector<Angular<dim>> torque(30);
    scatter(record, random_vector<dim>(record.row), force, torque);
    Vec<dim> net_force{};
    Angular<dim> net_torque{};
    for (int i = 0; i < 30; ++i) {
      net_force += force[i];
      net_torque += torque[i];
    }
    // Positions: the first disc, and the nearest image of the second.
    const std::int32_t first = record.site[0], second = record.site[1];
    net_torque += cross(record.branch, force[second]);
    EXPECT_LT(norm(net_force), 1e-15);
    EXPECT_LT(std::sqrt(product(net_torque, net_torque)), 1e-14);
    EXPECT_GT(norm(force[first]), 0);
  }
}

TYPED_TEST(Record, PowerOfForcesAndTorquesIsForceTimesRelativeVelocity) {
  constexpr int dim = TypeParam::value;
  const System<dim> system = random_discs_in_motion<dim>(30, 1.7, 3);
  int across = 0;
  for (const auto& record : detect_discs(system)) {
    std::vector<Vec<dim>> force(30);
    std::vector<Angular<dim>> torque(30);
    const Vec<dim> f = random_vector<dim>(record.row);
    scatter(record, f, force, torque);
    double power = 0;
    for (int i = 0; i < 30; ++i)
      power += dot(force[i], system.state.velocity[i]) + product(torque[i], system.state.spin[i]);
    const Vec<dim> v = relative_velocity(record, system.state, system.box);
    EXPECT_NEAR(power, dot(f, v + system.box.velocity_jump(record.up)), 1e-13);
    across += record.up != 0;
  }
  EXPECT_GT(across, 0);
}

TYPED_TEST(Record, RigidRotationHasNoRelativeVelocity) {
  constexpr int dim = TypeParam::value;
  System<dim> system = random_discs_in_motion<dim>(20, 0, 4);
  system.box.periodic = {};
  Angular<dim> omega{};
  if constexpr (dim == 2) omega = 1.3;
  else omega = {0.3, -0.8, 1.1};
  for (int i = 0; i < 20; ++i) {
    system.state.velocity[i] = cross(omega, system.state.position[i]);
    system.state.spin[i] = omega;
  }
  const auto records = detect_discs(system);
  ASSERT_GT(records.size(), 5u);
  for (const auto& record : records)
    EXPECT_LT(norm(relative_velocity(record, system.state, system.box)), 1e-14);
}

TYPED_TEST(Record, ReferencePathAddsForcesVirialAndEnergyOfTheLaw) {
  constexpr int dim = TypeParam::value;
  System<dim> system = random_discs_in_motion<dim>(25, 0.4, 5);
  const auto spring = [](const ContactMotion<dim>& motion,
                         std::span<double> history) -> ContactResponse<dim> {
    history[0] = motion.history[0] + motion.dt;
    return {-motion.record.gap * motion.record.normal, 0.5 * motion.record.gap * motion.record.gap, 0,
            ContactState::stick};
  };
  const auto evaluate = [&](const System<dim>& s) {
    Evaluation<dim> out;
    out.force.resize(25);
    out.torque.resize(25);
    evaluate_records(s, detect_discs(s), spring, 0.5, out);
    return out;
  };
  const Evaluation<dim> out = evaluate(system);
  for (std::int32_t row = 0; row < system.pairs.size(); ++row) {
    const auto record = disc_contact(system, row);
    const bool acts = record.gap < 0 || system.pairs.state[row] == ContactState::permanent;
    EXPECT_EQ(out.trial_state[row], acts ? ContactState::stick : ContactState::open);
    EXPECT_EQ(out.trial_history[row], acts ? system.pairs.history[row] + 0.5 : 0);
  }
  // Shear: W_xy = -dE/d(strain), all positions and the boundary following affinely.
  const double h = 1e-6;
  const auto energy_at = [&](double strain) {
    System<dim> sheared = system;
    sheared.box.strain += strain;
    for (auto& x : sheared.state.position) x[flow] += strain * x[gradient];
    return evaluate(sheared).energy.elastic;
  };
  EXPECT_NEAR(out.virial[flow][gradient], -(energy_at(h) - energy_at(-h)) / (2 * h), 1e-6);
  EXPECT_GT(std::abs(out.virial[flow][gradient]), 1e-3);
}

void expect_same(const Evaluation<2>& fast, const Evaluation<2>& reference) {
  const double tolerance = 1e-12;
  double largest = 0;
  for (std::size_t i = 0; i < fast.force.size(); ++i) largest = std::max(largest, norm(reference.force[i]));
  ASSERT_GT(largest, 0);
  for (std::size_t i = 0; i < fast.force.size(); ++i) {
    EXPECT_LT(norm(fast.force[i] - reference.force[i]), tolerance * largest);
    EXPECT_NEAR(fast.torque[i], reference.torque[i], tolerance * largest);
  }
  EXPECT_EQ(fast.trial_state, reference.trial_state);
  for (std::size_t k = 0; k < fast.trial_history.size(); ++k)
    EXPECT_NEAR(fast.trial_history[k], reference.trial_history[k], tolerance);
  EXPECT_NEAR(fast.energy.elastic, reference.energy.elastic, tolerance * std::abs(reference.energy.elastic));
  EXPECT_NEAR(fast.energy.tangential, reference.energy.tangential, tolerance * reference.energy.tangential);
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b)
      EXPECT_NEAR(fast.virial[a][b], reference.virial[a][b], tolerance * 100 * largest);
}

TEST(RecordPaths, FastLoopOverDiscsAgreesWithTheReferencePath) {
  int slipping = 0, sticking = 0, linked = 0;
  for (const Slip slip : {Slip::clamp, Slip::freeze, Slip::reset})
    for (const Repulsion& repulsion : {Repulsion(Divergent(1)), Repulsion(Divergent(0.3)), Repulsion(Hertz()),
                                       Repulsion(Plateau(1, 0.3, 0.8, 0.1)), Repulsion(Adhesive(0.2))})
      for (const double strain : {0.0, 0.37, -2.2}) {
        System<2> system = random_discs_in_motion<2>(40, strain, 6);
        const DiscLaw law{
            {100, 2, 80, 1.5}, {60, 1, 40, 0.7}, Tensile(Tensile::Kind::exponential), 0.25, slip,
            LeverArm::distance};
        Evaluation<2> fast, reference;
        for (Evaluation<2>* e : {&fast, &reference}) {
          e->force.resize(40);
          e->torque.resize(40);
        }
        DiscContacts(repulsion, law).evaluate(system, 1e-2, Detail::energies, fast);
        std::visit(
            [&](const auto& r) {
              evaluate_records(
                  system, detect_discs(system, range_of(r)),
                  [&](const ContactMotion<2>& m, std::span<double> u) { return respond(r, law, m, u); }, 1e-2,
                  reference);
            },
            repulsion);
        expect_same(fast, reference);
        for (const ContactState state : fast.trial_state) {
          slipping += state == ContactState::slip;
          sticking += state == ContactState::stick;
          linked += state == ContactState::permanent;
        }
      }
  EXPECT_GT(slipping, 100);
  EXPECT_GT(sticking, 100);
  EXPECT_GT(linked, 100);
}

}  // namespace
}  // namespace supple
