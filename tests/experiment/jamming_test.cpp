#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "supple/core/random.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/experiment/jam.hpp"
#include "supple/experiment/packing_record.hpp"
#include "supple/model/rigid.hpp"

namespace supple {
namespace {

struct Family {
  const char *name, *family, *contact;
  double shape_parameter = 0;
  int discs = 0;
  int seed = 1;
};

void PrintTo(const Family& f, std::ostream* out) { *out << f.name; }

Case small_case(const Family& f) {
  Case c;
  c.general.experiment = "jamming";
  c.general.seed = f.seed;
  c.bodies.family = f.family;
  c.bodies.count = 8;
  c.bodies.vertices = 10;
  c.bodies.shape_parameter = f.shape_parameter;
  c.bodies.discs = f.discs;
  c.contact.kind = f.contact;
  c.jamming.packing_fraction = 0.4;
  c.jamming.step = 0.01;
  c.jamming.pressure = 1e-5;
  resolve_family(c);
  return c;
}

class JammingOf : public ::testing::TestWithParam<Family> {};

/// U of the packing with cell and bodies strained by e_ij: vertices move with the strain, rigid bodies with
/// their centres.
double strained_energy(const Packing<2>& packing, int i, int j, double e) {
  Packing<2> p = packing;
  System<2>& s = p.system;
  const auto move = [&](Vec2& x) { x[i] += e * x[j]; };
  for (Vec2& x : s.state.position) move(x);
  for (Vec2& x : s.rigid.centre) move(x);
  place_sites(s);
  if (i == j) {
    s.box.length[i] *= 1 + e;
    s.box.strain *= i == flow ? 1 + e : 1 / (1 + e);
  } else {
    s.box.strain += e;
  }
  Evaluation<2> out;
  p.field->invalidate();
  p.field->evaluate(s, Detail::energies, out);
  return out.energy.stored();
}

/// dU/d(strain) by a difference of fourth order.
double slope(const Packing<2>& p, int i, int j) {
  const double h = 2e-6;  // contacts must not open or close within it
  return (8 * (strained_energy(p, i, j, h) - strained_energy(p, i, j, -h)) -
          (strained_energy(p, i, j, 2 * h) - strained_energy(p, i, j, -2 * h))) /
         (12 * h);
}

TEST_P(JammingOf, ReachesTheWindow) {
  const Case c = small_case(GetParam());
  MemoryRecorder recorder;
  run(c, nullptr, recorder);
  const double p = recorder.get("results", "pressure");
  EXPECT_GT(p, c.jamming.pressure);
  EXPECT_LT(p, c.jamming.pressure * (1 + c.jamming.window));
  EXPECT_LE(recorder.get("results", "residual"), recorder.get("results", "tolerance"));
  EXPECT_EQ(recorder.get("results", "unconverged"), 0);
  EXPECT_GT(recorder.get("results", "packing_fraction"), 0.6);
  EXPECT_LT(recorder.get("results", "packing_fraction"), 1);
  EXPECT_GT(recorder.get("results", "mean_contacts"), 2);
  EXPECT_LT(recorder.get("results", "rattlers"), 7);
  EXPECT_TRUE(recorder.warnings.empty()) << recorder.warnings.front();
}

/// The same by minima of the enthalpy, of both pressures; contacts end as hard as they were.
TEST_P(JammingOf, ReachesTheWindowAtConstantPressure) {
  for (const char* kind : {"full", "contact"}) {
    Case c = small_case(GetParam());
    c.jamming.search = "pressure";
    c.jamming.pressure_kind = kind;
    Packing<2> packing = make_packing(c, nullptr, 0.4);
    const double stiffness = packing.field->bodies()->laws().common().scale().stiffness;
    const JamProgress<2> end = jam(packing, jam_spec(c));
    EXPECT_EQ(packing.field->bodies()->laws().common().scale().stiffness, stiffness);
    EXPECT_TRUE(end.last.converged);
    EXPECT_EQ(end.unconverged, 0);
    const PackingState<2> s = observe(packing);
    const double p = packing.contact_pressure ? s.contact_pressure : s.full_pressure;
    EXPECT_GT(p, c.jamming.pressure);
    EXPECT_LT(p, c.jamming.pressure * (1 + c.jamming.window));
    EXPECT_GT(s.packing_fraction, 0.6);
    EXPECT_LT(s.packing_fraction, 1);
    Evaluation<2> out;
    packing.field->evaluate(packing.system, Detail::forces, out);
    EXPECT_LE(largest_net_force(packing.system, out.force), end.last.tolerance);
  }
}

/// -dU/d(strain) is the stress, and the stresses of the particles add up to it.
TEST_P(JammingOf, HasTheStressOfItsEnergy) {
  Case c = small_case(GetParam());
  c.jamming.pressure = 3e-3;
  c.jamming.search = "root";  // rigid particles cannot be shaken: in this sample no rattler just touches
  Packing<2> packing = make_packing(c, nullptr, 0.4);
  jam(packing, jam_spec(c));
  // The two agree in any state. In equilibrium rattlers just touch, where the energy has a kink in its second
  // derivative and differences mean nothing: shake the packing a little.
  System<2>& s = packing.system;
  RandomStream draw(2, Purpose::test);
  for (std::size_t i = 0; i < s.state.position.size(); ++i)
    for (int d = 0; d < 2; ++d) s.state.position[i][d] += 0.03 * s.state.radius[i] * draw.uniform(-1, 1);
  place_sites(s);  // rigid bodies stay: their stress is symmetric only where no torque acts
  const PackingReport<2> r = report_packing(packing);
  const double area = packing.system.box.volume();
  const Mat2 stress = r.stresses.virial();
  const double scale = pressure(stress);
  ASSERT_GT(scale, 0);
  for (const auto& [i, j] : {std::pair{0, 0}, {1, 1}, {flow, gradient}})
    EXPECT_NEAR(stress[i][j], -slope(packing, i, j) / area, 1e-8 * scale) << i << j;
  EXPECT_NEAR(stress[0][1], stress[1][0], 1e-12 * scale);
  Mat2 sum;
  for (const Mat2& moment : r.stresses.moment) sum += moment;
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) {
      EXPECT_NEAR(sum[i][j] / area, stress[i][j], 1e-12 * scale) << i << j;
      EXPECT_NEAR(r.evaluation.virial[i][j] / area, stress[i][j],
                  s.rigid.body.empty() ? 1e-12 * scale : 1e-5 * scale)
          << i << j;
    }
}

INSTANTIATE_TEST_SUITE_P(
    Families, JammingOf,
    ::testing::Values(Family{"shell", "shell", "rough"}, Family{"floppy_104", "floppy", "rough", 1.04},
                      Family{"floppy_115", "floppy", "rough", 1.15}, Family{"droplet", "droplet", "rough"},
                      Family{"smooth_shell", "shell", "smooth"},
                      Family{"smooth_droplet", "droplet", "smooth"}, Family{"network", "network", "rough"},
                      Family{"elastic", "elastic", "rough"}, Family{"smooth_network", "network", "smooth"},
                      Family{"smooth_elastic", "elastic", "smooth"}, Family{"disc", "disc", "rough"},
                      Family{"rough_disc", "rough_disc", "rough"}, Family{"mixed", "shell", "rough", 0, 4, 2},
                      Family{"mixed_smooth", "shell", "smooth", 0, 4}),
    [](const auto& given) { return std::string(given.param.name); });

TEST(Jamming, AllSearchesEndInTheSameWindow) {
  Case c = small_case({"disc", "disc", "rough"});
  c.bodies.count = 16;
  c.jamming.pressure = 1e-6;
  double phi[3];
  int k = 0;
  for (const char* search : {"chapter", "root", "pressure"}) {
    c.jamming.search = search;
    MemoryRecorder recorder;
    run(c, nullptr, recorder);
    EXPECT_GT(recorder.get("results", "pressure"), 1e-6);
    EXPECT_LT(recorder.get("results", "pressure"), 1.01e-6);
    phi[k++] = recorder.get("results", "packing_fraction");
  }
  EXPECT_NEAR(phi[0], phi[2], 0.03);
  EXPECT_NEAR(phi[0], phi[1], 0.03);  // not the same packing: the way there differs
}

TEST(Jamming, SameSeedSameBits) {
  const Case c = small_case({"shell", "shell", "rough"});
  MemoryRecorder one, two;
  run(c, nullptr, one);
  run(c, nullptr, two);
  EXPECT_EQ(one.last_system.state.position, two.last_system.state.position);
}

TEST(Jamming, SmallMinimisationsSayThatTheyDidNotConverge) {
  Case c = small_case({"shell", "shell", "rough"});
  c.minimise.max_evaluations = 20;
  MemoryRecorder recorder;
  try {
    run(c, nullptr, recorder);
    EXPECT_GT(recorder.get("results", "unconverged"), 0);
    EXPECT_FALSE(recorder.warnings.empty());
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::numerics);
    EXPECT_GT(recorder.last_system.state.size(), 0) << "the state is handed over";
  }
}

