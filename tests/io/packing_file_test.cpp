/// Packings as JSON, and a published kind of packing that an independent program has evaluated.
#include "supple/io/state/packing_file.hpp"

#include <gmock/gmock.h>

#include <Eigen/Dense>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>

#include "supple/contact/rough_contacts.hpp"
#include "supple/force/shape_terms.hpp"
#include "supple/io/state/state_file.hpp"
#include "supple/model/rigid.hpp"
#include "supple/observe/body_stress.hpp"
#include "supple/observe/contact_network.hpp"
#include "tests/io/same_system.hpp"
#include "tests/io/temporary_folder.hpp"
#include "tests/paths.hpp"
#include "tests/support/polygons.hpp"

namespace supple {
namespace {

using namespace supple::testing;
using ::testing::HasSubstr;

const std::string reference = std::string(SUPPLE_TEST_DATA) + "/packings/shells16_10_14.json";

/// The packing of the reference, evaluated, and what the file expects.
class ReferencePacking : public ::testing::Test {
 protected:
  ReferencePacking()
      : stored_(read_packing_json(reference)),
        system_(stored_.system),
        field_(polygon_field(RoughContacts<2>(stored_.contact))),
        expected_(nlohmann::json::parse(std::ifstream(reference)).at("expected")) {
    field_.evaluate(system_, Detail::energies, evaluation_);
    contacts_ = site_contacts(system_, field_.bodies()->records(system_), stored_.contact);
  }
  double energy(const char* name) const { return expected_.at("energy").at(name); }

  StoredPacking stored_;
  System<2> system_;
  ForceField<2> field_;
  nlohmann::json expected_;
  Evaluation<2> evaluation_;
  std::vector<SiteContact<2>> contacts_;
};

TEST_F(ReferencePacking, Energies) {
  // Edges and areas are within 1e-6 of their preferred ones, which the file has to 14 digits.
  const auto parts = shape_terms(system_).energies(system_);
  ASSERT_EQ(parts.size(), 3u);
  for (const auto& [part, name] : {std::pair{0, "area"}, {1, "edge"}, {2, "bend"}})
    EXPECT_NEAR(parts[part].second, energy(name), 1e-9 * energy(name)) << name;
  EXPECT_NEAR(evaluation_.energy.elastic, energy("contact"), 1e-9 * energy("contact"));
}

TEST_F(ReferencePacking, IsInEquilibrium) {
  double largest = 0;
  for (const Vec2& f : evaluation_.force) largest = std::max(largest, norm(f));
  EXPECT_NEAR(largest, expected_.at("max_force"), 1e-13) << "rounding of the stored digits";
}

TEST_F(ReferencePacking, Stress) {
  const BodyStresses<2> s = body_stresses(system_, field_, evaluation_);
  const double p = expected_.at("pressure"), p_contact = expected_.at("pressure_contact");
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) {
      EXPECT_NEAR(s.virial()[i][j], expected_.at("stress")[i][j], 1e-9 * p) << i << j;
      EXPECT_NEAR(s.contact[i][j], expected_.at("stress_contact")[i][j], 1e-9 * p_contact) << i << j;
    }
  EXPECT_NEAR(pressure(s.virial()), p, 1e-9 * p);
  EXPECT_NEAR(pressure(s.contact), p_contact, 1e-9 * p_contact);
}

TEST_F(ReferencePacking, Contacts) {
  const ContactNetwork network = contact_network(system_, contacts_);
  EXPECT_EQ(contacts_.size(), expected_.at("vertex_contacts"));
  EXPECT_EQ(network.pairs.size(), expected_.at("particle_contacts"));
  EXPECT_EQ(network.contacts_of_bodies(),
            expected_.at("contacts_per_particle").get<std::vector<std::int32_t>>());
}

TEST_F(ReferencePacking, Eigenvalues) {
  HessianBlocks<2> blocks;
  field_.add_hessian(system_, blocks);
  Eigen::MatrixXd h = Eigen::MatrixXd::Zero(2 * system_.state.size(), 2 * system_.state.size());
  for (const HessianBlock<2>& b : blocks)
    for (int c = 0; c < 2; ++c)
      for (int d = 0; d < 2; ++d) {
        h(2 * b.a + c, 2 * b.b + d) += b.h[c][d];
        if (b.a != b.b) h(2 * b.b + d, 2 * b.a + c) += b.h[c][d];
      }
  const Eigen::VectorXd found =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(h, Eigen::EigenvaluesOnly).eigenvalues();
  const auto expected = expected_.at("eigenvalues_by_differences").get<std::vector<double>>();
  ASSERT_EQ(static_cast<std::size_t>(found.size()), expected.size());
  // Differences of forces are good to 4e-10 of an eigenvalue, and to 3e-12 where it is small: among them five
  // zeros, two translations and a rattler of three degrees of freedom.
  for (std::size_t k = 0; k < expected.size(); ++k)
    EXPECT_NEAR(found(static_cast<Eigen::Index>(k)), expected[k], 3e-12 + 4e-10 * std::abs(expected[k])) << k;
}

class PackingFile : public TemporaryFolder {
 protected:
  StoredPacking rewritten(const StoredPacking& packing) const {
    write_packing_json(packing, in_folder("packing.json"), Existing::replace);
    return read_packing_json(in_folder("packing.json"));
  }
  StoredPacking read(const std::string& text) const {
    write_content(in_folder("packing.json"), text);
    return read_packing_json(in_folder("packing.json"));
  }
  /// The error of reading a small packing in which `from`, a regular expression, is replaced once.
  std::string error_with(const std::string& from, const std::string& to) const {
    const std::string text =
        std::regex_replace(small, std::regex(from), to, std::regex_constants::format_first_only);
    EXPECT_NE(text, small) << from;
    return file_error_of([&] { read(text); });
  }

