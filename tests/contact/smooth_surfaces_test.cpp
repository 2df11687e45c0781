#include "supple/contact/smooth_surfaces.hpp"

#include <gmock/gmock.h>

#include "supple/core/error.hpp"
#include "supple/core/parallel.hpp"
#include "supple/force/shape_terms.hpp"
#include "tests/support/all_images.hpp"
#include "tests/support/corner_meshes.hpp"
#include "tests/support/field_check.hpp"
#include "tests/support/surface_reference.hpp"

namespace supple {
namespace {

using namespace testing;

/// The surface moved by `by`, vertices of this radius, without shape energy.
void add_mesh(System<3>& system, TriangleMesh mesh, const Vec3& by, double radius) {
  for (Vec3& x : mesh.vertex) x += by;
  add_surface(system, mesh, radius, {}, 1, std::vector<double>(mesh.face.size(), 1),
              std::vector<double>(mesh.face.size() * 3 / 2, 1));
}

/// Spiky bodies of radius 1 on a jittered lattice in a sheared periodic cell, with spheres between them. They
/// reach into each other, and stick out of the cell.
System<3> crowd(std::uint64_t seed, int rows = 2, int vertices = 42, double spacing = 1.95) {
  System<3> system;
  system.box.length = {rows * spacing, rows * spacing * 1.05, rows * spacing * 1.1};
  system.box.strain = 0.13;
  RandomStream draw(seed, Purpose::test);
  for (int b = 0; b < rows * rows * rows; ++b) {
    const Vec3 centre{b % rows * spacing + 0.1 * draw.uniform(-1, 1),
                      b / rows % rows * spacing * 1.05 + 0.1 * draw.uniform(-1, 1),
                      b / rows / rows * spacing * 1.1 + 0.1 * draw.uniform(-1, 1)};
    add_mesh(system, star_mesh(vertices, 0.25, seed + static_cast<std::uint64_t>(b)), centre, 0.15);
    if (b % 3 == 0) add_sphere_body(system, centre + Vec3{1.1, 0.7, 0.9}, 0.4);
    if (b % 3 == 1) add_sphere_body(system, centre + Vec3{1.1, 0.8, 1.4}, 0.35);
    if (b % 3 == 1) add_sphere_body(system, centre + Vec3{1.2, 0.8, 0.9}, 0.3);
  }
  return system;
}

TEST(SmoothSurfaces, ForceFieldHoldsWhatEveryFieldMust) {
  int faces = 0, edges = 0, corners = 0, negative = 0, inside = 0, spheres = 0;
  for (const std::uint64_t seed : {1, 2}) {
    SCOPED_TRACE(seed);
    System<3> system = crowd(seed, 2, seed == 1 ? 12 : 42);
    auto contacts = std::make_shared<SmoothSurfaces>(Harmonic{2, seed % 2 == 0});
    ForceField<3> field(*contacts);
    FieldCheck(field, system).run();
    for (const auto& r : contacts->records(system)) {
      faces += r.sites == 4;
      edges += r.sites == 3;
      corners += r.sites == 2 && r.row < 0;
      spheres += r.row >= 0;
      negative += r.multiplicity < 0;
      inside += r.distance() < 0;
    }
  }
  EXPECT_GT(faces, 40);
  EXPECT_GT(edges, 20);
  EXPECT_GT(corners, 10);
  EXPECT_GE(negative, 1);
  EXPECT_GE(inside, 2);
  EXPECT_GE(spheres, 2);
}

/// Energy, forces and stress of an independent program, by faces minus edges plus vertices; the latter two
/// include those of the shapes.
TEST(SmoothSurfaces, AgreeWithAnIndependentProgram) {
  SurfaceReference reference = read_surfaces("shells4_42_smooth");
  System<3>& system = reference.system;
  ForceField<3> field(SmoothSurfaces(Harmonic{reference.stiffness("k_c")}));
  field.terms() = shape_terms(system);
  Evaluation<3> out;
  field.evaluate(system, Detail::energies, out);
  const double energy = reference.expected().at("energy").at("contact");
  EXPECT_NEAR(out.energy.elastic, energy, 1e-10 * energy);
  const std::vector<Vec3> force = vectors_of(reference.expected().at("force")),
                          stress = vectors_of(reference.expected().at("stress"));
  ASSERT_EQ(force.size(), out.force.size());
  for (std::size_t i = 0; i < force.size(); ++i) EXPECT_LT(norm(out.force[i] - force[i]), 1e-10);
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b)
      EXPECT_NEAR(out.virial[a][b] / system.box.volume(), stress[static_cast<std::size_t>(a)][b], 1e-10);
  EXPECT_EQ(field.bodies()->feature_violations(), 0);
  EXPECT_GT(field.bodies()->records(system).size(), 20u);
}

TEST(SmoothSurfaces, FastLoopEqualsItsRecordsAndItsTouches) {
  System<3> system = crowd(5, 3);
  auto contacts = std::make_shared<SmoothSurfaces>(Harmonic{1.5, true});
  ForceField<3> field(*contacts);
  Evaluation<3> fast, slow;
  field.evaluate(system, Detail::energies, fast);
  slow.force.resize(fast.force.size());
  slow.torque.resize(fast.force.size());
  const auto records = contacts->records(system);
  ASSERT_GT(records.size(), 200u);
  evaluate_conservative(records, contacts->laws(), slow);
  EXPECT_NEAR(fast.energy.elastic, slow.energy.elastic, 1e-13 * slow.energy.elastic);
  for (std::size_t i = 0; i < fast.force.size(); ++i) EXPECT_LT(norm(fast.force[i] - slow.force[i]), 1e-13);
  for (int c = 0; c < 3; ++c)
    for (int d = 0; d < 3; ++d) EXPECT_NEAR(fast.virial[c][d], slow.virial[c][d], 1e-12);

  double energy = 0;
  std::size_t summed = 0, most = 0;
  std::vector<std::array<std::int32_t, 2>> who;
  for (const auto& touch : sum_touches(system, records, contacts->laws())) {
    energy += touch.energy;
    summed += touch.records;
    most = std::max<std::size_t>(most, touch.records);
    const int begin = system.topology.begin[touch.body], end = system.topology.begin[touch.body + 1];
    EXPECT_FALSE(begin <= touch.site && touch.site < end) << "a body touches itself";
    who.push_back({touch.site, touch.body});
  }
  EXPECT_NEAR(energy, fast.energy.elastic, 1e-12 * energy);
  EXPECT_EQ(summed, records.size());
  EXPECT_GT(most, 2u) << "no concave corner";
  std::sort(who.begin(), who.end());
  EXPECT_EQ(std::adjacent_find(who.begin(), who.end()), who.end()) << "a vertex touches a body twice";
}

TEST(SmoothSurfaces, GiveTheSameBitsForAnyNumberOfThreads) {
  System<3> system = crowd(6, 4, 162);
  for (int k = 0; k < 2000; ++k)
    add_sphere_body(system, {0.5 + 0.61 * (k % 13), 0.4 + 0.7 * (k / 13 % 13), 0.3 + 0.62 * (k / 169)}, 0.34);
  ForceField<3> field(SmoothSurfaces(Harmonic{1.5, true}));
  Evaluation<3> one, more;
  field.evaluate(system, Detail::energies, one);
  const int violations = field.bodies()->feature_violations();
  for (const int threads : {2, 3}) {
    const WithThreads some(threads);
    field.evaluate(system, Detail::energies, more);
    EXPECT_EQ(one.force, more.force);
    EXPECT_EQ(one.energy.elastic, more.energy.elastic);
    for (int i = 0; i < 9; ++i) EXPECT_EQ(one.virial[i / 3][i % 3], more.virial[i / 3][i % 3]);
    EXPECT_EQ(field.bodies()->feature_violations(), violations);
  }
  int spheres = 0, others = 0;
  for (const auto& r : field.bodies()->records(system)) (r.row >= 0 ? spheres : others) += 1;
  EXPECT_GT(spheres, 4 * chunk_size);  // or they would not be shared
  EXPECT_GT(others, 4 * chunk_size);
}

TEST(SmoothSurfaces, PushNoBodyRound) {
  System<3> system = crowd(7, 2);
  system.box.periodic = {false, false, false};
  ForceField<3> field(SmoothSurfaces(Harmonic{1}));
  Evaluation<3> out;
  field.evaluate(system, Detail::energies, out);
  Vec3 torque{};
  double scale = 0;
  for (int i = 0; i < system.state.size(); ++i) {
    torque += cross(system.state.position[i], out.force[i]);
    scale += norm(system.state.position[i]) * norm(out.force[i]);
  }
  EXPECT_GT(scale, 1);
  EXPECT_LT(norm(torque), 1e-14 * scale);
}

/// The same bits from a list that has seen many small moves and from a fresh one.
TEST(SmoothSurfaces, DoNotDependOnWhenTheListWasBuilt) {
  System<3> system = crowd(9, 2);
  ForceField<3> field(SmoothSurfaces(Harmonic{1}));
  RandomStream draw(9, Purpose::test);
  Evaluation<3> kept, fresh;
  int differ = 0;
  for (int step = 0; step < 100; ++step) {
    for (Vec3& x : system.state.position)
      x += Vec3{draw.uniform(-0.005, 0.005), draw.uniform(-0.005, 0.005), draw.uniform(-0.005, 0.005)};
    system.box.strain += 3e-4;
    field.evaluate(system, Detail::energies, kept);
    System<3> copy = system;
    copy.pairs.clear();
    ForceField<3> anew(SmoothSurfaces(Harmonic{1}));
    anew.evaluate(copy, Detail::energies, fresh);
    ASSERT_EQ(kept.force, fresh.force) << "step " << step;
    ASSERT_EQ(kept.energy.elastic, fresh.energy.elastic);
    ASSERT_EQ(kept.virial[0][1], fresh.virial[0][1]);
    differ += copy.pairs.second != system.pairs.second;
  }
  EXPECT_GT(field.neighbors().builds(), 2);
  EXPECT_LT(field.neighbors().builds(), 50);
  EXPECT_GT(differ, 30) << "the lists were always the same";
}

/// A ball of 12 vertices and a sphere in a cell of any shape, any number of cells away, against all images in
/// the open.
TEST(SmoothSurfaces, SeeEveryImage) {
  double largest = 0;
  for (const double strain : {0.31, 0.5, -7.2})
    for (const Vec3& length : {Vec3{4.6, 4.6, 4.6}, Vec3{9, 4.6, 5}})
      for (const std::uint64_t seed : {1, 2}) {
        System<3> system;
        system.box.length = length;
        system.box.strain = strain;
        for (int b = 0; b < 4; ++b) {
          RandomStream draw(seed, Purpose::test, static_cast<std::uint64_t>(b));
          Vec3 centre;
          for (int d = 0; d < 3; ++d) centre[d] = draw.uniform(-3, 4) * length[d];
          if (b % 3 == 2) add_sphere_body(system, centre, draw.uniform(0.3, 0.5));
          else add_mesh(system, star_mesh(12, 0.2, seed), centre, 0.2);
        }
        System<3> open = with_all_images(system, 1);
        SmoothSurfaces contacts(Harmonic{3}), in_the_open(Harmonic{3});
        NeighborList<3> list(default_skin, contacts.meeting());
        list.update(system);
        NeighborList<3>(default_skin, contacts.meeting()).update(open);  // few rows instead of all pairs
        Evaluation<3> got, right;
        got.force.resize(system.state.position.size());
        right.force.resize(open.state.position.size());
        contacts.evaluate(system, Detail::forces, got);
        in_the_open.evaluate(open, Detail::forces, right);
        for (std::size_t i = 0; i < got.force.size(); ++i) {
          ASSERT_LT(norm(got.force[i] - right.force[i]), 1e-10 * (1 + norm(right.force[i])))
              << "strain " << strain << ", seed " << seed << ", site " << i;
          largest = std::max(largest, norm(right.force[i]));
        }
      }
  EXPECT_GT(largest, 0.5);
}

TEST(SmoothSurfaces, SpheresActOnSurfacesWithTheWholeLawAndAreNotActedOn) {
  System<3> system;
  system.box.length = {20, 20, 20};
  add_mesh(system, box_mesh({3, 3, 3}), {5, 5, 5}, 0.5);
  add_sphere_body(system, {6.2, 7.1, 8.6}, 0.5);
  ForceField<3> field(SmoothSurfaces(Harmonic{2}));
  Evaluation<3> out;
  field.evaluate(system, Detail::energies, out);
  EXPECT_NEAR(out.energy.elastic, 0.16, 1e-13);
  EXPECT_NEAR(out.force.back()[2], 0.8, 1e-13);
  EXPECT_NEAR(norm(out.force.back()), 0.8, 1e-13);
  system.state.position.back() = {5, 5, 8.6};  // over a vertex, which does not act on the sphere besides
  field.evaluate(system, Detail::energies, out);
  EXPECT_NEAR(out.energy.elastic, 0.16, 1e-13);
  add_sphere_body(system, {5, 5, 9.4}, 0.5);
  field.invalidate();
  field.evaluate(system, Detail::energies, out);
  EXPECT_NEAR(out.energy.elastic, 0.16 + 0.04, 1e-13);
  EXPECT_NEAR(out.force.back()[2], 0.4, 1e-13);
}

TEST(SmoothSurfaces, AVertexActsWithHalfTheLaw) {
  System<3> system;
  system.box.length = {20, 20, 20};
  add_mesh(system, box_mesh({3, 3, 3}), {5, 5, 5}, 0.5);
  TriangleMesh tip{{{0, 0, 0}, {1, 0, 3}, {-0.5, 0.8, 3}, {-0.5, -0.8, 3}},
                   {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}}};
  add_mesh(system, tip, {6.2, 7.1, 8.6}, 0.5);
  ForceField<3> field(SmoothSurfaces(Harmonic{2}));
  Evaluation<3> out;
  field.evaluate(system, Detail::energies, out);
  EXPECT_NEAR(out.energy.elastic, 0.08, 1e-13);
  EXPECT_NEAR(out.force[8][2], 0.4, 1e-13);
  EXPECT_EQ(field.bodies()->feature_violations(), 0);
  for (int i = 8; i < 12; ++i) system.state.position[i][2] -= 0.9;  // through the lid
  field.evaluate(system, Detail::energies, out);
  EXPECT_NEAR(out.force[8][2], 1.3, 1e-13) << "pushed out";
  const auto records = field.bodies()->records(system);
  EXPECT_TRUE(std::any_of(records.begin(), records.end(), [](const auto& r) { return r.distance() < 0; }));
}

