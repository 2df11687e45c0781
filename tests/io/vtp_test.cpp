#include "supple/io/export/vtp.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <nlohmann/json.hpp>
#include <numbers>
#include <regex>

#include "supple/core/error.hpp"
#include "supple/draw/scene/drawn_cell.hpp"
#include "tests/io/count_of.hpp"
#include "tests/io/sample_scene.hpp"
#include "tests/io/temporary_folder.hpp"
#include "tests/paths.hpp"

namespace supple {
namespace {

using testing::content_of;
using testing::count_of;
using testing::sample_scene;
using Json = nlohmann::json;

class Vtp : public testing::TemporaryFolder {
 protected:
  /// What VTK reads.
  Json read(const std::string& name) {
    const std::string out = in_folder("out.json");
    const std::string line = "/usr/bin/python3 '" SUPPLE_SOURCE_DIR "/tests/io/read_vtp.py' '" +
                             in_folder(name) + "' >'" + out + "' 2>'" + in_folder("log") + "'";
    if (std::system(line.c_str()) != 0) throw std::runtime_error(content_of(in_folder("log")));
    return Json::parse(content_of(out));
  }
  Json write_and_read(const Scene& scene, Placement placement) {
    write_vtp(in_folder("a.vtp"), scene, Existing::replace, placement);
    return read("a.vtp");
  }
};

void expect_same_bits(const Json& read, double written) {
  EXPECT_EQ(std::bit_cast<std::uint64_t>(read.get<double>()), std::bit_cast<std::uint64_t>(written));
}

/// Vectors come back with three components.
void expect_same_bits(const Json& read, const Vec2& written) {
  ASSERT_EQ(read.size(), 3u);
  for (int d = 0; d < 2; ++d) expect_same_bits(read[d], written[d]);
  EXPECT_EQ(read[2], 0);
}

/// The 3 + 32 + 5 points of the sample: its site.
std::vector<int> site_of_points() {
  std::vector<int> site{0, 1, 2};
  site.resize(3 + disc_corners, 3);
  for (int i = 4; i < 9; ++i) site.push_back(i);
  return site;
}

TEST_F(Vtp, GivesVtkOnePolygonForEachBodyWithTheSameBits) {
  Scene scene = sample_scene();
  for (int i = 4; i < 9; ++i) scene.position[i] += Vec2{20, -16};  // it stays where it has gone to
  const Json mesh = write_and_read(scene, Placement::unwrapped);
  ASSERT_EQ(mesh["points"].size(), 40u);
  ASSERT_EQ(mesh["polygons"].size(), 3u);
  EXPECT_EQ(mesh["others"], 0);
  int next = 0;
  for (int b = 0; b < 3; ++b) {
    ASSERT_EQ(mesh["polygons"][b].size(), std::vector<std::size_t>({3, 32, 5})[b]);
    for (const Json& id : mesh["polygons"][b]) EXPECT_EQ(id, next++);
  }
  const std::vector<int> site = site_of_points();
  for (int k = 0; k < 40; ++k)
    if (site[k] != 3) expect_same_bits(mesh["points"][k], scene.position[site[k]]);
}

TEST_F(Vtp, DrawsADiscAsARegularPolygonOnItsCircle) {
  const Scene scene = sample_scene();
  const Json mesh = write_and_read(scene, Placement::in_cell);
  const auto point = [&](int k) {
    return Vec2{mesh["points"][k][0].get<double>(), mesh["points"][k][1].get<double>()};
  };
  const double side = 2 * 0.7 * std::sin(std::numbers::pi / disc_corners);
  for (int k = 0; k < disc_corners; ++k) {
    EXPECT_NEAR(norm(point(3 + k) - scene.position[3]), 0.7, 1e-14);
    EXPECT_NEAR(norm(point(3 + (k + 1) % disc_corners) - point(3 + k)), side, 1e-14);
  }
}

TEST_F(Vtp, GivesVtkTheDataOfPointsAndCells) {
  const Scene scene = sample_scene();
  const Json mesh = write_and_read(scene, Placement::in_cell);
  const std::vector<int> site = site_of_points();
  const Json &points = mesh["of_points"], &cells = mesh["of_cells"];
  ASSERT_EQ(points.size(), 4u);
  ASSERT_EQ(cells.size(), 5u);
  EXPECT_EQ(points["contact_count"]["type"], "int");
  EXPECT_EQ(points["force"]["type"], "double");
  const auto& force = std::get<std::vector<Vec2>>(scene.of_sites[0].values);
  const auto& contacts = std::get<std::vector<std::int32_t>>(scene.of_sites[1].values);
  for (int k = 0; k < 40; ++k) {
    EXPECT_EQ(points["site"]["values"][k][0], site[k]);
    EXPECT_EQ(points["contact_count"]["values"][k][0], contacts[site[k]]);
    expect_same_bits(points["radius"]["values"][k][0], scene.radius[site[k]]);
    expect_same_bits(points["force"]["values"][k], force[site[k]]);
  }
  const double radius[] = {0.3, 0.7, 0.1};
  const auto& pressure = std::get<std::vector<double>>(scene.of_bodies[0].values);
  const auto& velocity = std::get<std::vector<Vec2>>(scene.of_bodies[1].values);
  for (int b = 0; b < 3; ++b) {
    EXPECT_EQ(cells["id"]["values"][b][0], b);
    EXPECT_EQ(cells["sites"]["values"][b][0], scene.begin[b + 1] - scene.begin[b]);
    expect_same_bits(cells["radius"]["values"][b][0], radius[b]);
    expect_same_bits(cells["pressure"]["values"][b][0], pressure[b]);
    expect_same_bits(cells["velocity"]["values"][b], velocity[b]);
  }
}

TEST_F(Vtp, PutsWholeBodiesIntoTheLeaningCell) {
  Scene scene = sample_scene();
  scene.box.strain = 0.3 + 10.0 / 8;  // drawn as 0.3
  for (int i = 4; i < 9; ++i)
    scene.position[i] += Vec2{-30 + scene.box.strain * 8, 8};  // one cell up, 3 back
  const Json mesh = write_and_read(scene, Placement::in_cell);
  Vec2 mean{};
  for (int i = 4; i < 9; ++i) {
    const Json& point = mesh["points"][i + disc_corners - 1];
    const Vec2 x{point[0].get<double>(), point[1].get<double>()};
    EXPECT_NEAR(norm(scene.box.displacement(scene.position[i], x)), 0, 1e-12) << i;
    mean += 0.2 * x;
  }
  EXPECT_NE(lies_in(cell_corners(scene.box), std::span(&mean, 1)), Lies::outside);
}

TEST_F(Vtp, IsWrittenAsOvitoReadsIt) {
  write_vtp(in_folder("a.vtp"), sample_scene());
  const std::string xml = content_of(in_folder("a.vtp"));
  EXPECT_EQ(count_of(xml, "<DataArray"), count_of(xml, "format=\"binary\""));
  for (const char* refused : {"compressor", "appended", "<Verts", "<Lines", "<Strips", "Int8", "Int16"})
    EXPECT_EQ(count_of(xml, refused), 0) << refused;
  EXPECT_LT(xml.find("\"connectivity\""), xml.find("\"offsets\""));
}

/// vtk.js makes a view of 64-bit numbers at the size's end: it must be of 8 bytes.
TEST_F(Vtp, SizesHave64BitsAndTimeAndCellAreTold) {
  Scene scene = sample_scene();
  scene.numbers = {{"pressure", 1.0 / 7}};
  const Json of_all = write_and_read(scene, Placement::in_cell)["of_all"];
  ASSERT_EQ(of_all.size(), 4u);
  expect_same_bits(of_all["TimeValue"]["values"].at(0).at(0), 1.0 / 3);
  expect_same_bits(of_all["pressure"]["values"].at(0).at(0), 1.0 / 7);
  const Json edges = Json::parse("[[10.0, 0.0, 0.0], [0.0, 8.0, 0.0], [0.0, 0.0, 1.4]]");
  EXPECT_EQ(of_all["cell"]["values"], edges);  // as deep as the disc
  EXPECT_EQ(of_all["cell_origin"]["values"], Json::parse("[[0.0, 0.0, -0.7]]"));
  const std::string xml = content_of(in_folder("a.vtp"));
  EXPECT_EQ(count_of(xml, "header_type=\"UInt64\""), 1);
  EXPECT_EQ(count_of(xml, "Name=\"TimeValue\""), 1);
}

/// An L of unit thickness: a fan from its first vertex would cover more than it.
TEST_F(Vtp, TrianglesCoverWhatABodyCovers) {
  Scene scene;
  scene.box.length = {10, 10};
  scene.begin = {0, 6};
  scene.position = {{3, 1}, {3, 2}, {2, 2}, {2, 3}, {1, 3}, {1, 1}};
  scene.radius.assign(6, 1e-6);
  write_vtp(in_folder("a.vtp"), scene, Existing::refuse, Placement::unwrapped, Cells::triangles);
  const Json mesh = read("a.vtp");
  double area = 0;
  for (const Json& cell : mesh["polygons"]) {
    ASSERT_EQ(cell.size(), 3u);
    const auto x = [&](int k, int d) { return mesh["points"][cell[k].get<int>()][d].get<double>(); };
    area +=
        0.5 * std::abs((x(1, 0) - x(0, 0)) * (x(2, 1) - x(0, 1)) - (x(1, 1) - x(0, 1)) * (x(2, 0) - x(0, 0)));
  }
  EXPECT_NEAR(area, 3, 1e-4);
}

TEST_F(Vtp, KeepsNamesThatXmlWouldMisread) {
  Scene scene = sample_scene();
  scene.of_bodies[0].name = "p/<p> & \"more\"";
  EXPECT_TRUE(write_and_read(scene, Placement::in_cell)["of_cells"].contains("p/<p> & \"more\""));
}

TEST_F(Vtp, WritesDiscsAloneAndAnEmptyScene) {
  Scene discs;
  discs.box.length = {5, 5};
  discs.position = {{1, 1}, {3, 3}};
  discs.radius = {0.5, 0.6};
  EXPECT_EQ(write_and_read(discs, Placement::in_cell)["polygons"].size(), 2u);
  Scene empty;
  empty.box.length = {5, 5};
  EXPECT_EQ(write_and_read(empty, Placement::in_cell)["polygons"].size(), 0u);
}

TEST_F(Vtp, RefusesArraysThatDoNotFitAndLeavesNoFile) {
  const auto message = [&](auto&& change) -> std::string {
    Scene scene = sample_scene();
    change(scene);
    try {
      write_vtp(in_folder("a.vtp"), scene);
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), ErrorKind::input);
      return e.what();
    }
    return "";
  };
  using ::testing::HasSubstr;
  EXPECT_THAT(message([](auto& s) { s.radius.pop_back(); }), HasSubstr("8 radii for 9 sites"));
  EXPECT_THAT(message([](auto& s) { s.begin = {0, 3, 4}; }), HasSubstr("do not cover all sites"));
  EXPECT_THAT(message([](auto& s) { s.begin = {0, 3, 5, 9}; }), HasSubstr("body 1 has 2 sites"));
  EXPECT_THAT(message([](auto& s) { s.of_bodies[0].values = std::vector<double>(2); }),
              HasSubstr("2 values for 3"));
  EXPECT_THAT(message([](auto& s) { s.of_sites[1].name = "force"; }), HasSubstr("named 'force'"));
  EXPECT_THAT(message([](auto& s) { s.of_bodies[1].name = "radius"; }), HasSubstr("'radius' is taken"));
  EXPECT_EQ(files(), 0u);
}

