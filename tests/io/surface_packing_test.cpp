/// Packings of triangulated surfaces and spheres as JSON, and those that an independent program evaluated.
#include <gmock/gmock.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>

#include "supple/build/surfaces.hpp"
#include "supple/contact/rough_contacts.hpp"
#include "supple/contact/smooth_surfaces.hpp"
#include "supple/force/force_field.hpp"
#include "supple/force/shape_terms.hpp"
#include "supple/geometry/mesh_measures.hpp"
#include "tests/io/same_system.hpp"
#include "tests/io/temporary_folder.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/random_surfaces.hpp"
#include "tests/support/surface_reference.hpp"

namespace supple {
namespace {

using namespace supple::testing;
using ::testing::HasSubstr;

// What the reader finds in the references is right.

ForceField<3> field_of(const StoredPackingOf<3>& packing) {
  const bool smooth = std::get<std::string>(packing.keys.at("contact.kind")) == "smooth";
  ForceField<3> field = smooth ? ForceField<3>(SmoothSurfaces(packing.contact))
                               : ForceField<3>(RoughContacts<3>(packing.contact));
  field.terms() = shape_terms(packing.system);
  return field;
}

/// Energies by term, forces and stress.
TEST(SurfacePacking, ReferencesHaveTheirEnergiesForcesAndStress) {
  for (const char* name : {"shells4_12_rough", "shells4_42_rough", "shells4_42_smooth"}) {
    SCOPED_TRACE(name);
    const nlohmann::json expected = nlohmann::json::parse(std::ifstream(reference_path(name))).at("expected");
    StoredPackingOf<3> packing = read_packing_json<3>(reference_path(name));
    System<3>& system = packing.system;
    EXPECT_GT(system.box.strain, 0.1) << "the cell leans";
    ForceField<3> field = field_of(packing);
    Evaluation<3> out;
    field.evaluate(system, Detail::energies, out);
    const auto parts = shape_terms(system).energies(system);
    const char* of_file[] = {"volume", "area", "bending", "tension"};
    ASSERT_EQ(parts.size(), 4u);
    for (std::size_t k = 0; k < 4; ++k) {
      const double energy = expected["energy"][of_file[k]];
      EXPECT_NEAR(parts[k].second, energy, 1e-10 * energy) << of_file[k];
    }
    const double contact = expected["energy"]["contact"];
    EXPECT_NEAR(out.energy.elastic, contact, 1e-10 * contact);
    const std::vector<Vec3> force = vectors_of(expected["force"]), stress = vectors_of(expected["stress"]);
    double largest = 0, tallest = 0;
    for (const Vec3& f : force) largest = std::max(largest, norm(f));
    for (const Vec3& row : stress) tallest = std::max(tallest, norm(row));
    ASSERT_EQ(force.size(), out.force.size());
    for (std::size_t i = 0; i < force.size(); ++i)
      EXPECT_LT(norm(out.force[i] - force[i]), 1e-10 * largest) << i;
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b)
        EXPECT_NEAR(out.virial[a][b] / system.box.volume(), stress[static_cast<std::size_t>(a)][b],
                    1e-10 * tallest)
            << a << b;
  }
}

/// A particle alone: its vertices in the file itself, no cell, no diameter, no contacts.
TEST(SurfacePacking, ASurfaceMayBeAlone) {
  for (const char* name : {"single_shell_42", "single_droplet_42", "single_floppy_42"}) {
    SCOPED_TRACE(name);
    const auto json = nlohmann::json::parse(std::ifstream(reference_path(name)));
    const StoredPackingOf<3> packing = read_packing_json<3>(reference_path(name));
    const System<3>& system = packing.system;
    double energy = 0;
    for (const auto& part : shape_terms(system).energies(system)) energy += part.second;
    const double expected = json["expected"]["energy"];
    EXPECT_NEAR(energy, expected, 1e-10 * expected + 1e-28);
    EXPECT_EQ(system.box.periodic, (std::array{false, false, false}));
    EXPECT_EQ(packing.environment.stands_in<3>(), (std::array<std::array<bool, 2>, 3>{})) << "no walls";
    EXPECT_EQ(2 * system.state.radius[7], mean_edge(mesh_of(system, 0)));
    for (int d = 0; d < 3; ++d) {
      EXPECT_GT(system.box.length[d], 1);
      EXPECT_LT(system.box.length[d], 2);
    }
    EXPECT_FALSE(packing.contact.relative);
  }
}

TEST(SurfacePacking, IsAStateToStartFrom) {
  const InitialState state = as_initial(read_any_packing_json(reference_path("shells4_12_rough")));
  EXPECT_EQ(body_count(state.system), 4);
  EXPECT_EQ(site_count(state.system), 48);
  EXPECT_TRUE(has_bodies(state.system));
  EXPECT_EQ(state.contact->stiffness, 1.3);
  EXPECT_EQ(state.units.name, reduced_units().name);
  expect_same(std::get<1>(as_packing(state)).system, system_of<3>(state));
  try {
    system_of<2>(state);
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::input);
    EXPECT_THAT(e.what(), HasSubstr("three dimensions (this is about particles in two)"));
  }
}

