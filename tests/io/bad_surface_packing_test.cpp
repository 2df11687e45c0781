/// Packings of surfaces as JSON that cannot be.
#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>

#include "supple/build/surfaces.hpp"
#include "tests/io/temporary_folder.hpp"
#include "tests/support/surface_reference.hpp"

namespace supple {
namespace {

using namespace supple::testing;
using ::testing::HasSubstr;

class BadSurfacePacking : public TemporaryFolder {
 protected:
  /// The error of reading the example in which `from`, a regular expression, is replaced once.
  std::string error_with(const std::string& from, const std::string& to) const {
    const std::string text =
        std::regex_replace(good, std::regex(from), to, std::regex_constants::format_first_only);
    EXPECT_NE(text, good) << from;
    write_content(in_folder("p.json"), text);
    return file_error_of([&] { read_any_packing_json(in_folder("p.json")); });
  }
  void expect_error(const std::string& from, const std::string& to, const std::string& message) const {
    EXPECT_THAT(error_with(from, to), HasSubstr(message)) << from << " -> " << to;
  }

  const std::string good =
      R"({"k_v": 1, "k_a": 2, "k_b": 0.5, "k_c": 3, "box": [[10, 1, 0], [0, 9, 0], [0, 0, 8]],
  "particles": [{"sigma": 0.5, "x": [[8, 8, 7]]},
  {"sigma": 0.5, "v0": 0.2, "a0": 0.7, "theta0": [1, 1, 1, 1, 1, 1],
   "edges": [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]],
   "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]],
   "faces": [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]}]})";
};

TEST_F(BadSurfacePacking, TheGoodOneIsGood) {
  write_content(in_folder("p.json"), good);
  EXPECT_EQ(read_packing_json<3>(in_folder("p.json")).system.state.size(), 5);
}

TEST_F(BadSurfacePacking, MeshesThatAreNoSurfaces) {
  expect_error(", \\[1, 2, 3\\]\\]", "]", "p.json: particles[1] is no closed surface: ");
  expect_error("\\[0, 2, 1\\]", "[0, 1, 2]", "particles[1] is no closed surface: ");  // turned
  expect_error("\\[\\[0, 2, 1\\], \\[0, 1, 3\\], \\[0, 3, 2\\], \\[1, 2, 3\\]\\]",
               "[[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]]",
               "particles[1] is no closed surface: ");  // inside out
  expect_error("\\[0, 2, 1\\]", "[0, 2, 4]",
               "triangle 0 has the corner 4 (the vertices are numbered from 0 to 3)");
  expect_error("\\[0, 2, 1\\]", "[0, 2, -1]", "particles[1].faces[0][2] is -1, which counts nothing");
  expect_error("\\[0, 2, 1\\]", "[0, 2, 1.5]", "particles[1].faces[0][2] is not a whole number");
  expect_error("\\[0, 2, 1\\]", "[0, 2, 1e30]", "particles[1].faces[0][2] is not a whole number");
  expect_error("\\[0, 2, 1\\]", "[0, 2, 99999999999]", "is 99999999999, which counts nothing");
  expect_error("\\[0, 2, 1\\]", "[0, 2, 2]", "triangle 0 has the corners 0, 2 and 2");
  expect_error("\\[0, 2, 1\\]", "[0, 2]", "particles[1].faces[0] is not the numbers of three vertices");
  expect_error("\\[0, 2, 1\\], ", "[0, 2, 1], [0, 2, 1], ", "particles[1] is no closed surface: ");
  expect_error("\\[0, 0, 1\\]\\]", "[0, 0, 1], [2, 2, 2]]", "vertex 4 belongs to no triangle");
  expect_error("\\[0, 0, 1\\]\\]", "[0, 0, 0]]", "particles[1] is no closed surface: ");      // coincident
  expect_error("\\[0, 0, 1\\]\\]", "[0.5, 0.5, 0]]", "particles[1] is no closed surface: ");  // flat
  expect_error("\"faces\": \\[[^]*$", "\"faces\": []}]}", "there are 4 vertices and no triangles");
  expect_error("\"vertices\": [^v]*\"faces\"", "\"faces\"", "particles[1] has no \"vertices\"");
  expect_error("\\[1, 0, 0\\], \\[0, 1, 0\\]", "[9, 0, 0], [0, 1, 0]", "more than half a cell from vertex");
}