  const std::string small = R"({"k_a": 1, "k_l": 2, "k_b": 0.5, "k_c": 3, "box": 10, "particles": [
  {"a0": 4, "sigma": 1, "l0": 2, "theta0": 0.5, "x": [[1, 1], [3, 1], [3, 3], [1, 3]]},
  {"a0": 2, "sigma": 0.5, "l0": 0.5, "theta0": 0, "x": [[9, 9], [11, 9], [10, 11]]}]})";
};

void expect_near_stiffness(const std::vector<ShapeStiffness>& a, const std::vector<ShapeStiffness>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k)
    for (auto part :
         {&ShapeStiffness::volume, &ShapeStiffness::facet, &ShapeStiffness::hinge, &ShapeStiffness::tension})
      EXPECT_NEAR(a[k].*part, b[k].*part, 1e-14 * std::abs(b[k].*part));
}

/// All but the stiffnesses bit for bit; those to rounding.
void expect_same_packing(StoredPacking a, const StoredPacking& b) {
  expect_near_stiffness(a.system.shape.stiffness, b.system.shape.stiffness);
  a.system.shape.stiffness = b.system.shape.stiffness;
  expect_same(a.system, b.system);
  EXPECT_EQ(a.contact.stiffness, b.contact.stiffness);
  EXPECT_EQ(a.contact.relative, b.contact.relative);
}

TEST_F(PackingFile, MeansWhatItSays) {
  const StoredPacking p = read(small);
  EXPECT_EQ(p.system.box.length, (Vec2{10, 10}));
  EXPECT_EQ(p.system.topology.begin, (std::vector<std::int32_t>{0, 4, 7}));
  EXPECT_EQ(p.system.state.position[5], (Vec2{11, 9}));
  EXPECT_EQ(p.system.state.radius[0], 0.5);
  EXPECT_EQ(p.system.state.radius[6], 0.25);
  expect_near_stiffness(p.system.shape.stiffness, {{1 / 16., 0.5, 0.5, 0}, {0.25, 8, 0.5, 0}});
  EXPECT_EQ(p.system.shape.rest_volume, (std::vector<double>{4, 2}));
  EXPECT_EQ(p.system.shape.rest_facet[6], 0.5);
  EXPECT_EQ(p.system.shape.rest_hinge[0], 0.5);
  EXPECT_EQ(p.contact.stiffness, 3);
  EXPECT_TRUE(p.contact.relative);
}

TEST_F(PackingFile, WhatIsWrittenIsReadBack) {
  const StoredPacking shells = read_packing_json(reference);
  expect_same_packing(rewritten(shells), shells);
  EXPECT_THAT(content_of(in_folder("packing.json")), HasSubstr("\"k_a\": 1.0"));

  PackingDraw draw;
  draw.shape = {1 / 3., 1 / 7., 0.1, 1 / 9.};
  StoredPacking droplets{
      random_polygons(draw), {1 / 3., false}, {}, {}};  // tension, a sheared cell that is not square
  add_disc_body(droplets.system, {1 / 3., 2}, 1 / 7.);
  droplets.system.box.periodic = {true, false};
  expect_same_packing(rewritten(droplets), droplets);

  draw.shape.kind = StiffnessKind::absolute;
  StoredPacking absolute{random_polygons(draw), {2, false}, {}, {}};
  absolute.system.shape.rest_facet[3] *= 1.5;  // plastic flow
  absolute.system.shape.rest_hinge[5] = -0.1;
  expect_same_packing(rewritten(absolute), absolute);

  draw.shape.kind = StiffnessKind::relative;
  draw.bodies = 1;
  StoredPacking flowed{random_polygons(draw), {}, {}, {}};
  flowed.system.shape.rest_facet[3] *= 1.5;
  expect_same_packing(rewritten(flowed), flowed);
}

