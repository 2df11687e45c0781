/// States in files: bit for bit, of bodies in two and three dimensions; damage is refused, older files are
/// read.
#include "supple/io/hdf5/system_archive.hpp"

#include <gmock/gmock.h>

#include "supple/build/surfaces.hpp"
#include "supple/io/hdf5/body_archive.hpp"
#include "supple/model/rigid.hpp"
#include "tests/io/same_system.hpp"
#include "tests/io/sample_run.hpp"
#include "tests/io/temporary_folder.hpp"
#include "tests/support/polygons.hpp"
#include "tests/support/solids.hpp"

namespace supple {
namespace {

using namespace supple::testing;
using ::testing::HasSubstr;

/// A tetrahedron and a body of one site.
System<3> sample_system_3d() {
  System<3> system;
  system.box.length = {1, 2, 3};
  system.state.resize(5);
  system.state.position = {{1 / 3., 2, 3}, {4, 5 / 7., 6}, {7, 8, 9 / 11.}, {-0.0, 1e-310, 3}, {1, 1, 1}};
  system.state.spin[3] = {1 / 3., 1 / 7., 1 / 9.};
  system.topology.begin = {0, 4, 5};
  system.topology.facet = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  system.topology.facet_begin = {0, 4, 4};
  system.topology.hinge = {{0, 1, 2, 3}, {1, 2, 3, 0}};
  system.topology.hinge_begin = {0, 2, 2};
  system.shape.stiffness = {{1 / 3., 1 / 7., 1 / 11., 1 / 13.}, {}};
  system.shape.rest_volume = {1 / 6., 0};
  system.shape.rest_facet = {1 / 2., 1 / 3., 1 / 5., 1 / 7.};
  system.shape.rest_hinge = {1 / 9., -1 / 9.};
  system.terms = {{"first", 2, {1 / 3., 1 / 7.}}, {"second", 1, {1 / 11., 1 / 13.}}};
  return system;
}

class SystemArchive : public TemporaryFolder {
 protected:
  template <int Dim>
  h5::Group written(const System<Dim>& system) const {
    h5::Group root = h5::create_file(in_folder("state.h5"));
    write_system(root, system, si_units());
    return root;
  }
  /// The error of reading a state of polygons that `damage` has changed.
  template <class Damage>
  std::string error_after(Damage&& damage) const {
    System<2> system = random_polygons();
    damage(system);
    return file_error_of([&] { read_system<2>(written(system)); });
  }
};

TEST_F(SystemArchive, BodiesComeBackBitForBit) {
  System<2> polygons = random_polygons();
  add_disc_body(polygons, {1, 2}, 1 / 3.);
  polygons.floor_contact.assign(static_cast<std::size_t>(polygons.state.size()), std::nan(""));
  polygons.floor_contact[3] = 1 / 3.;
  expect_same(read_system<2>(written(polygons)), polygons);
  expect_same(read_system<2>(written(sample_system(5))), sample_system(5));
  expect_same(read_system<3>(written(sample_system_3d())), sample_system_3d());
}

TEST_F(SystemArchive, KeepsTheImagesOfLinks) {
  System<2> system = sample_system(5);
  system.pairs.image.resize(system.pairs.first.size());
  system.pairs.image.back() = {{-1, 2, 0}, true};
  EXPECT_EQ(read_system<2>(written(system)).pairs.image, system.pairs.image);
}

/// Polygons that remember their contacts, with two links.
System<2> with_links() {
  System<2> system = random_polygons();
  system.touches.rows = {{{3, 40, TouchOn::site, {0, -1, 0}}, ContactState::stick, 1 / 3.},
                         {{5, 2, TouchOn::body, {1, 0, 0}}, ContactState::slip, -1 / 7.}};
  system.links = {{2, 30, {1, -2, 0}, 0.1, 1 / 9.}, {4, 50, {}, 0.2, 0}};
  return system;
}

TEST_F(SystemArchive, KeepsLinksOfBodiesAndWhatTheirContactsRemember) {
  expect_same(read_system<2>(written(with_links())), with_links());
}

TEST_F(SystemArchive, RefusesContactsAndLinksOfNothing) {
  const auto error = [&](const auto& damage) {
    return error_after([&](System<2>& system) {
      system = with_links();
      damage(system);
    });
  };
  EXPECT_THAT(error([](auto& s) { s.links[0].second = 100000; }),
              HasSubstr("a link of sites that do not exist"));
  EXPECT_THAT(error([](auto& s) { s.links[0].rest = -1; }), HasSubstr("or of no length"));
  EXPECT_THAT(error([](auto& s) { s.links[1].cells[0] = 2000000000; }), HasSubstr("absurdly far"));
  EXPECT_THAT(error([](auto& s) { s.touches.rows[1].key.other = 9; }),
              HasSubstr("a contact of sites that do not"));
  EXPECT_THAT(error([](auto& s) { s.touches.rows[0].key.site = 7; }), HasSubstr("not in order"));
}

TEST_F(SystemArchive, SolidsComeBackBitForBit) {
  expect_same(read_system<2>(written(solids_among_others())), solids_among_others());
  expect_same(read_system<3>(written(solids_among_others_in_3d())), solids_among_others_in_3d());
  EXPECT_FALSE(written(random_polygons()).has("solid"));
}

TEST_F(SystemArchive, DamageOfSolidsIsRefused) {
  const auto error_after_damage = [&](auto&& damage) {
    System<2> system = solids_among_others();
    damage(system.solid);
    return file_error_of([&] { read_system<2>(written(system)); });
  };
  using S = Solid<2>;
  EXPECT_THAT(error_after_damage([](S& s) { s.bond[3][1] = 30; }), HasSubstr("bonds and bodies disagree"));
  EXPECT_THAT(error_after_damage([](S& s) { s.rest_bond.pop_back(); }),
              HasSubstr("bonds and bodies disagree"));
  EXPECT_THAT(error_after_damage([](S& s) { s.element[2][0] = -1; }),
              HasSubstr("elements and bodies disagree"));
  EXPECT_THAT(error_after_damage([](S& s) { s.element_begin.pop_back(); }), HasSubstr("differ in number"));
  EXPECT_THAT(error_after_damage([](S& s) { s.stiffness.pop_back(); }), HasSubstr("differ in number"));
  EXPECT_THAT(error_after_damage([](S& s) { std::swap(s.rest_element[0].e[0], s.rest_element[0].e[1]); }),
              HasSubstr("no area"));
}

System<2> with_rigid_bodies() {
  System<2> system = random_polygons();
  for (int b : {2, 5}) make_rigid(system, b);
  system.rigid.angle = {1e9 / 7, -1 / 3.};
  system.rigid.spin = {1 / 7., -0.0};
  system.rigid.velocity = {{1 / 3., 2}, {3, 1e-310}};
  place_sites(system);
  return system;
}

TEST_F(SystemArchive, RigidBodiesComeBackBitForBit) {
  expect_same(read_system<2>(written(with_rigid_bodies())), with_rigid_bodies());
  EXPECT_FALSE(written(random_polygons()).has("rigid"));
}

TEST_F(SystemArchive, DamageOfRigidBodiesIsRefused) {
  const auto error_after_damage = [&](auto&& damage) {
    System<2> system = with_rigid_bodies();
    damage(system.rigid);
    return file_error_of([&] { read_system<2>(written(system)); });
  };
  using R = RigidBodies;
  EXPECT_THAT(error_after_damage([](R& r) { r.spin.pop_back(); }), HasSubstr("differ in length"));
  EXPECT_THAT(error_after_damage([](R& r) { r.centre.pop_back(); }), HasSubstr("differ in length"));
  for (const std::vector<std::int32_t>& bodies : {std::vector{5, 2}, {2, 9}, {-1, 5}, {2, 2}})
    EXPECT_THAT(error_after_damage([&](R& r) { r.body = bodies; }),
                HasSubstr("rigid bodies and bodies disagree"));
  System<2> equal;  // bodies of as many sites
  for (double x : {1, 4, 7}) add_polygon(equal, {x, 1}, 2, 6, 0, 1, {});
  for (int b : {1, 2}) make_rigid(equal, b);
  for (const std::vector<std::int32_t>& bodies : {std::vector{2, 1}, {1, 1}}) {
    equal.rigid.body = bodies;
    EXPECT_THAT(file_error_of([&] { read_system<2>(written(equal)); }),
                HasSubstr("rigid bodies and bodies disagree"));
  }
  EXPECT_THAT(error_after_damage([](R& r) { r.begin[1] += 1; }),
              HasSubstr("rigid bodies and bodies disagree"));
  EXPECT_THAT(error_after_damage([](R& r) { r.offset.pop_back(); }),
              HasSubstr("rigid bodies and bodies disagree"));
  EXPECT_THAT(error_after_damage([](R& r) { r.inertia[1] = 0; }),
              HasSubstr("rigid bodies and bodies disagree"));
}

System<3> with_rigid_surfaces() {
  System<3> system;
  for (const double x : {0., 5., 10.})
    add_surface(system, geodesic_icosahedron(12), 0.1, {}, 1, std::vector<double>(20, 1),
                std::vector<double>(30, x));
  for (const int b : {0, 2}) make_rigid(system, b);
  system.rigid.centre[1] = {1 / 3., 7, -0.0};
  system.rigid.angle = {{1 / 7., 2, -1 / 3.}, {1e-310, 0, 3}};
  system.rigid.spin = {{1 / 7., -0.0, 3}, {}};
  system.rigid.velocity = {{1 / 3., 2, 1}, {3, 1e-310, 2}};
  place_sites(system);
  return system;
}

TEST_F(SystemArchive, RigidSurfacesComeBackBitForBit) {
  const System<3> read = read_system<3>(written(with_rigid_surfaces()));
  ASSERT_EQ(read.rigid.size(), 2);
  expect_same(read, with_rigid_surfaces());
}

TEST_F(SystemArchive, DamageOfRigidSurfacesIsRefused) {
  using R = RigidBodiesOf<3>;
  const auto error_after_damage = [&](auto&& damage) {
    System<3> system = with_rigid_surfaces();
    damage(system.rigid);
    return file_error_of([&] { read_system<3>(written(system)); });
  };
  EXPECT_THAT(error_after_damage([](R& r) { r.angle.pop_back(); }), HasSubstr("differ in length"));
  EXPECT_THAT(error_after_damage([](R& r) { r.inertia.pop_back(); }), HasSubstr("differ in length"));
  EXPECT_THAT(error_after_damage([](R& r) { r.offset.pop_back(); }),
              HasSubstr("rigid bodies and bodies disagree"));
  const Mat<3> flat{{{1, 1, 0}, {1, 1, 0}, {0, 0, 1}}}, skew{{{2, 1, 0}, {0, 2, 0}, {0, 0, 2}}},
      saddle{{{2, 0, 2}, {0, 2, 2}, {2, 2, 2}}}, negative{{{-2, 0, 0}, {0, -2, 0}, {0, 0, 2}}};
  for (const Mat<3>& inertia : {flat, skew, saddle, negative})
    EXPECT_THAT(error_after_damage([&](R& r) { r.inertia[1] = inertia; }),
                HasSubstr("rigid bodies and bodies disagree"));
}

TEST_F(SystemArchive, DiscsHaveNoShapeAndNoFloor) {
  System<2> discs = sample_system(4);
  discs.topology = {};
  discs.shape = {};
  discs.floor_contact.clear();
  const h5::Group root = written(discs);
  EXPECT_FALSE(root.has("shape"));
  EXPECT_FALSE(root.has("sites/floor_contact"));
  expect_same(read_system<2>(root), discs);
}

TEST_F(SystemArchive, FilesOfOlderVersionsOpen) {
  System<2> system = sample_system(5);
  system.topology.facet_begin.clear();
  system.topology.hinge_begin.clear();
  system.shape = {};
  system.floor_contact.clear();
  h5::Group root = written(system);
  h5::Group topology = root.open_group("topology");
  topology.remove("facet_begin");
  topology.remove("hinge_begin");
  expect_same(read_system<2>(root), system);

  h5::Group group = root.create_group("evaluation");
  write_evaluation(group, sample_evaluation(5), si_units());
  EXPECT_EQ(read_evaluation<2>(group).energy.wall, 1 / 11.);
  EXPECT_EQ(read_evaluation<2>(group).energy.external, -1 / 13.);
  h5::Group energy = group.open_group("energy");
  energy.remove("wall");
  energy.remove("external");
  const Evaluation<2> old = read_evaluation<2>(group);
  EXPECT_EQ(old.energy.wall, 0);
  EXPECT_EQ(old.energy.external, 0);
  EXPECT_EQ(old.energy.elastic, 1 / 3.);
}

TEST_F(SystemArchive, DamageIsRefused) {
  using S = System<2>;
  const std::string why = error_after([](S& s) { s.topology.facet_begin.back() += 1; });
  EXPECT_THAT(why, HasSubstr("state.h5:/topology"));
  EXPECT_THAT(why, HasSubstr("facets and bodies disagree"));
  EXPECT_THAT(error_after([](S& s) { s.topology.begin.back() -= 1; }), HasSubstr("do not cover the sites"));
  EXPECT_THAT(error_after([](S& s) { s.topology.begin[1] = s.topology.begin[2]; }),
              HasSubstr("do not cover the sites"));
  EXPECT_THAT(error_after([](S& s) {
                s.topology.begin.pop_back();
                s.topology.begin.back() = s.state.size();
              }),
              HasSubstr("differ in number"));
  EXPECT_THAT(error_after([](S& s) { std::swap(s.topology.hinge_begin[1], s.topology.hinge_begin[2]); }),
              HasSubstr("hinges and bodies disagree"));
  EXPECT_THAT(error_after([](S& s) { s.topology.facet[3][1] = s.state.size(); }),
              HasSubstr("does not exist"));
  EXPECT_THAT(error_after([](S& s) { s.topology.hinge[3][1] = -1; }), HasSubstr("does not exist"));
  EXPECT_THAT(error_after([](S& s) { s.topology.facet[3][1] = s.state.size() - 1; }),
              HasSubstr("facets and bodies disagree"));
  EXPECT_THAT(error_after([](S& s) { s.topology.hinge[3][1] = s.state.size() - 1; }),
              HasSubstr("hinges and bodies disagree"));
  for (auto part : {&Shape::rest_volume, &Shape::rest_facet, &Shape::rest_hinge})
    EXPECT_THAT(error_after([&](S& s) { (s.shape.*part).pop_back(); }),
                HasSubstr("shapes and bodies disagree"));
  EXPECT_THAT(error_after([](S& s) {
                s.terms = {{"perimeter", 1, std::vector<double>(1000)}};
              }),
              HasSubstr("perimeter and bodies disagree"));
  EXPECT_THAT(error_after([](S& s) { s.shape.stiffness.pop_back(); }),
              HasSubstr("stiffnesses and bodies differ in number"));
  EXPECT_THAT(error_after([](S& s) { s.topology.hinge_begin.clear(); }), HasSubstr("no boundary"));
  EXPECT_THAT(error_after([](S& s) { s.floor_contact = {1}; }), HasSubstr("differ in length"));
}

TEST_F(SystemArchive, AnotherDimensionIsRefused) {
  const h5::Group root = written(sample_system_3d());
  EXPECT_THAT(file_error_of([&] { read_system<2>(root); }), HasSubstr("dimension"));
  EXPECT_THAT(file_error_of([&] { read_topology<2>(root.open_group("topology"), 5); }),
              HasSubstr("dimension"));
}

}  // namespace
}  // namespace supple