TEST_F(BadSurfacePacking, TwoAndThreeDimensionsInOneFile) {
  const std::string both = "a packing is in two dimensions or in three, as the points of its first particle";
  expect_error("\\[0, 1, 0\\], \\[0, 0, 1\\]", "[0, 1], [0, 0, 1]",
               "particles[1].vertices[2] is not three numbers");
  expect_error("\\[8, 8, 7\\]", "[8, 8]",
               "has the key \"k_v\" of surfaces, but the points of the first particle have two numbers");
  expect_error("\\[\\[10, 1, 0\\], \\[0, 9, 0\\], \\[0, 0, 8\\]\\]", "[10, 9]", "box is not three numbers");
  expect_error("\\[\\[10, 1, 0\\], \\[0, 9, 0\\], \\[0, 0, 8\\]\\]", "[10, 9]", both);
  expect_error("\"k_a\": 2", "\"k_a\": 2, \"k_l\": 2",
               "has the key \"k_l\" of polygons, but the points of the first particle have three numbers");
  expect_error("\"a0\": 0.7", "\"a0\": 0.7, \"l0\": 1", "particles[1] has the key \"l0\" of polygons");
  expect_error("\\{\"sigma\": 0.5, \"v0\"", "{\"sigma\": 1, \"x\": [[1, 1]]}, {\"sigma\": 0.5, \"v0\"",
               "particles[1].x[0] is not three numbers");
  expect_error("\"sigma\": 0.5, \"x\"", "\"sigma\": 0.5, \"rigid\": true, \"x\"",
               "particles[0] has the key \"rigid\" of polygons");
  expect_error("\\[\\[8, 8, 7\\]\\]", "[[8, 8, 7], [1, 1, 1]]",
               "particles[0].x has 2 points, not the centre of a sphere alone");
  expect_error("\"a0\": 0.7", "\"a0\": 0.7, \"x\": [[1, 1, 1]]",
               "particles[1].x stands beside the points of a surface");
  expect_error("\"k_v\": 1", "\"dim\": 3, \"k_v\": 1", "has an unknown key \"dim\"");
  expect_error("\"k_v\": 1", "\"k_v\": 1, \"periodic\": [true, true]", "periodic is not three values");
  // A file of polygons with a surface in it.
  write_content(in_folder("flat.json"),
                R"({"k_a": 1, "k_l": 2, "k_b": 0.5, "k_c": 3, "box": 10, "particles": [
    {"sigma": 1, "x": [[1, 1]]}, {"sigma": 1, "vertices": [[1, 1, 1]], "faces": [[0, 1, 2]]}]})");
  EXPECT_THAT(
      file_error_of([&] { read_any_packing_json(in_folder("flat.json")); }),
      HasSubstr("particles[1] has the key \"faces\" of surfaces, but the points of the first particle "
                "have two numbers"));
}

TEST_F(BadSurfacePacking, WhoseDimensionIsAnotherIsNotTaken) {
  write_content(in_folder("p.json"), good);
  try {
    read_packing_json<2>(in_folder("p.json"));
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::input);
    EXPECT_THAT(e.what(),
                HasSubstr("p.json holds surfaces and not polygons (the points of its first particle "
                          "have three numbers); give one whose points have two"));
  }
}

TEST_F(BadSurfacePacking, Cells) {
  const std::string box = "\\[\\[10, 1, 0\\], \\[0, 9, 0\\], \\[0, 0, 8\\]\\]";
  const std::string leans =
      "the columns are the periods of the cell, and that along y alone may lean, along x";
  expect_error(box, "[[10, 0, 0], [1, 9, 0], [0, 0, 8]]", "box[1][0] is 1, not 0: " + leans);
  expect_error(box, "[[10, 0, 0], [1, 9, 0], [0, 0, 8]]", "transpose the matrix if its rows are the periods");
  expect_error(box, "[[10, 0, 1], [0, 9, 0], [0, 0, 8]]", "box[0][2] is 1, not 0: " + leans);
  expect_error(box, "[[10, 0, 0], [0, 9, 0.5], [0, 0, 8]]", "box[1][2] is 0.5, not 0");
  expect_error(box, "[[10, 0, 0], [0, -9, 0], [0, 0, 8]]", "box[1][1] is -9, not positive");
  expect_error(box, "[[10, 0, 0], [0, 9, 0]]", "box is not three numbers");
  expect_error(box, "[[10, 0, 0], [0, 9], [0, 0, 8]]", "box[1] is not three numbers");
  expect_error(box, "[10, 9, 0]", "box is not positive");
  expect_error("\"k_v\": 1", "\"strain\": 0.1, \"k_v\": 1", "strain stands beside a matrix");
  expect_error("\"k_v\": 1", "\"walls\": [\"bottom\"], \"k_v\": 1", "is \"bottom\", not one of");
  expect_error("\"k_v\": 1", "\"gravity\": 1, \"k_v\": 1", "periodic along y");
  expect_error("\"box\": [^\"]*", "", "p.json has no \"box\"");
}