TEST(Compression, GoesUpTheListAndBack) {
  Case c = small_case({"disc", "disc", "rough"});
  c.general.experiment = "compression";
  c.bodies.count = 16;
  c.jamming.pressure = 1e-5;
  c.compression.highest_pressure = 1e-3;
  c.compression.per_decade = 2;
  MemoryRecorder recorder;
  run(c, nullptr, recorder);
  const auto& table = recorder.tables.at("packing");
  const std::vector<double> p = table.column("pressure"), phi = table.column("packing_fraction"),
                            branch = table.column("branch");
  ASSERT_EQ(p.size(), 9u);
  for (std::size_t k = 0; k < p.size(); ++k) {
    const double wanted = 1e-5 * std::pow(10, 0.5 * static_cast<double>(k < 5 ? k : 8 - k));
    EXPECT_GT(p[k], wanted) << k;
    EXPECT_LT(p[k], 1.01 * wanted) << k;
    EXPECT_EQ(branch[k], k < 5 ? 1 : -1);
  }
  EXPECT_GT(phi[4], phi[0] + 1e-4);
  EXPECT_EQ(recorder.frames.size(), p.size()) << "the last instant is kept once";
}

/// A second cycle begins at the pressure that the first came back to, and a state above all pressures goes
/// down to them.
TEST(Compression, CyclesComeBackToTheFirstPressure) {
  Case c = small_case({"disc", "disc", "rough"});
  c.general.experiment = "compression";
  c.bodies.count = 16;
  c.compression.highest_pressure = 1e-3;
  c.compression.per_decade = 1;
  MemoryRecorder first, second, above;
  run(c, nullptr, first);
  InitialState state;
  state.system = first.last_system;
  run(c, &state, second);
  const std::vector<double> p = second.tables.at("packing").column("pressure");
  ASSERT_EQ(p.size(), 5u);
  for (const double end : {p.front(), p.back()}) {
    EXPECT_GT(end, 1e-5);
    EXPECT_LT(end, 1.01e-5);
  }
  c.compression.highest_pressure = 5e-5;
  c.compression.per_decade = 4;
  c.jamming.pressure = 2e-6;
  run(c, &state, above);
  EXPECT_LT(above.tables.at("packing").column("pressure").back(), 2.02e-6);
  c.jamming.pressure = 1e-7;
  c.compression.highest_pressure = 1e-6;
  MemoryRecorder down;
  run(c, &state, down);
  for (const double branch : down.tables.at("packing").column("branch")) EXPECT_EQ(branch, -1);
  EXPECT_EQ(down.tables.at("packing").rows.size(), 5u);
  EXPECT_LT(down.tables.at("packing").column("pressure").back(), 1.01e-7);
  c.compression.decompress = false;
  EXPECT_THROW(run(c, &state, down), Error);
}

