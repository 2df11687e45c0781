#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <numeric>

#include "supple/contact/rough_contacts.hpp"
#include "supple/force/surface_shape.hpp"
#include "supple/solve/body_objective.hpp"
#include "tests/support/surface_reference.hpp"

namespace supple {
namespace {

ForceField<3> rough_field(const Harmonic& law) {
  ForceField<3> field{RoughContacts<3>(law)};
  field.terms().add(std::make_shared<SurfaceShape>());
  return field;
}

double shape_parameter(const System<3>& system) {
  TriangleMesh mesh{system.state.position, system.topology.facet};
  const std::vector<double> areas = face_areas(mesh);
  return surface_shape_parameter(std::accumulate(areas.begin(), areas.end(), 0.0), enclosed_volume(mesh));
}

MinimiseReport relax(System<3>& system, ForceField<3>& field, Minimiser method = Minimiser::automatic) {
  BodyObjective<3> objective(system, field, {1e-12, 1e-13});
  std::vector<double> x = objective.coordinates();
  MinimiseSpec spec;
  spec.method = method;
  return minimise(objective, x, spec);
}

/// [deformable.md, section 1]: under surface tension geodesic spheres relax to 1.0984, 1.0235 and 1.0058.
TEST(RelaxedSurfaces, HaveTheShapeParametersOfLeastArea) {
  for (const auto& [vertices, expected] : {std::pair{12, 1.0984}, {42, 1.0235}, {162, 1.0058}})
    for (const Minimiser method : {Minimiser::automatic, Minimiser::fire}) {
      System<3> system;
      system.box.length = {9, 9, 9};
      ShapeSpec spec{.area = 1, .length = 0, .bending = 0, .tension = 0.3};
      add_surface(system, geodesic_icosahedron(vertices), 1, spec);
      ForceField<3> field = rough_field({1, true});
      const MinimiseReport report = relax(system, field, method);
      EXPECT_TRUE(report.converged) << report.reason << ", " << report.residual;
      EXPECT_NEAR(shape_parameter(system), expected, 5e-5) << vertices;
    }
}

/// Four particles in a sheared cell, by an independent program: energies by term, forces and stress.
TEST(RelaxedSurfaces, RoughPackingsAreThoseOfTheReference) {
  for (const char* name : {"shells4_12_rough", "shells4_42_rough"}) {
    testing::SurfaceReference reference = testing::read_surfaces(name);
    System<3>& system = reference.system;
    ForceField<3> field = rough_field({reference.stiffness("k_c"), false});
    Evaluation<3> out;
    field.evaluate(system, Detail::energies, out);
    const auto& energy = reference.expected().at("energy");
    EXPECT_NEAR(out.energy.elastic, energy.at("contact"), 1e-10 * out.energy.elastic);
    double shape = 0, largest = 0;
    for (const char* part : {"volume", "area", "bending", "tension"}) shape += energy.at(part).get<double>();
    EXPECT_NEAR(out.energy.terms, shape, 1e-10 * shape);
    const std::vector<Vec3> force = testing::vectors_of(reference.expected().at("force"));
    for (const Vec3& f : force) largest = std::max(largest, norm(f));
    ASSERT_EQ(force.size(), out.force.size());
    for (std::size_t i = 0; i < force.size(); ++i)
      EXPECT_LT(norm(out.force[i] - force[i]), 1e-10 * largest) << name << ", site " << i;
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t d = 0; d < 3; ++d)
        EXPECT_NEAR(out.virial[c][d] / system.box.volume(), reference.expected().at("stress")[c].at(d),
                    1e-10 * largest)
            << name << c << d;
  }
}

}  // namespace
}  // namespace supple