class SurfacePackingFile : public TemporaryFolder {
 protected:
  StoredPackingOf<3> rewritten(const StoredPackingOf<3>& packing) const {
    write_packing_json(packing, in_folder("packing.json"), Existing::replace);
    return read_packing_json<3>(in_folder("packing.json"));
  }
  StoredPackingOf<3> read(const std::string& text) const {
    write_content(in_folder("packing.json"), text);
    return read_packing_json<3>(in_folder("packing.json"));
  }
  /// What is written is read back: the same system to the last bit, laws and surroundings.
  void expect_kept(const StoredPackingOf<3>& packing) const {
    const StoredPackingOf<3> back = rewritten(packing);
    expect_same(back.system, packing.system);
    EXPECT_EQ(back.contact.stiffness, packing.contact.stiffness);
    EXPECT_EQ(back.contact.relative, packing.contact.relative);
    EXPECT_EQ(back.environment.stands, packing.environment.stands);
    EXPECT_EQ(back.environment.gravity, packing.environment.gravity);
    EXPECT_EQ(back.keys, packing.keys);
  }
  bool is_written_as(const std::string& text) const {
    return content_of(in_folder("packing.json")).find(text) != std::string::npos;
  }
};

StoredPackingOf<3> packing_with(const ShapeSpec& shape, double jitter = 0.03) {
  SurfaceDraw draw{.vertices = {12, 42, 12}, .seed = 3, .shape = shape, .jitter = jitter};
  StoredPackingOf<3> packing{random_surfaces(draw), {1.5, true}, {}, {}};
  packing.system.pairs = {};
  packing.system.pairs.width = 0;
  return packing;
}

TEST_F(SurfacePackingFile, EveryFamilyIsReadAsItIsWritten) {
  const ShapeSpec families[] = {
      {.area = 1, .length = 1, .bending = 0.01},                        // shells
      {.area = 1, .length = 0.1, .bending = 0, .tension = 0.1},         // droplets
      {.area = 1, .length = 1, .bending = 0, .shape_parameter = 1.04},  // floppy
      {1 / 3., 1 / 7., 0.1, 1 / 9.},                                    // numbers of many digits
      {.area = 1 / 3., .length = 0.7, .bending = 0.1, .kind = StiffnessKind::absolute},
  };
  for (const ShapeSpec& shape : families) {
    SCOPED_TRACE(&shape - families);
    StoredPackingOf<3> packing = packing_with(shape);
    packing.contact.relative = shape.kind == StiffnessKind::relative;
    expect_kept(packing);
    packing.system.box.strain = 0.1 / 3;  // a sheared cell
    packing.keys = {{"contact.kind", "smooth"}, {"motion.damping", 0.25}};
    expect_kept(packing);
  }
}

