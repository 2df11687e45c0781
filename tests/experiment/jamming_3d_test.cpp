#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "supple/core/error.hpp"
#include "supple/core/parallel.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/experiment/jam.hpp"
#include "supple/experiment/random_surfaces.hpp"
#include "supple/experiment/sound_states.hpp"
#include "supple/io/text/case_file.hpp"
#include "supple/model/bodies.hpp"
#include "supple/model/rigid.hpp"
#include "supple/observe/body_stress.hpp"
#include "supple/observe/rattlers.hpp"
#include "tests/paths.hpp"
#include "tests/support/dense.hpp"
#include "tests/support/strained_packing.hpp"

namespace supple {
namespace {

struct Family {
  const char *name, *contact;
  int vertices;
  ShapeSpec shape;
  JamSearch search = JamSearch::pressure;
  int particles = 4;  ///< of many vertices
  double pressure = 1e-5;
  double strain = 0;  ///< of the cell
  SurfaceMotion motion = SurfaceMotion::deforming;
};

void PrintTo(const Family& f, std::ostream* out) { *out << f.name; }

/// Bending, tension and shape parameter of the families of Table 9.1, stiffnesses relative.
ShapeSpec spec(double area, double bending, double tension, double shape_parameter) {
  ShapeSpec s{.area = 1, .length = area, .bending = bending, .tension = tension};
  s.shape_parameter = shape_parameter;
  return s;
}

Family rigid(const char* name, int vertices, JamSearch search, int particles, double pressure,
             double strain = 0) {
  return {name, "rough", vertices, {}, search, particles, pressure, strain, SurfaceMotion::rigid};
}

Case case_of(const Family& f) {
  Case c;
  c.general.experiment = "jamming";
  c.contact.kind = f.contact;
  return c;
}

class JammingIn3D : public ::testing::TestWithParam<Family> {};

/// There -dU/d(strain) is the stress, for strains that the cell can make and those that it cannot, and the
/// stresses of particles add up to it.
TEST_P(JammingIn3D, EndsInThePressureWindow) {
  const Family& f = GetParam();
  const Case c = case_of(f);
  SurfaceSample sample{.count = f.vertices == 1 ? 16 : f.particles,
                       .vertices = f.vertices,
                       .motion = f.motion,
                       .shape = f.shape};
  System<3> sheared = random_surfaces(sample);
  sheared.box.strain = f.strain;
  Packing<3> packing = packing_of(c, sheared);
  JamSpec wanted;
  wanted.search = f.search;
  wanted.pressure = f.pressure;
  wanted.step = 0.01;
  const JamProgress<3> end = jam(packing, wanted);
  EXPECT_TRUE(in_window(wanted, end.state.pressure)) << end.state.pressure;
  EXPECT_TRUE(end.last.converged) << end.last.reason;
  EXPECT_TRUE(look_at(packing).sound()) << look_at(packing).what();

  Evaluation<3> out;
  System<3>& s = packing.system;
  packing.field->evaluate(s, Detail::energies, out);
  const BodyStresses<3> stresses = body_stresses(s, *packing.field, out);
  // The torque that is left on rigid bodies, which makes the slope of the energy unsymmetric, turns them.
  Mat<3> moments;
  for (const Mat<3>& m : stresses.moment) moments += m;
  const double scale = end.state.pressure * packing.pressure_unit * s.box.volume();
  testing::StrainedPacking strained(packing);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const double near = 1e-8 * scale;
      const double both = 0.5 * (out.virial[i][j] + out.virial[j][i]);
      EXPECT_NEAR(both, s.box.volume() * stresses.virial()[i][j], near) << i << j;
      EXPECT_NEAR(both, moments[i][j], near) << i << j;
      EXPECT_NEAR(out.virial[i][j], strained.moment(i, j), near) << i << j;
      if (!testing::box_holds(i, j)) continue;
      EXPECT_NEAR(out.virial[i][j], strained.moment_by_box(i, j), near) << i << j;
    }
}

const ShapeSpec shell = spec(1, 0.05, 0, 0), floppy = spec(1, 0, 0, 1.04), droplet = spec(0.1, 0, 0.2, 0);

constexpr JamSearch by_pressure = JamSearch::pressure;

INSTANTIATE_TEST_SUITE_P(
    Families, JammingIn3D,
    ::testing::Values(Family{"spheres", "rough", 1, {}},
                      Family{"spheres_by_root", "rough", 1, {}, JamSearch::root},
                      Family{"smooth_spheres", "smooth", 1, {}}, Family{"rough_shells", "rough", 42, shell},
                      Family{"smooth_shells", "smooth", 42, shell},
                      Family{"rough_floppy", "rough", 42, floppy, by_pressure, 6, 1e-3},
                      Family{"smooth_floppy", "smooth", 42, floppy, by_pressure, 4, 1e-3},
                      Family{"rough_droplets", "rough", 42, droplet},
                      Family{"smooth_droplets", "smooth", 42, droplet},
                      Family{"sheared_spheres", "rough", 1, {}, by_pressure, 4, 1e-5, 0.3},
                      Family{"sheared_smooth_spheres", "smooth", 1, {}, by_pressure, 4, 1e-5, -0.3},
                      Family{"sheared_rough_shells", "rough", 42, shell, by_pressure, 4, 1e-5, 0.3},
                      Family{"sheared_smooth_shells", "smooth", 42, shell, by_pressure, 4, 1e-5, 0.7},
                      Family{"sheared_rough_floppy", "rough", 42, floppy, by_pressure, 6, 1e-3, 0.2},
                      Family{"sheared_smooth_floppy", "smooth", 42, floppy, by_pressure, 4, 1e-3, 0.2},
                      Family{"sheared_rough_droplets", "rough", 42, droplet, by_pressure, 4, 1e-5, -0.4},
                      Family{"sheared_smooth_droplets", "smooth", 42, droplet, by_pressure, 4, 1e-5, 0.3},
                      rigid("rigid_rough_12", 12, JamSearch::pressure, 6, 1e-6),
                      rigid("rigid_rough_12_by_root", 12, JamSearch::root, 7, 1e-6),
                      rigid("rigid_rough_42", 42, JamSearch::pressure, 8, 1e-7),
                      rigid("rigid_rough_42_by_root", 42, JamSearch::root, 4, 1e-6),
                      rigid("sheared_rigid_rough_12", 12, JamSearch::pressure, 6, 1e-6, 0.4),
                      rigid("sheared_rigid_rough_42", 42, JamSearch::pressure, 8, 1e-6, -0.3)),
    [](const auto& i) { return std::string(i.param.name); });
/// Steps that are halved above the pressure. Spheres that bear nothing are left just touching there, so that
/// no slope of the energy is taken.
TEST(PackingsIn3D, TheChaptersSearchEndsInThePressureWindow) {
  for (const Family& f : {Family{"spheres", "rough", 1, {}}, Family{"shells", "rough", 42, shell}}) {
    SCOPED_TRACE(f.name);
    Packing<3> packing = packing_of(
        case_of(f),
        random_surfaces({.count = f.vertices == 1 ? 16 : 4, .vertices = f.vertices, .shape = f.shape}));
    JamSpec wanted;
    wanted.search = JamSearch::chapter;
    wanted.pressure = 1e-4;
    wanted.step = 0.01;
    const JamProgress<3> end = jam(packing, wanted);
    EXPECT_TRUE(in_window(wanted, end.state.pressure)) << end.state.pressure;
    EXPECT_TRUE(end.last.converged) << end.last.reason;
    EXPECT_TRUE(look_at(packing).sound()) << look_at(packing).what();
  }
}

/// The example of the documents: 16 shells of 42 vertices, rough, to 1 < P/1e-7 < 1.01.
TEST(PackingsIn3D, TheExampleEndsInItsPressureWindow) {
  Case c = read_case(std::string(SUPPLE_SOURCE_DIR) + "/examples/jamming_3d.toml");
  resolve_family(c);
  MemoryRecorderOf<3> recorder;
  run(c, nullptr, recorder);
  const double pressure = recorder.get("results", "pressure");
  EXPECT_GT(pressure, 1e-7);
  EXPECT_LT(pressure, 1.01e-7);
  EXPECT_EQ(recorder.get("results", "unsound"), 0);
  EXPECT_EQ(recorder.get("results", "contacts_beyond_isostatic"), 0);
}

/// Without stiff triangles a droplet bears the tension gamma s0 = 3/2 max(x - x^4) k_v v0^2 = 0.7087.
TEST(PackingsIn3D, TensionThatNothingBearsIsRefused) {
  const Case c = case_of({"droplets", "rough", 42, {}});
  const auto droplets = [](double tension) {
    return random_surfaces({.count = 2, .shape = spec(0, 0, tension, 0)});
  };
  EXPECT_NO_THROW(packing_of(c, droplets(0.70)));
  try {
    packing_of(c, droplets(0.72));
    FAIL();
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("shrinks to a point"), std::string::npos) << e.what();
  }
}

