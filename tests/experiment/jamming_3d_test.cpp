#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "supple/core/error.hpp"
#include "supple/experiment/jam.hpp"
#include "supple/experiment/random_surfaces.hpp"
#include "supple/observe/body_stress.hpp"
#include "supple/observe/rattlers.hpp"
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
};

void PrintTo(const Family& f, std::ostream* out) { *out << f.name; }

/// Bending, tension and shape parameter of the families of Table 9.1, stiffnesses relative.
ShapeSpec spec(double area, double bending, double tension, double shape_parameter) {
  ShapeSpec s{.area = 1, .length = area, .bending = bending, .tension = tension};
  s.shape_parameter = shape_parameter;
  return s;
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
  SurfaceSample sample{.count = f.vertices == 1 ? 16 : f.particles, .vertices = f.vertices, .shape = f.shape};
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

  Evaluation<3> out;
  System<3>& s = packing.system;
  packing.field->evaluate(s, Detail::energies, out);
  const BodyStresses<3> stresses = body_stresses(s, *packing.field, out);
  Mat<3> moments;
  for (const Mat<3>& m : stresses.moment) moments += m;
  const double scale = end.state.pressure * packing.pressure_unit * s.box.volume();
  testing::StrainedPacking strained(packing);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const double near = 1e-8 * scale;
      EXPECT_NEAR(out.virial[i][j], s.box.volume() * stresses.virial()[i][j], near) << i << j;
      EXPECT_NEAR(out.virial[i][j], moments[i][j], near) << i << j;
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
                      Family{"sheared_smooth_droplets", "smooth", 42, droplet, by_pressure, 4, 1e-5, 0.3}),
    [](const auto& i) { return std::string(i.param.name); });

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

}  // namespace
}  // namespace supple