/// The least p^2/(4 pi a) is below what the edges want: the regular polygon is a saddle, however far from its
/// neighbours.
TEST(Packing, FreeParticlesFindTheirPreferredShape) {
  Case c = small_case({"floppy", "floppy", "rough", 1.02});
  c.bodies.vertices = 20;
  Packing<2> packing = make_packing(c, nullptr, 1e-3);
  const MinimiseReport report = relax(packing);
  EXPECT_TRUE(report.converged);
  EXPECT_LT(observe(packing).energy, 1e-18);
  for (const double a : measure_shapes(packing.system).shape_parameter) EXPECT_NEAR(a, 1.02, 1e-6);
}

TEST(Jamming, RefusesCellsInWhichParticlesMeetThemselves) {
  Case c = small_case({"disc", "disc", "rough"});
  c.bodies.count = 3;
  c.jamming.packing_fraction = 1e-3;
  MemoryRecorder recorder;
  try {
    run(c, nullptr, recorder);
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::input);
    EXPECT_THAT(e.what(), ::testing::HasSubstr("raise bodies.N"));
  }
}

TEST(Jamming, RefusesStatesBetweenWallsAndMicrogels) {
  Case c = small_case({"disc", "disc", "rough"});
  InitialState state;
  state.system = make_packing(c, nullptr, 0.4).system;
  system_of<2>(state).box.periodic = {false, false};
  MemoryRecorder recorder;
  EXPECT_THROW(run(c, &state, recorder), Error);
  system_of<2>(state).box.periodic = {true, true};
  system_of<2>(state).topology = {};
  EXPECT_THROW(run(c, &state, recorder), Error);
}

