#include "supple/force/surface_shape.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "supple/core/error.hpp"
#include "supple/force/shape_terms.hpp"
#include "supple/force/terms.hpp"
#include "supple/geometry/hinge.hpp"
#include "tests/support/random_surfaces.hpp"
#include "tests/support/surface_reference.hpp"

namespace supple {
namespace {

Evaluation<3> evaluate(const TermSet<3>& terms, const System<3>& system, Detail detail = Detail::energies) {
  Evaluation<3> out;
  out.force.resize(system.state.size());
  terms.evaluate(system, detail, out);
  return out;
}

TermSet<3> fast_terms() {
  TermSet<3> terms;
  terms.add(std::make_shared<SurfaceShape>());
  return terms;
}

Evaluation<3> fast(const System<3>& system, Detail detail = Detail::energies) {
  return evaluate(fast_terms(), system, detail);
}

double largest(const std::vector<Vec3>& force) {
  double most = 0;
  for (const Vec3& f : force) most = std::max(most, norm(f));
  return most;
}

void expect_equals_terms(const System<3>& system, double tolerance = 1e-12) {
  const Evaluation<3> a = fast(system), b = evaluate(shape_terms(system), system);
  EXPECT_NEAR(a.energy.terms, b.energy.terms, 1e-13 * std::abs(b.energy.terms));
  EXPECT_NEAR(SurfaceShape().energy(system), b.energy.terms, 1e-13 * std::abs(b.energy.terms));
  const double scale = largest(b.force);
  ASSERT_GT(scale, 0);
  for (std::size_t i = 0; i < a.force.size(); ++i)
    EXPECT_LT(norm(a.force[i] - b.force[i]), tolerance * scale) << "site " << i;
  for (int c = 0; c < 3; ++c)
    for (int d = 0; d < 3; ++d) EXPECT_NEAR(a.virial[c][d], b.virial[c][d], 1e-11 * scale) << c << d;
}

/// Each kind of energy alone, all of them, and all but bending.
const ShapeSpec kinds[] = {{.area = 1, .length = 1, .bending = 0.1, .tension = 0.05},
                           {.area = 1, .length = 1, .bending = 0, .tension = 0.05},
                           {.area = 1, .length = 0, .bending = 0, .tension = 0},
                           {.area = 0, .length = 1, .bending = 0, .tension = 0},
                           {.area = 0, .length = 0, .bending = 1, .tension = 0},
                           {.area = 0, .length = 0, .bending = 0, .tension = 1}};

TEST(SurfaceShape, EqualsTheTermsItStandsFor) {
  for (const ShapeSpec& shape : kinds) {
    System<3> system = testing::random_surfaces({.shape = shape});
    add_sphere_body(system, {1, 1, 9}, 0.5);
    RandomStream draw(9, Purpose::test);
    testing::add_shaken(system, geodesic_icosahedron(42), {0, 5, 0}, shape, 0.05, draw);
    const int rigid = system.topology.body_count(0) - 1;
    system.shape.stiffness[rigid] = {};
    testing::add_shaken(system, geodesic_icosahedron(12), {0, 8, 0}, shape, 0.05, draw);
    expect_equals_terms(system);
    const Evaluation<3> out = fast(system);
    for (int i = system.topology.begin[rigid - 1]; i < system.topology.begin[rigid + 1]; ++i)
      EXPECT_EQ(norm(out.force[i]), 0);
  }
}

TEST(SurfaceShape, EqualsTheTermsFarFromTheOrigin) {
  expect_equals_terms(testing::random_surfaces({.first_centre = {80, -50, 120}}));
}

std::pair<double, double> least_and_most_angle(const System<3>& system) {
  std::pair range{10.0, -10.0};
  for (const auto& h : system.topology.hinge) {
    Vec3 x[4];
    for (std::size_t k = 0; k < 4; ++k) x[k] = system.state.position[h[k]];
    range = {std::min(range.first, hinge_angle(x)), std::max(range.second, hinge_angle(x))};
  }
  return range;
}

/// Spikes and pits, so that hinges are beyond the 60 degrees of the fast angle on either side.
TEST(SurfaceShape, EqualsTheTermsForSharpHinges) {
  System<3> system = testing::random_surfaces({.vertices = {12, 42, 42}});
  const Topology<3>& t = system.topology;
  for (int b = 0; b < 3; ++b) {
    const Vec3 centre{2.0 * b, 0, 0};
    for (int i = t.begin[b]; i < t.begin[b + 1]; i += 7) {
      Vec3& x = system.state.position[i];
      x = centre + (i % 2 ? 2.5 : 0.45) * (x - centre);
    }
  }
  const auto [least, most] = least_and_most_angle(system);
  EXPECT_LT(least, -1.2);
  EXPECT_GT(most, 1.5);
  expect_equals_terms(system);
}

/// An icosahedron each of whose faces is cut into four: hinges within a face are flat.
TriangleMesh flat_faced() {
  TriangleMesh mesh = geodesic_icosahedron(42);
  std::vector<Vec3> flat = mesh.vertex;
  for (const auto& [a, b, c] : mesh.face)
    for (const auto& [p, q] : {std::pair{a, b}, {b, c}, {c, a}})
      if (p < 12 || q < 12) flat[std::max(p, q)] = {};
  for (const auto& [a, b, c] : mesh.face)  // an edge from a corner to a middle occurs once each way
    for (const auto& [p, q] : {std::pair{a, b}, {b, c}, {c, a}})
      if (p < 12) flat[q] += 0.5 * mesh.vertex[p];
  mesh.vertex = flat;
  return mesh;
}

TEST(SurfaceShape, EqualsTheTermsForNearlyFlatHinges) {
  for (const double jitter : {0.0, 1e-12, 1e-7, 1e-3}) {
    System<3> system;
    RandomStream draw(3, Purpose::test);
    ShapeSpec shape{.area = 0, .length = 0, .bending = 1, .tension = 0};
    testing::add_shaken(system, flat_faced(), {}, shape, jitter, draw);
    EXPECT_LT(std::abs(least_and_most_angle(system).first), 20 * jitter + 1e-15);
    std::fill(system.shape.rest_hinge.begin(), system.shape.rest_hinge.end(), 0.1);
    expect_equals_terms(system);
  }
}

/// More triangulations than a thread keeps, some of them in turn.
TEST(SurfaceShape, EqualsTheTermsForBodiesOfManyMeshes) {
  System<3> system;
  RandomStream draw(4, Purpose::test);
  for (int b = 0; b < 24; ++b) {
    TriangleMesh mesh = geodesic_icosahedron(b % 3 == 0 ? 12 : 42);
    if (b % 4 != 1) testing::reorder(mesh, draw);
    testing::add_shaken(system, mesh, {2.0 * b, 0, 0}, kinds[0], 0.04, draw);
  }
  for (int repeat = 0; repeat < 2; ++repeat) expect_equals_terms(system);
}

TEST(SurfaceShape, ReadsTheNumbersOfTheShapeAtEachEvaluation) {
  System<3> system = testing::random_surfaces();
  const TermSet<3> terms = fast_terms();
  const double before = evaluate(terms, system).energy.terms;
  for (double& a : system.shape.rest_facet) a *= 0.9;
  for (double& a : system.shape.rest_hinge) a += 0.1;
  for (double& v : system.shape.rest_volume) v *= 1.1;
  for (ShapeStiffness& k : system.shape.stiffness) k.hinge *= 2;
  EXPECT_NEAR(evaluate(terms, system).energy.terms, evaluate(shape_terms(system), system).energy.terms,
              1e-11);
  EXPECT_GT(std::abs(evaluate(terms, system).energy.terms - before), 0.1);
}

TEST(SurfaceShape, HasTheSameForcesWithAndWithoutEnergies) {
  const System<3> system = testing::random_surfaces();
  EXPECT_EQ(fast(system, Detail::forces).force, fast(system).force);
  EXPECT_EQ(fast(system, Detail::forces).energy.terms, 0);
}

TEST(SurfaceShape, ForceIsMinusTheSlopeOfTheEnergy) {
  for (const ShapeSpec& shape : kinds) {
    System<3> system = testing::random_surfaces({.vertices = {12, 42}, .shape = shape});
    const Evaluation<3> out = fast(system);
    const double scale = largest(out.force) + out.energy.terms, h = 1e-5;
    for (std::size_t i = 0; i < out.force.size(); ++i)
      for (int d = 0; d < 3; ++d) {
        double& x = system.state.position[i][d];
        const double x0 = x;
        x = x0 + h;
        const double above = fast(system).energy.terms;
        x = x0 - h;
        const double below = fast(system).energy.terms;
        x = x0;
        EXPECT_NEAR(out.force[i][d], -(above - below) / (2 * h), 1e-7 * scale) << i << d;
      }
  }
}

TEST(SurfaceShape, VirialIsMinusTheSlopeByStrain) {
  for (const ShapeSpec& shape : kinds) {
    const System<3> system = testing::random_surfaces({.shape = shape});
    const Evaluation<3> out = fast(system);
    const double h = 1e-5;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const auto strained = [&](double strain) {  // x_i -> x_i + strain x_j
          System<3> moved = system;
          for (Vec3& x : moved.state.position) x[i] += strain * x[j];
          return fast(moved).energy.terms;
        };
        EXPECT_NEAR(out.virial[i][j], -(strained(h) - strained(-h)) / (2 * h),
                    1e-7 * (out.energy.terms + largest(out.force)))
            << i << j;
      }
  }
}

TEST(SurfaceShape, HasNoNetForceAndNoNetTorqueOnABody) {
  for (const ShapeSpec& shape : kinds) {
    const System<3> system = testing::random_surfaces({.shape = shape});
    const Evaluation<3> out = fast(system);
    for (int b = 0; b < 5; ++b) {
      Vec3 force, torque;
      const std::int32_t first = system.topology.begin[b];
      for (std::int32_t i = first; i < system.topology.begin[b + 1]; ++i) {
        force += out.force[i];
        torque += cross(system.state.position[i] - system.state.position[first], out.force[i]);
      }
      EXPECT_LT(norm(force), 1e-13 * largest(out.force));
      EXPECT_LT(norm(torque), 1e-13 * largest(out.force));
    }
  }
}

/// A droplet is under the pressure gamma ds/dv: Laplace's law for a sphere of any triangles, 3 v dv = 2 s ds.
TEST(SurfaceShape, DropletIsUnderLaplacePressure) {
  System<3> system;
  add_surface(system, geodesic_icosahedron(12), 1, {3, 0, 0, 0.2, StiffnessKind::absolute});
  const TriangleMesh mesh = geodesic_icosahedron(12);
  double area = 0;
  for (const double a : face_areas(mesh)) area += a;
  system.shape.rest_volume[0] = 1 + 0.2 * 2 * area / (3 * 1) / 3;
  EXPECT_LT(largest(fast(system).force), 1e-15);
}

TEST(SurfaceShape, GivesTheSameBitsForOneAndTwoThreads) {
  const System<3> system = testing::random_surfaces({.vertices = std::vector<int>(900, 12)});
  const Evaluation<3> one = fast(system);
  const WithThreads threads(2);
  const Evaluation<3> two = fast(system);
  EXPECT_EQ(one.force, two.force);
  EXPECT_EQ(one.energy.terms, two.energy.terms);
  for (int c = 0; c < 3; ++c)
    for (int d = 0; d < 3; ++d) EXPECT_EQ(one.virial[c][d], two.virial[c][d]);
}

TEST(SurfaceShape, RefusesSurfacesThatAreNotClosed) {
  const System<3> whole = testing::random_surfaces({.vertices = {12, 42}});
  System<3> hole = whole, missing = whole, twice = whole, turned = whole, foreign = whole;
  hole.topology.facet.pop_back();
  --hole.topology.facet_begin.back();
  missing.topology.hinge.pop_back();
  --missing.topology.hinge_begin.back();
  twice.topology.hinge[3] = twice.topology.hinge[4];
  std::swap(turned.topology.facet[5][0], turned.topology.facet[5][1]);
  foreign.topology.facet[7][0] += 12;
  for (const System<3>* system : {&hole, &missing, &twice, &turned, &foreign}) {
    EXPECT_THROW(fast(*system), Error);
    HessianBlocks<3> blocks;
    EXPECT_THROW(SurfaceShape().add_hessian(*system, blocks), Error);
  }
  EXPECT_NO_THROW(fast(whole));
}

TEST(SurfaceShape, HasTheEnergiesOfTheReferences) {
  for (const char* name : {"shells4_12_rough", "shells4_42_rough", "shells4_42_smooth"}) {
    const testing::SurfaceReference reference = testing::read_surfaces(name);
    const auto& expected = reference.expected()["energy"];
    double sum = 0;
    const std::pair<const char*, const char*> names[] = {{"enclosed_volume", "volume"},
                                                         {"facet_stretch", "area"},
                                                         {"hinge_bend", "bending"},
                                                         {"facet_tension", "tension"}};
    const auto parts = shape_terms(reference.system).energies(reference.system);
    ASSERT_EQ(parts.size(), 4u);
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_EQ(parts[k].first, names[k].first);
      const double energy = expected[names[k].second];
      EXPECT_NEAR(parts[k].second, energy, 1e-12 * energy) << name << ": " << names[k].second;
      sum += energy;
    }
    EXPECT_NEAR(fast(reference.system).energy.terms, sum, 1e-13 * sum) << name;
    expect_equals_terms(reference.system);
  }
}

TEST(SurfaceShape, IsAtRestWhereTheReferencesAre) {
  for (const char* name : {"single_shell_42", "single_droplet_42", "single_floppy_42"}) {
    const testing::SurfaceReference reference = testing::read_surfaces(name);
    const Evaluation<3> out = fast(reference.system);
    const double energy = reference.expected()["energy"];
    EXPECT_NEAR(out.energy.terms, energy, 1e-13 * energy + 1e-28) << name;
    EXPECT_LT(largest(out.force), 1e-14) << name;
  }
}

}  // namespace
}  // namespace supple