/// docs/decisions/0020.
TEST(PackingsIn3D, EdgesThatVerticesDoNotCoverAreRefused) {
  const System<3> thin = random_surfaces({.count = 2, .diameter_ratio = 0.7});
  EXPECT_NO_THROW(packing_of(case_of({"smooth", "smooth", 42, {}}), thin));
  EXPECT_THROW(packing_of(case_of({"rough", "rough", 42, {}}), thin), Error);
}

TEST(PackingsIn3D, SamplesThatCannotBeAreRefused) {
  EXPECT_THROW(random_surfaces({.count = 0}), Error);
  EXPECT_THROW(random_surfaces({.vertices = 43}), Error);
  EXPECT_THROW(random_surfaces({.packing_fraction = 0.8}), Error);
}

/// A just rigid packing of N spheres without friction has 3N - 2 contacts, rattlers left out [O'Hern 2003].
TEST(JammedSpheres, AreIsostatic) {
  SurfaceSample sample{.count = 32, .vertices = 1};
  sample.seed = 3;
  Packing<3> packing = packing_of(case_of({"spheres", "rough", 1, {}}), random_surfaces(sample));
  JamSpec wanted;
  wanted.pressure = 1e-7;
  wanted.step = 0.01;
  jam(packing, wanted);
  System<3>& s = packing.system;
  Evaluation<3> out;
  packing.field->evaluate(s, Detail::energies, out);
  BodyContacts<3>& law = *packing.field->bodies();
  const auto contacts = site_contacts(s, law.records(s), law.laws());
  const std::vector<std::uint8_t> rattlers = find_rattlers(s, contacts);
  const ContactNumbers numbers = count_contacts(contact_network(s, contacts), rattlers);
  EXPECT_LT(std::count(rattlers.begin(), rattlers.end(), 1), 6);
  EXPECT_NEAR(numbers.mean(), 6 - 4.0 / numbers.bodies, 0.01 * 6);
  EXPECT_EQ(count_constraints(s, contacts, rattlers).excess(), numbers.pairs - (3 * numbers.bodies - 2));
  EXPECT_NEAR(covered_fraction(packing), 0.63, 0.03);
}