TEST_F(Vtp, ReplacesNothingUnlessAsked) {
  write_vtp(in_folder("a.vtp"), sample_scene());
  EXPECT_THROW(write_vtp(in_folder("a.vtp"), sample_scene()), Error);
  EXPECT_NO_THROW(write_vtp(in_folder("a.vtp"), sample_scene(), Existing::replace));
}

TEST_F(Vtp, CollectsFramesByTimeInFullPrecision) {
  write_pvd(in_folder("a.pvd"), {{0, "a_0.vtp"}, {1.0 / 3, "a_1.vtp"}, {1e9 / 7, "b & c.vtp"}});
  const std::string xml = content_of(in_folder("a.pvd"));
  const std::regex entry("timestep=\"([^\"]*)\"[^>]*file=\"([^\"]*)\"");
  std::vector<double> times;
  std::vector<std::string> names;
  for (auto at = std::sregex_iterator(xml.begin(), xml.end(), entry); at != std::sregex_iterator(); ++at) {
    times.push_back(std::stod((*at)[1]));
    names.push_back((*at)[2]);
  }
  EXPECT_EQ(times, (std::vector<double>{0, 1.0 / 3, 1e9 / 7}));
  EXPECT_EQ(names, (std::vector<std::string>{"a_0.vtp", "a_1.vtp", "b &amp; c.vtp"}));
}

TEST_F(Vtp, RefusesFramesOutOfOrder) {
  EXPECT_THROW(write_pvd(in_folder("a.pvd"), {{0, "a"}, {0, "b"}}), Error);
  EXPECT_THROW(write_pvd(in_folder("a.pvd"), {{0.0 / 0.0, "a"}}), Error);
  EXPECT_EQ(files(), 0u);
}

}  // namespace
}  // namespace supple