Case dynamics_case(const char* family) {
  Case c = small_case({family, family, "rough"});
  c.general.experiment = "dynamics";
  c.general.physics = "deformable";
  c.jamming.packing_fraction = 0.3;
  c.motion.kinetic_energy = 1e-5;
  c.time.steps = 60;
  return c;
}

TEST(BodyDynamicsRun, KeepsTheEnergyThatItDrew) {
  for (const char* family : {"shell", "rough_disc"}) {
    MemoryRecorder recorder;
    run(dynamics_case(family), nullptr, recorder);
    const std::vector<double> total = recorder.tables.at("motion").column("total_energy");
    const std::vector<double> kinetic = recorder.tables.at("motion").column("kinetic_energy");
    ASSERT_GT(kinetic.front(), 0);
    EXPECT_NEAR(total[1], total[0], 1e-4 * total[0]) << family;
    EXPECT_NEAR(total.back(), total[0], 1e-4 * total[0]) << family;
  }
}

TEST(BodyDynamicsRun, ParticlesGetTheKineticEnergyAskedFor) {
  for (const char* family : {"disc", "shell", "rough_disc"})
    for (const int count : {2, 8}) {
      Case c = dynamics_case(family);
      c.bodies.count = count;
      c.jamming.packing_fraction = 0.1;
      MemoryRecorder recorder;
      run(c, nullptr, recorder);
      const std::string name = family;
      const double motions = name == "shell" ? 10 : name == "disc" ? 1 : 1.5;
      EXPECT_NEAR(recorder.tables.at("motion").column("kinetic_energy").front(), 1e-5 * motions * count,
                  1e-12 * motions * count)
          << family;
    }
  Case one = dynamics_case("disc");
  one.bodies.count = 1;
  one.jamming.packing_fraction = 0.05;
  EXPECT_THROW(derive(one, nullptr), Error);
}

TEST(BodyDynamicsRun, GoesOnFromItsStateBitForBit) {
  Case c = dynamics_case("shell");
  MemoryRecorder whole, half, rest;
  run(c, nullptr, whole);
  c.time.steps = 30;
  run(c, nullptr, half);
  InitialState state;
  state.system = half.last_system;
  state.protocol["dt"] = half.get("protocol", "dt");
  run(c, &state, rest);
  EXPECT_EQ(rest.last_system.state.position, whole.last_system.state.position);
  EXPECT_EQ(rest.last_system.state.velocity, whole.last_system.state.velocity);
}

}  // namespace
}  // namespace supple