TEST_F(SurfacePackingFile, RelativeStiffnessesStayWhatTheyAreCalled) {
  expect_kept(packing_with({.area = 1, .length = 1, .bending = 0.01}));
  EXPECT_TRUE(is_written_as("\"k_v\": 1.0"));
  EXPECT_FALSE(is_written_as("absolute"));
  expect_kept(packing_with({.area = 0.7, .length = 1, .bending = 0, .kind = StiffnessKind::absolute}));
  EXPECT_TRUE(is_written_as("\"stiffness\": \"absolute\""));
}

TEST_F(SurfacePackingFile, HoldsMixedSizesSpheresWallsAndMotion) {
  StoredPackingOf<3> packing;
  System<3>& system = packing.system;
  system.box.length = {9, 7, 8};
  system.box.periodic = {false, true, false};
  const ShapeSpec small{.area = 1, .length = 2, .bending = 0.1},
      large{.area = 3, .length = 0.5, .tension = 0.2};
  RandomStream draw(4, Purpose::test);
  add_shaken(system, geodesic_icosahedron(42, 1), {2, 2, 2}, small, 0.05, draw);
  add_shaken(system, geodesic_icosahedron(12, 2.744), {5, 3, 4}, large, 0.05, draw);
  add_sphere_body(system, {1 / 3., 6, 7}, 1 / 7.);
  add_sphere_body(system, {8, 6, 7}, 0.2);
  add_surface(system, torus(8, 5), 0.7, small);  // of another genus
  system.shape.rest_facet[3] *= 1.5;             // flowed
  system.shape.rest_hinge[5] = -0.1;
  system.state.velocity[2] = {1 / 3., 0, -1};
  system.state.velocity[54] = {0, 0.1, 0};  // of a sphere
  system.species = {0, 1, 2, 2, 0};
  packing.environment.stands[2][1] = packing.environment.stands[0][0] = false;
  packing.keys[species_section(0) + ".name"] = "small";
  packing.keys[species_section(1) + ".name"] = "large";
  packing.keys[species_section(2) + ".name"] = "sphere";
  expect_kept(packing);
  EXPECT_TRUE(is_written_as("\"back\"")) << "this wall stands, the front does not";
  EXPECT_FALSE(is_written_as("\"front\""));

  system.box.periodic = {true, false, true};
  packing.environment.gravity = {0, -0.01, 0};
  expect_kept(packing);
}

TEST_F(SurfacePackingFile, SpheresNeedNoStiffness) {
  const StoredPackingOf<3> p = read(R"({"k_c": 2, "box": [4, 5, 6], "strain": 0.25, "particles": [
    {"sigma": 1, "x": [[1, 2, 3]]}, {"sigma": 1.4, "x": [[3, 2, 3]], "v": [[0, 1, 0]]}]})");
  EXPECT_EQ(p.system.box.length, (Vec3{4, 5, 6}));
  EXPECT_EQ(p.system.box.strain, 0.25);
  EXPECT_EQ(p.system.state.radius, (std::vector<double>{0.5, 0.7}));
  EXPECT_EQ(p.system.state.position[1], (Vec3{3, 2, 3}));
  EXPECT_EQ(p.system.state.velocity[1], (Vec3{0, 1, 0}));
  EXPECT_TRUE(p.contact.relative);
  expect_kept(p);
}

TEST_F(SurfacePackingFile, TheColumnsOfABoxAreItsPeriods) {
  const auto box_of = [&](const std::string& box) {
    return read("{\"k_c\": 2, \"box\": " + box + R"(, "particles": [{"sigma": 1, "x": [[1, 2, 3]]}]})")
        .system.box;
  };
  const Box<3> box = box_of("[[4, 0.5, 0], [0, 5, 0], [0, 0, 6]]");
  EXPECT_EQ(box.length, (Vec3{4, 5, 6}));
  EXPECT_EQ(box.strain, 0.1);
  EXPECT_EQ(box.lattice().vector({0, 1, 0}), (Vec3{0.5, 5, 0}));
  EXPECT_EQ(box_of("4").length, (Vec3{4, 4, 4}));
  EXPECT_EQ(box_of("[[4, 0, 0], [0, 5, 0], [0, 0, 6]]").strain, 0);
}