/// Without friction, in a periodic cell, N rigid surfaces have 6N degrees of freedom of which 3 are
/// translations of all: a just rigid packing has 6N - 2 contacts, rattlers left out.
TEST(JammedRigidSurfaces, AreIsostaticAndHaveNoFreeMotion) {
  for (const int vertices : {12, 42}) {
    SurfaceSample sample{.count = 8, .vertices = vertices, .motion = SurfaceMotion::rigid};
    sample.seed = 4;
    Packing<3> packing = packing_of(case_of({"rigid", "rough", vertices, {}}), random_surfaces(sample));
    const System<3> before = packing.system;
    ASSERT_EQ(before.rigid.size(), 8);
    JamSpec wanted;
    wanted.pressure = 1e-7;
    wanted.step = 0.01;
    ASSERT_TRUE(in_window(wanted, jam(packing, wanted).state.pressure));
    System<3>& s = packing.system;
    BodyContacts<3>& law = *packing.field->bodies();
    const auto contacts = site_contacts(s, law.records(s), law.laws());
    const std::vector<std::uint8_t> rattlers = find_rattlers(s, contacts);
    const auto loose = static_cast<int>(std::count(rattlers.begin(), rattlers.end(), 1));
    EXPECT_LE(loose, 2);
    const ConstraintCount count = count_constraints(s, contacts, rattlers);
    EXPECT_EQ(count.freedoms, 6 * (8 - loose));
    EXPECT_EQ(count.needed(), 6 * (8 - loose) - 2);
    EXPECT_EQ(count.excess(), 0) << count.contacts;

    BodyObjective<3> objective(s, *packing.field, packing.tolerance);
    ASSERT_EQ(objective.size(), 6 * 8);
    SparseMatrix lower;
    objective.hessian(objective.coordinates(), lower);
    const Eigen::VectorXd modes =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(testing::dense(lower)).eigenvalues();
    const double most = modes[modes.size() - 1];
    int free = 0;
    for (const double mode : modes) free += mode < 1e-9 * most;
    EXPECT_EQ(free, 3 + 6 * loose) << "of all of it, and of each rattler";
    EXPECT_GT(modes[0], -1e-9 * most) << "it is a minimum";

    double bent = 0;  // every body is as it was
    for (int b = 0; b < 8; ++b)
      for (int i = s.topology.begin[b]; i < s.topology.begin[b + 1]; ++i)
        for (int j = s.topology.begin[b]; j < i; ++j)
          bent = std::max(bent, std::abs(norm(s.state.position[i] - s.state.position[j]) -
                                         norm(before.state.position[i] - before.state.position[j])));
    EXPECT_LT(bent, 1e-13);
  }
}

TEST(JammedRigidSurfaces, HaveTheSameBitsForTwoThreads) {
  const auto relaxed = [](int threads) {
    const WithThreads with(threads);
    const SurfaceSample sample{.count = 20, .motion = SurfaceMotion::rigid, .packing_fraction = 0.5};
    Packing<3> packing = packing_of(case_of({"rigid", "rough", 42, {}}), random_surfaces(sample));
    EXPECT_FALSE(threads == 2 && runs_in_place(packing.system.state.size())) << "it must be shared";
    scale_cell(packing.system, 0.85);
    packing.field->invalidate();
    const MinimiseReport report = relax(packing);
    EXPECT_TRUE(report.converged);
    EXPECT_GT(report.energy, 0);
    return packing.system;
  };
  const System<3> one = relaxed(1), two = relaxed(2);
  EXPECT_TRUE(one.state.position == two.state.position);
  EXPECT_TRUE(one.rigid.angle == two.rigid.angle);
}

}  // namespace
}  // namespace supple
