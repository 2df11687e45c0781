#include "supple/io/export/xyz.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "supple/core/error.hpp"
#include "supple/draw/scene/drawn_cell.hpp"
#include "tests/io/sample_scene.hpp"
#include "tests/io/temporary_folder.hpp"

namespace supple {
namespace {

using testing::content_of;
using testing::sample_scene;

struct XyzFrame {
  std::string header;
  std::vector<std::string> types;
  std::vector<std::vector<double>> columns;  ///< behind the type, line by line

  /// The text of a key, without its quotes.
  std::string key(const std::string& name) const {
    const std::size_t at = (" " + header).find(" " + name + "=");
    if (at == std::string::npos) return "missing";
    const std::string rest = header.substr(at + name.size() + 1);
    return rest[0] == '"' ? rest.substr(1, rest.find('"', 1) - 1) : rest.substr(0, rest.find(' '));
  }
  std::vector<double> numbers(const std::string& name) const {
    std::istringstream in(key(name));
    return {std::istream_iterator<double>(in), {}};
  }
};

std::vector<XyzFrame> read(const std::string& path) {
  std::istringstream in(content_of(path));
  std::vector<XyzFrame> frames;
  for (std::string line; std::getline(in, line);) {
    XyzFrame frame;
    const int sites = std::stoi(line);
    std::getline(in, frame.header);
    for (int i = 0; i < sites; ++i) {
      std::getline(in, line);
      std::istringstream row(line);
      row >> frame.types.emplace_back();
      frame.columns.emplace_back();
      for (std::string number; row >> number;) frame.columns.back().push_back(std::stod(number));
    }
    frames.push_back(frame);
  }
  return frames;
}

class Xyz : public testing::TemporaryFolder {
 protected:
  std::vector<XyzFrame> write_and_read(const std::vector<Scene>& scenes,
                                       Placement placement = Placement::in_cell) {
    XyzFile file(in_folder("a.xyz"), Existing::replace, placement);
    for (const Scene& scene : scenes) file.append(scene);
    file.commit();
    return read(in_folder("a.xyz"));
  }
};

TEST_F(Xyz, ReadsBackEverySiteToTheSameDouble) {
  Scene scene = sample_scene();
  for (int i = 4; i < 9; ++i) scene.position[i] += Vec2{20, -16};  // it stays where it has gone to
  const std::vector<XyzFrame> frames = write_and_read({scene}, Placement::unwrapped);
  ASSERT_EQ(frames.size(), 1u);
  EXPECT_EQ(
      frames[0].key("Properties"),
      "type:S:1:pos:R:3:radius:R:1:id:I:1:molecule:I:1:force:R:3:contact_count:I:1:pressure:R:1:velo:R:3");
  const int body[] = {0, 0, 0, 1, 2, 2, 2, 2, 2};
  const auto& force = std::get<std::vector<Vec2>>(scene.of_sites[0].values);
  const auto& contacts = std::get<std::vector<std::int32_t>>(scene.of_sites[1].values);
  const auto& pressure = std::get<std::vector<double>>(scene.of_bodies[0].values);
  const auto& velocity = std::get<std::vector<Vec2>>(scene.of_bodies[1].values);
  for (int i = 0; i < 9; ++i) {
    const int b = body[i];
    const std::vector<double> expected{scene.position[i][0],
                                       scene.position[i][1],
                                       0,
                                       scene.radius[i],
                                       i * 1.0,
                                       b * 1.0,
                                       force[i][0],
                                       force[i][1],
                                       0,
                                       contacts[i] * 1.0,
                                       pressure[b],
                                       velocity[b][0],
                                       velocity[b][1],
                                       0};
    EXPECT_EQ(frames[0].columns[i], expected) << i;
  }
}

/// A number named spin would be read as the x component of a vector.
TEST_F(Xyz, SpinsAreVectorsAlongZ) {
  Scene scene = sample_scene();
  scene.of_sites = {{"spin", std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8, 9}, true}};
  scene.of_bodies.clear();
  const XyzFrame frame = write_and_read({scene})[0];
  EXPECT_THAT(frame.key("Properties"), ::testing::EndsWith(":spin:R:3"));
  EXPECT_EQ(std::vector<double>(frame.columns[4].begin() + 6, frame.columns[4].end()),
            (std::vector<double>{0, 0, 5}));
}

TEST_F(Xyz, NumbersOfTheWholeStandInTheHeader) {
  Scene scene = sample_scene();
  scene.numbers = {{"pressure", 1.0 / 3}, {"uniaxial_strain", 0.25}};
  const XyzFrame frame = write_and_read({scene})[0];
  EXPECT_EQ(std::stod(frame.key("pressure")), 1.0 / 3);
  EXPECT_EQ(frame.key("uniaxial_strain"), "0.25");
}

TEST_F(Xyz, NamesATypeForEachKindAndSize) {
  Scene scene = sample_scene();
  scene.begin = {0, 3, 4, 5, 6, 9};
  scene.radius = {0.3, 0.3, 0.3, 0.7, 0.3, 0.7, 0.3, 0.3, 0.3};
  scene.of_bodies.clear();
  EXPECT_EQ(write_and_read({scene})[0].types,
            (std::vector<std::string>{"polygon1", "polygon1", "polygon1", "disc2", "disc3", "disc2",
                                      "polygon1", "polygon1", "polygon1"}));
}

TEST_F(Xyz, GivesTheLeaningCellOfEqualLattice) {
  Scene scene = sample_scene();
  scene.box.strain = 0.3 + 2 * 10.0 / 8;  // two images further: the lattice of 0.3
  scene.box.periodic[flow] = true;
  const XyzFrame frame = write_and_read({scene})[0];
  const std::vector<double> lattice = frame.numbers("Lattice"), origin = frame.numbers("Origin");
  ASSERT_EQ(lattice.size(), 9u);
  ASSERT_EQ(origin.size(), 3u);
  const double expected[] = {10, 0, 0, 0.3 * 8, 8, 0, 0, 0, 1.4}, corner[] = {-0.15 * 8, 0, -0.7};
  for (int k = 0; k < 9; ++k) EXPECT_NEAR(lattice[k], expected[k], 1e-12) << k;
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(origin[k], corner[k], 1e-12) << k;
  EXPECT_EQ(frame.key("pbc"), "T T F");
  EXPECT_EQ(std::stod(frame.key("Time")), 1.0 / 3);
  scene.box.periodic = {true, false};
  EXPECT_EQ(write_and_read({scene})[0].key("pbc"), "T F F");
}

TEST_F(Xyz, KeepsBodiesWholeWithTheirMeanInTheCell) {
  Scene scene = sample_scene();
  scene.box.strain = -0.4;
  for (int i = 0; i < 3; ++i) scene.position[i] += Vec2{20, -16};
  const XyzFrame frame = write_and_read({scene})[0];
  Vec2 mean{};
  for (int i = 0; i < 3; ++i) {
    const Vec2 x{frame.columns[i][0], frame.columns[i][1]}, first{frame.columns[0][0], frame.columns[0][1]};
    EXPECT_NEAR(norm(x - first - (scene.position[i] - scene.position[0])), 0, 1e-12);
    EXPECT_NEAR(norm(scene.box.displacement(scene.position[i], x)), 0, 1e-12);
    mean += (1.0 / 3) * x;
  }
  EXPECT_NE(lies_in(cell_corners(scene.box), std::span(&mean, 1)), Lies::outside);
}

TEST_F(Xyz, AppendsFramesThatMayDifferInSize) {
  Scene second = sample_scene();
  second.time = 2;
  second.begin = {0, 3};
  second.position.resize(3);
  second.radius.resize(3);
  second.of_sites.clear();
  second.of_bodies.clear();
  const std::vector<XyzFrame> frames = write_and_read({sample_scene(), second, sample_scene()});
  ASSERT_EQ(frames.size(), 3u);
  EXPECT_EQ(frames[1].types.size(), 3u);
  EXPECT_EQ(frames[1].key("Time"), "2");
  EXPECT_EQ(frames[2].columns, frames[0].columns);
}

TEST_F(Xyz, IsNotThereBeforeItIsComplete) {
  {
    XyzFile file(in_folder("a.xyz"));
    file.append(sample_scene());
    EXPECT_FALSE(std::filesystem::exists(in_folder("a.xyz")));
  }
  EXPECT_EQ(files(), 0u);
}

TEST_F(Xyz, RefusesNamesThatTheHeaderCannotHold) {
  for (const char* name : {"a b", "a:b", "p=q", "pos", "force", ""}) {
    Scene scene = sample_scene();
    scene.of_bodies[0].name = name;
    XyzFile file(in_folder("a.xyz"), Existing::replace);
    EXPECT_THROW(file.append(scene), Error) << name;
  }
}

}  // namespace
}  // namespace supple