TEST(SmoothSurfaces, CountVerticesInFrontOfWhatIsNoDisc) {
  System<3> system;
  system.box.length = {20, 20, 20};
  add_mesh(system, ell_mesh(), {5, 5, 5}, 0.25);
  add_sphere_body(system, {6.6, 7.4, 6.3}, 0.25);
  ForceField<3> field(SmoothSurfaces(Harmonic{2}));
  Evaluation<3> out;
  field.evaluate(system, Detail::forces, out);
  EXPECT_EQ(field.bodies()->feature_violations(), 1) << "both sides of the corner, but not yet the corner";
  system.state.position.back() = {6.7, 7.3, 6.3};
  field.evaluate(system, Detail::forces, out);
  EXPECT_EQ(field.bodies()->feature_violations(), 0);
}

TEST(SmoothSurfaces, RefuseABodyOfSeveralRadii) {
  System<3> system = crowd(1, 2, 12);
  system.state.radius[3] = 0.2;
  ForceField<3> field(SmoothSurfaces(Harmonic{1}));
  Evaluation<3> out;
  try {
    field.evaluate(system, Detail::forces, out);
    FAIL();
  } catch (const Error& e) {
    EXPECT_THAT(e.what(), ::testing::HasSubstr("the vertices of body 0 differ in radius"));
  }
}

/// A link replaces the contacts of either of its sites with the body of the other.
TEST(SmoothSurfaces, LeaveOutWhatIsLinked) {
  System<3> system;
  system.box.length = {20, 20, 20};
  add_mesh(system, box_mesh({3, 3, 3}), {5, 5, 5}, 0.5);
  add_sphere_body(system, {6.2, 7.1, 8.6}, 0.5);
  add_sphere_body(system, {6.2, 7.1, 9.4}, 0.5);
  ForceField<3> field(SmoothSurfaces(Harmonic{2}));
  Evaluation<3> out;
  field.evaluate(system, Detail::energies, out);
  EXPECT_NEAR(out.energy.elastic, 0.2, 1e-13);
  Link link{};
  link.first = 7;
  link.second = 8;
  system.links.push_back(link);
  field.evaluate(system, Detail::energies, out);
  EXPECT_NEAR(out.energy.elastic, 0.04, 1e-13) << "of the two spheres alone";
  EXPECT_EQ(field.bodies()->records(system).size(), 1u);
}

}  // namespace
}  // namespace supple