TEST_F(BadSurfacePacking, StiffnessesAndPreferredShapes) {
  expect_error("\"k_v\": 1, ", "", "p.json has no \"k_v\"");
  expect_error("\"k_v\": 1", "\"k_v\": -1", "k_v is negative");
  expect_error("\"k_v\": 1", "\"k_v\": 1, \"stiffness\": {\"k_v\": 1}", "k_v stands beside \"stiffness\"");
  expect_error("\"k_v\": 1, \"k_a\": 2, \"k_b\": 0.5, \"k_c\": 3", "\"stiffness\": {\"k_v\": 1, \"k_l\": 1}",
               "stiffness has an unknown key \"k_l\"");
  expect_error("\"k_v\": 1, \"k_a\": 2, \"k_b\": 0.5, \"k_c\": 3", "\"stiffness\": {\"k_v\": 1, \"k_a\": 1}",
               "stiffness has no \"k_b\"");
  expect_error("\"k_v\": 1", "\"stiffness\": \"soft\", \"k_v\": 1", "\"soft\", not relative or absolute");
  expect_error("\"k_c\": 3, ", "", "has no \"k_c\"");
  expect_error("\"v0\": 0.2", "\"v0\": 0", "particles[1].v0 is 0, not positive");
  expect_error("\"v0\": 0.2, ", "", "particles[1] has no \"v0\"");
  expect_error("\"a0\": 0.7", "\"a0\": [1, 1, 1]", "particles[1].a0 has 3 numbers for 4 triangles");
  expect_error("\"a0\": 0.7", "\"a0\": [1, 1, 1, 0]", "particles[1].a0 is not positive");
  expect_error("\\[1, 1, 1, 1, 1, 1\\]", "[1, 1, 1, 1, 1]", "theta0 has 5 numbers for 6 edges");
  expect_error("\"edges\": [^\"]*", "", "theta0 is a list, but the particle has no \"edges\"");
  expect_error("\\[2, 3\\]\\]", "[2, 4]]", "edges lacks the edge of the triangles between vertices 2 and 3");
  expect_error("\\[2, 3\\]\\]", "[1, 0]]", "edges[5] is edges[0] again");
  expect_error(", \\[2, 3\\]\\]", "]", "edges has 5 edges, but the triangles have 6");
  expect_error("\"v0\": 0.2", "\"v0\": 0.2, \"sgima\": 1", "unknown key \"sgima\"; did you mean \"sigma\"?");
  expect_error("\\{\"sigma\": 0.5, \"v0\"", "{\"v0\"", "particles[1] has no \"sigma\"");
  expect_error("\"sigma\": 0.5, \"x\"", "\"sigma\": 0.5, \"a0\": 1, \"x\"",
               "particles[0].a0 of a particle that does not deform");
  expect_error("\"sigma\": 0.5, \"x\"", "\"sigma\": 0.5, \"k_v\": 1, \"x\"",
               "particles[0].k_v of a particle that does not deform");
  expect_error("\"k_v\": 1", "\"contact\": \"soft\", \"k_v\": 1", "contact is \"soft\", not rough or smooth");
  expect_error("\"k_v\": 1", "\"contact\": \"rough\", \"case\": {\"contact.kind\": \"smooth\"}, \"k_v\": 1",
               "contact is \"rough\", but \"case\" says");
}

TEST_F(BadSurfacePacking, OneThatIsAloneHasNoCellToSpeakOf) {
  auto json = nlohmann::json::parse(std::ifstream(reference_path("single_shell_42")));
  const auto error = [&](const char* key, const nlohmann::json& value) {
    auto bad = json;
    bad[key] = value;
    write_content(in_folder("p.json"), bad.dump());
    return file_error_of([&] { read_any_packing_json(in_folder("p.json")); });
  };
  EXPECT_THAT(error("strain", 0.1), HasSubstr("strain of no cell"));
  EXPECT_THAT(error("walls", {"floor"}), HasSubstr("walls of no cell"));
  EXPECT_THAT(error("x", {{1, 1, 1}}), HasSubstr("x stands beside the points of a surface"));
  EXPECT_THAT(error("facets", 1), HasSubstr("did you mean \"faces\""));
  json["box"] = 5;
  EXPECT_EQ(error("strain", 0.1), "");
}

}  // namespace
}  // namespace supple