TEST_F(PackingFile, WhatTheLayoutCannotHoldIsRefused) {
  const auto refused = [&](auto&& change) -> std::string {
    StoredPacking packing{random_polygons(), {}, {}, {}};
    change(packing.system);
    try {
      write_packing_json(packing, in_folder("packing.json"));
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), ErrorKind::input);
      EXPECT_EQ(files(), 0u);
      return e.what();
    }
    return "";
  };
  using S = System<2>;
  EXPECT_THAT(refused([](S& s) {
                s.terms.push_back({"bulge", 1, {1}});
              }),
              HasSubstr("the layout has no bulge"));
  EXPECT_THAT(refused([](S& s) { s.state.radius[1] *= 2; }), HasSubstr("different sizes"));
  EXPECT_THAT(refused([](S& s) { s.shape = {}; }), HasSubstr("no preferred shapes"));
}

TEST_F(PackingFile, ErrorsSayFileParticleAndWhat) {
  EXPECT_THAT(file_error_of([&] { read_packing_json(in_folder("none.json")); }), HasSubstr("No such file"));
  EXPECT_THAT(file_error_of([&] { read(small.substr(0, 100)); }),
              HasSubstr("as a packing (it ends too early"));
  EXPECT_THAT(error_with("\"k_b\": 0.5, ", ""), HasSubstr("packing.json has no \"k_b\""));
  EXPECT_THAT(error_with("\"k_l\": 2", "\"k_l\": -2"), HasSubstr("packing.json: k_l is negative"));
  EXPECT_THAT(error_with("\"box\": 10", "\"box\": 0"), HasSubstr("box is 0, not positive"));
  EXPECT_THAT(error_with("\"box\": 10", "\"box\": [10, -1]"), HasSubstr("box is not positive"));
  EXPECT_THAT(error_with("\"box\": 10", "\"box\": [10]"), HasSubstr("box is not two numbers"));
  EXPECT_THAT(error_with("\"box\"", "\"stiffness\": \"soft\", \"box\""),
              HasSubstr("\"soft\", not relative or absolute"));
  EXPECT_THAT(error_with("\"box\"", "\"periodic\": [1, 0], \"box\""),
              HasSubstr("periodic[0] is not true or false"));
  EXPECT_THAT(error_with("\"a0\": 2, ", ""), HasSubstr("packing.json: particles[1] has no \"a0\""));
  EXPECT_THAT(error_with("\"a0\": 2", "\"a0\": 0"), HasSubstr("particles[1].a0 is 0, not positive"));
  EXPECT_THAT(error_with("\"l0\": 0.5", "\"l0\": 0"), HasSubstr("particles[1].l0 is not positive"));
  EXPECT_THAT(error_with("\"l0\": 0.5", "\"l0\": [1, 1, 1]"), HasSubstr("particles[1].l0 is a list"));
  EXPECT_THAT(error_with("\"theta0\": 0,", "\"theta0\": [1, 2],"),
              HasSubstr("theta0 has 2 numbers for 3 vertices"));
  EXPECT_THAT(error_with("\"sigma\": 0.5", "\"sigma\": \"x\""),
              HasSubstr("particles[1].sigma is not a number"));
  EXPECT_THAT(error_with(", \\[10, 11\\]", ""), HasSubstr("particles[1].x has 2 vertices"));
  EXPECT_THAT(error_with("\\[10, 11\\]", "[10]"), HasSubstr("particles[1].x[2] is not two numbers"));
  EXPECT_THAT(error_with("\\[10, 11\\]", "[10, 7]"),
              HasSubstr("particles[1].x does not run counter-clockwise"));
  EXPECT_THAT(error_with("\\[11, 9\\]", "[1, 9]"), HasSubstr("particles[1].x[0] is more than half a cell"));
  EXPECT_THAT(error_with("\\[\\s*\\{[^]*$", "[]}"), HasSubstr("particles is empty"));
}