TEST_F(SurfacePackingFile, PreferredShapesAreOfTrianglesAndEdges) {
  const StoredPackingOf<3> p = read(R"({"k_v": 2, "k_a": 3, "k_b": 0.5, "gamma": 0.4, "k_c": 1, "box": 4,
    "particles": [{"sigma": 0.5, "v0": 2, "a0": [1, 2, 3, 4], "theta0": [0.1, 0.2, 0.3, 0.4, 0.5, 0.6],
    "edges": [[3, 2], [0, 1], [1, 2], [3, 0], [0, 2], [1, 3]],
    "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]],
    "faces": [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]}]})");
  const System<3>& s = p.system;
  const ShapeStiffness& k = s.shape.stiffness[0];
  EXPECT_DOUBLE_EQ(k.volume, 2 / 4.);
  EXPECT_DOUBLE_EQ(k.facet, 3 / (2.5 * 2.5));
  EXPECT_DOUBLE_EQ(k.hinge, 0.5);
  EXPECT_DOUBLE_EQ(k.tension, 0.4 / 10);
  EXPECT_EQ(s.shape.rest_volume, std::vector<double>{2});
  EXPECT_EQ(s.shape.rest_facet, (std::vector<double>{1, 2, 3, 4}));
  const std::map<std::array<std::int32_t, 2>, double> angle{{{0, 1}, 0.2}, {{1, 2}, 0.3}, {{0, 2}, 0.5},
                                                            {{0, 3}, 0.4}, {{1, 3}, 0.6}, {{2, 3}, 0.1}};
  ASSERT_EQ(s.topology.hinge.size(), 6u);
  for (std::size_t h = 0; h < 6; ++h) {
    const auto& hinge = s.topology.hinge[h];
    EXPECT_EQ(s.shape.rest_hinge[h], angle.at({std::min(hinge[0], hinge[1]), std::max(hinge[0], hinge[1])}));
  }
}

TEST_F(SurfacePackingFile, WhatTheLayoutCannotHoldIsRefused) {
  const auto refused = [&](auto&& change) -> std::string {
    StoredPackingOf<3> packing = packing_with({});
    change(packing.system);
    try {
      write_packing_json(packing, in_folder("refused.json"));
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), ErrorKind::input);
      EXPECT_EQ(files(), 0u);
      return e.what();
    }
    return "";
  };
  using S = System<3>;
  EXPECT_THAT(refused([](S& s) { s.terms.push_back({"bulge", 1, {1}}); }), HasSubstr("no bulge of surfaces"));
  EXPECT_THAT(refused([](S& s) { s.state.radius[1] *= 2; }), HasSubstr("different sizes"));
  EXPECT_THAT(refused([](S& s) { s.shape = {}; }), HasSubstr("no preferred shapes"));
  EXPECT_THAT(refused([](S& s) { s.links.resize(1); }), HasSubstr("no links"));
}

// Bad files.

/// The example of the document.
TEST_F(SurfacePackingFile, TheDocumentHasAnExample) {
  const std::string text = content_of(std::string(SUPPLE_SOURCE_DIR) + "/docs/packing_json.md");
  const std::string heading = "## Surfaces and a sphere in a sheared cell\n", fence = "```json\n";
  const auto at = text.find(heading);
  ASSERT_NE(at, std::string::npos);
  const auto begin = text.find(fence, at) + fence.size();
  const StoredPackingOf<3> packing = read(text.substr(begin, text.find("```", begin) - begin));
  ASSERT_EQ(body_count(packing.system), 3);
  EXPECT_EQ(packing.system.box.strain, 0.125);
  EXPECT_EQ(packing.system.topology.body_size(2), 1);
  EXPECT_NEAR(shape_terms(packing.system).energies(packing.system)[0].second, 0, 1e-8) << "at its volume";
  expect_kept(packing);
}

}  // namespace
}  // namespace supple
