/// Energies of whole bodies that stand in the system.
#include "supple/force/body_terms.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "supple/contact/rough_contacts.hpp"
#include "supple/core/error.hpp"
#include "supple/energy/enclosed_volume.hpp"
#include "supple/energy/perimeter.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/force/force_field.hpp"
#include "supple/model/polygons.hpp"
#include "supple/observe/shape_measures.hpp"
#include "tests/support/field_check.hpp"
#include "tests/support/polygons.hpp"

namespace supple {
namespace {

ForceField<2> field_of_terms() {
  ForceField<2> field(RoughContacts<2>(Harmonic{1, true}));
  field.terms().add(std::make_shared<BodyTermSet<2>>());
  return field;
}

/// dU/dR = k (p - p0) dp/dR of a regular polygon with p = 2 n R sin(pi/n), shared by its n vertices.
TEST(BodyTerms, ARegularPolygonIsPulledToItsPerimeter) {
  const int n = 7;
  System<2> system;
  system.box.length = {20, 20};
  add_polygon(system, {30, -4}, 2, n, 0.2, 1, {.area = 0, .length = 0});
  const double k = 0.7, rest = 3;
  set_body_term(system.terms, Perimeter::name, 0, std::array{k, rest});
  ForceField<2> field = field_of_terms();
  Evaluation<2> out;
  field.evaluate(system, Detail::energies, out);
  const double radius = norm(system.state.position[0] - Vec2{30, -4}),
               per_radius = 2 * n * std::sin(std::numbers::pi / n), p = per_radius * radius;
  EXPECT_NEAR(out.energy.terms, 0.5 * k * (p - rest) * (p - rest), 1e-13);
  for (int i = 0; i < n; ++i) {
    const Vec2 outward = (1 / radius) * (system.state.position[i] - Vec2{30, -4});
    EXPECT_NEAR(dot(out.force[i], outward), -k * (p - rest) * per_radius / n, 1e-13);
    EXPECT_NEAR(cross(out.force[i], outward), 0, 1e-13);
  }
  // Of an isotropic strain e, dp = p e: the trace of the virial is -k (p - p0) p.
  EXPECT_NEAR(out.virial[0][0] + out.virial[1][1], -k * (p - rest) * p, 1e-12);
}

TEST(BodyTerms, HaveTheSlopesThatTheirEnergySays) {
  System<2> system = testing::random_polygons({.bodies = 4});
  for (const int b : {0, 2, 3}) {
    set_body_term(system.terms, Perimeter::name, b, std::array{0.4 + b, 3.0 + b});
    set_body_term(system.terms, EnclosedVolume::name, b, std::array{0.3 + b, 1.0});
  }
  ForceField<2> field = field_of_terms();
  testing::FieldCheck(field, system).run();
}

TEST(BodyTerms, ActOnlyWhereTheyHaveNumbers) {
  System<2> system = testing::random_polygons({.bodies = 3});
  set_body_term(system.terms, Perimeter::name, 1, std::array{1.0, 0.5});
  Evaluation<2> out;
  out.force.resize(system.state.size());
  BodyTermSet<2>().evaluate(system, Detail::forces, out);
  const std::vector<std::int32_t>& begin = system.topology.begin;
  for (int i = 0; i < system.state.size(); ++i)
    EXPECT_EQ(norm(out.force[i]) > 0, begin[1] <= i && i < begin[2]) << i;
}

TEST(BodyTerms, OfNoKnownNameAreRefused) {
  System<2> system = testing::random_polygons({.bodies = 2});
  set_body_term(system.terms, "charm", 0, std::array{1.0});
  Evaluation<2> out;
  out.force.resize(system.state.size());
  EXPECT_THROW(BodyTermSet<2>().evaluate(system, Detail::forces, out), Error);
  system.terms[0].name = Perimeter::name;
  EXPECT_THROW(BodyTermSet<2>().evaluate(system, Detail::forces, out), Error);
}

/// Without stiffness of their edges particles keep the perimeter alone, and share it out as they like.
TEST(BodyTerms, AStiffPerimeterIsKeptInAJam) {
  Case c;
  c.general.experiment = "jamming";
  c.bodies.count = 8;
  c.bodies.vertices = 12;
  c.bodies.size_ratio = 1.2;
  c.jamming.packing_fraction = 0.4;
  c.jamming.pressure = 1e-2;
  resolve_family(c);
  const auto excess = [&](double k) {
    c.bodies.k_perimeter = k;
    MemoryRecorder recorder;
    run(c, nullptr, recorder);
    EXPECT_NEAR(recorder.get("results", "pressure"), 1e-2, 1.1e-4);
    const System<2>& s = recorder.last_system;
    EXPECT_EQ(s.terms.size(), k > 0 ? 1u : 0u);
    const std::vector<double> perimeter = measure_shapes(s).surface;
    double largest = 0;
    for (std::size_t b = 0; b < perimeter.size(); ++b) {
      double rest = 0;
      for (int f = s.topology.facet_begin[b]; f < s.topology.facet_begin[b + 1]; ++f)
        rest += s.shape.rest_facet[f];
      largest = std::max(largest, std::abs(perimeter[b] / rest - 1));
    }
    return largest;
  };
  EXPECT_LT(excess(1000), 0.1 * excess(0));
}

}  // namespace
}  // namespace supple