TEST_F(PackingFile, HoldsRigidBodiesWallsWeightMotionAndLaws) {
  StoredPacking p{random_polygons(), {2, true}, {}, {}};
  make_rigid(p.system, 1);
  p.system.rigid.angle[0] = 0.4;
  p.system.rigid.velocity[0] = {0.1, -0.2};
  p.system.rigid.spin[0] = 0.3;
  place_sites(p.system);
  p.system.state.velocity[0] = {0.5, 1 / 3.};
  p.system.box.periodic = {true, false};
  p.system.floor_contact.assign(p.system.state.position.size(), std::numeric_limits<double>::quiet_NaN());
  p.system.floor_contact[2] = 1 / 7.;
  p.environment.stands[gradient][1] = false;
  p.environment.gravity = {0, -0.01};
  p.keys = {{"contact.kind", "smooth"}, {"motion.damping", 0.25}, {"bodies.vertices", std::int64_t{7}}};
  const StoredPacking q = rewritten(p);
  ASSERT_EQ(q.system.rigid.body, p.system.rigid.body);
  EXPECT_EQ(q.system.rigid.begin, p.system.rigid.begin);
  EXPECT_NEAR(q.system.rigid.spin[0], 0.3, 1e-13);
  EXPECT_NEAR(norm(q.system.rigid.velocity[0] - p.system.rigid.velocity[0]), 0, 1e-15);
  EXPECT_NEAR(q.system.rigid.inertia[0], p.system.rigid.inertia[0], 1e-13 * p.system.rigid.inertia[0]);
  for (std::size_t i = 0; i < p.system.state.position.size(); ++i) {
    EXPECT_NEAR(norm(q.system.state.position[i] - p.system.state.position[i]), 0, 1e-14) << i;
    EXPECT_NEAR(norm(q.system.state.velocity[i] - p.system.state.velocity[i]), 0, 1e-14) << i;
  }
  EXPECT_EQ(q.system.shape.rest_volume, p.system.shape.rest_volume);
  EXPECT_EQ(q.system.floor_contact[2], 1 / 7.);
  EXPECT_TRUE(std::isnan(q.system.floor_contact[1]));
  EXPECT_EQ(q.environment.stands, p.environment.stands);
  EXPECT_EQ(q.environment.gravity, p.environment.gravity);
  EXPECT_EQ(q.keys, (HeldKeys{{"contact.kind", "smooth"}, {"motion.damping", 0.25}})) << "laws alone";
}

TEST_F(PackingFile, UnknownKeysAndOtherFilesAreErrors) {
  EXPECT_THAT(error_with("\"box\": 10", "\"box\": 10, \"perodic\": [true, false]"),
              HasSubstr("has an unknown key \"perodic\"; did you mean \"periodic\"?"));
  EXPECT_THAT(error_with("\"sigma\": 0.5", "\"sigma\": 0.5, \"theta\": 1"),
              HasSubstr("particles[1] has an unknown key \"theta\"; did you mean \"theta0\"?"));
  EXPECT_THAT(error_with("\"box\": 10", "\"box\": 10, \"walls\": [\"top\"]"), HasSubstr("not one of"));
  EXPECT_THAT(error_with("\"box\": 10", "\"box\": 10, \"gravity\": 1"), HasSubstr("periodic along y"));
  EXPECT_THAT(error_with("\"box\": 10", "\"box\": 10, \"case\": {\"contact.knd\": \"smooth\"}"),
              HasSubstr("did you mean 'kind'"));
  EXPECT_THAT(file_error_of([&] { read("{\"params\": {}, \"initial\": {}}"); }), HasSubstr("initial.state"));
  write_content(in_folder("p.json"), small);
  EXPECT_THAT(file_error_of([&] { read_state(in_folder("p.json")); }), HasSubstr("initial.packing"));
}

TEST_F(PackingFile, RingsThatCrossThemselvesAreErrors) {
  EXPECT_THAT(error_with("\\[3, 3\\], \\[1, 3\\]", "[1, 3], [2.9, 3.1]"),
              HasSubstr("particles[0].x crosses itself: the edges after vertices 1 and 3"));
  // A figure of eight whose larger loop runs counter-clockwise has a positive area.
  EXPECT_THAT(error_with("\\[1, 1\\], \\[3, 1\\], \\[3, 3\\], \\[1, 3\\]", "[0, 0], [4, 0], [4, 3], [1, -1]"),
              HasSubstr("crosses itself"));
}

}  // namespace
}  // namespace supple
