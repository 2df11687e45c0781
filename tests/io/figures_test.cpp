#include "supple/io/run/figures.hpp"

#include <gmock/gmock.h>

#include "supple/core/error.hpp"
#include "tests/io/body_run.hpp"
#include "tests/io/count_of.hpp"
#include "tests/io/temporary_folder.hpp"

namespace supple {
namespace {

using testing::content_of;
using testing::count_of;

class FigureOfBodies : public testing::TemporaryFolder {
 protected:
  using Rows = std::vector<std::vector<double>>;
  /// The figure of a run with this table, as SVG.
  std::string figure(const Case& c, const std::string& table, const std::vector<Column>& columns,
                     const Rows& rows, const std::vector<std::pair<std::string, double>>& results = {}) {
    const std::string run = in_folder("run.h5");
    FileRecorder recorder(run, c, "", Existing::replace);
    testing::record_bodies(recorder, 1);
    recorder.declare(table, columns);
    for (const auto& row : rows) recorder.append(table, row);
    for (const auto& [name, value] : results) recorder.value("results", {name, "", ""}, value);
    recorder.finish("complete");
    draw_figure(in_folder("a.svg"), RunFile(run));
    return content_of(in_folder("a.svg"));
  }
  /// Points of a colour of line_palette: filled circles.
  static int points(const std::string& svg, const std::string& rgb) {
    return count_of(svg, "fill:rgb(" + rgb + ")");
  }
};

constexpr const char* blue = "26.666667%,46.666667%,66.666667%";
constexpr const char* red = "93.333333%,40%,46.666667%";
const std::vector<Column> pressure_columns{
    {"packing_fraction", "", ""}, {"pressure", "k_a a0", ""}, {"branch", "", ""}};

TEST_F(FigureOfBodies, CompressionShowsBothBranchesThatMeetAtTheTop) {
  const FigureOfBodies::Rows rows{
      {0.84, 1e-7, 1}, {0.85, 1e-3, 1}, {0.90, 1e-2, 1}, {0.852, 1e-3, -1}, {0.843, 1e-7, -1}};
  const std::string svg = figure(testing::body_case("compression"), "packing", pressure_columns, rows);
  EXPECT_EQ(points(svg, blue), 3 + 1);  // and the legend's
  EXPECT_EQ(points(svg, red), 3 + 1);
  EXPECT_EQ(count_of(svg, "stroke-dasharray"), 0);
  const std::string fitted = figure(testing::body_case("compression"), "packing", pressure_columns, rows,
                                    {{"onset_compression", 0.84}, {"slope_compression", 0.1}});
  EXPECT_EQ(count_of(fitted, "stroke-dasharray"), 1);
}

TEST_F(FigureOfBodies, JammingShowsPressuresNearTheWantedOne) {
  Case c = testing::body_case("jamming");
  c.jamming.pressure = 1e-4;
  const FigureOfBodies::Rows rows{
      {0.1, 0, 0}, {0.8, 1e-15, 0}, {0.84, 3e-5, 0}, {0.85, 3e-4, 0}, {0.845, 1.005e-4, 0}};
  const std::string svg = figure(c, "packing", pressure_columns, rows);
  EXPECT_EQ(points(svg, blue), 3 + 1);
  EXPECT_EQ(count_of(svg, "stroke-dasharray"), 2);  // the wanted pressure and its legend
}

TEST_F(FigureOfBodies, UniaxialCompressionShowsForceAgainstStrain) {
  const std::string svg = figure(testing::body_case("uniaxial_compression"), "packing",
                                 {{"strain", "", ""}, {"wall_force", "", ""}, {"contact_length", "", ""}},
                                 {{0, 0, 0}, {0.1, 0.2, 2}, {0.2, 0.5, 3}});
  EXPECT_GT(count_of(svg, "stroke:rgb(" + std::string(blue) + ")"), 1);
}

/// Loading as points, unloading as a line, two guides; without unloading no line of it.
TEST_F(FigureOfBodies, PlatesShowForceAgainstCompressionWithGuides) {
  const Case c = testing::body_case("plate_compression");
  const std::vector<Column> columns{{"compression", "", ""}, {"force", "k_a a0 D", ""}, {"branch", "", ""}};
  const FigureOfBodies::Rows down{{0, 0, 1}, {1e-3, 1e-4, 1}, {1e-2, 1e-3, 1}, {1e-1, 2e-2, 1}};
  FigureOfBodies::Rows both = down;
  both.insert(both.end(), {{1e-2, 5e-4, -1}, {1e-3, 0, -1}, {1e-4, 1e-5, -1}});
  const std::string loading = figure(c, "plates", columns, down), svg = figure(c, "plates", columns, both);
  EXPECT_EQ(points(loading, blue), 3 + 1);  // one is at compression 0; the legend has one more
  EXPECT_EQ(points(svg, blue), 3 + 1);
  EXPECT_EQ(count_of(loading, "stroke-dasharray"), 1 + 1);
  const std::string line = "stroke:rgb(" + std::string(red) + ")";
  EXPECT_EQ(count_of(loading, line), 0);
  EXPECT_EQ(count_of(svg, line), 1 + 1);
}

TEST_F(FigureOfBodies, MotionsShowEnergiesAndTheHeap) {
  const std::vector<Column> columns{
      {"time", "", ""},         {"potential_energy", "", ""}, {"kinetic_energy", "", ""},
      {"total_energy", "", ""}, {"pressure", "k_a a0", ""},   {"front", "", ""},
      {"top", "", ""}};
  const FigureOfBodies::Rows rows{{0, 1, 2, 3, 0.1, 5, 6}, {1, 2, 1, 3, 0.2, 7, 4}};
  for (const std::string experiment : {"dynamics", "slump"}) {
    const std::string svg = figure(testing::body_case(experiment), "motion", columns, rows);
    const int legend = experiment == "slump" ? 5 : 3;
    EXPECT_GE(count_of(svg, "stroke:rgb("), 4 + legend) << experiment;
  }
}

TEST_F(FigureOfBodies, RefusesARunWithNothingToShow) {
  try {
    figure(testing::body_case("dynamics"), "motion", {{"time", "", ""}}, {{0}});
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::input);
    EXPECT_THAT(e.what(), ::testing::HasSubstr("less than two rows of its table 'motion'"));
  }
}

std::string_view subject_of(const Case& c) { return figure_subject(experiment_of(c).figure(c)); }

TEST(FigureSubject, NamesTheFile) {
  EXPECT_EQ(subject_of(testing::body_case("jamming")), "pressure");
  EXPECT_EQ(subject_of(testing::body_case("slump")), "energy");
  EXPECT_EQ(subject_of(testing::body_case("uniaxial_compression")), "force");
  EXPECT_EQ(subject_of(testing::body_case("plate_compression")), "force");
}

}  // namespace
}  // namespace supple
