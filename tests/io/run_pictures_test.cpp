#include "supple/io/run/run_pictures.hpp"

#include <gtest/gtest.h>

#include "supple/core/error.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/io/run/file_recorder.hpp"
#include "tests/io/count_of.hpp"
#include "tests/io/temporary_folder.hpp"

namespace supple {
namespace {

using testing::content_of;
using testing::count_of;

/// A real run of a few discs, for all tests of this file.
class RunPicturesTest : public testing::TemporaryFolder {
 protected:
  RunFile make_run(const std::string& experiment, const std::string& rate = "0") {
    Case c;
    c.general.experiment = experiment;
    c.particles.discs = 12;
    c.particles.permanent_links = false;
    c.shear.pre_periods = c.shear.post_periods = 1;
    c.shear.rate = rate;
    c.time.steps = 50;
    c.output.frames = 8;
    FileRecorder recorder(in_folder("run.h5"), c, "");
    run(c, nullptr, recorder);
    recorder.finish("complete");
    return RunFile(in_folder("run.h5"));
  }
};

constexpr const char* last_cycle = "stroke:rgb(10.588235%,30.980392%,50.980392%)";

TEST_F(RunPicturesTest, OscillatoryRunGivesLoopSnapshotAndImages) {
  const RunFile run = make_run("oscillatory_shear");
  draw_run_plot(in_folder("plot.svg"), run);
  EXPECT_EQ(count_of(content_of(in_folder("plot.svg")), last_cycle), 2);  // the loop and its legend
  draw_frame(in_folder("cell.pdf"), run, run.frames() - 1);
  EXPECT_THROW(draw_frame(in_folder("cell.pdf"), run, run.frames()), Error);
  const std::size_t before = files();
  EXPECT_EQ(draw_frames(folder(), "svg", run, 3), 3);
  EXPECT_EQ(files(), before + 3);
}

/// The picture of the most sheared frame is found by these, without reading the frames.
TEST_F(RunPicturesTest, StrainsAreThoseOfTheFrames) {
  const RunFile run = make_run("oscillatory_shear");
  std::vector<double> of_frames;
  for (std::int64_t k = 0; k < run.frames(); ++k) of_frames.push_back(run.frame(k).strain);
  EXPECT_EQ(run.strains(), of_frames);
  EXPECT_GT(std::ranges::max(of_frames), 0.1);
}

TEST_F(RunPicturesTest, DiscsHaveTheColoursOfTheNumbersOfTheirFrames) {
  const RunFile run = make_run("dynamics", "1000");
  EXPECT_EQ(run.unit_of_bodies("stress_xx"), "Pa");
  const auto fills = [&](const std::string& color, const std::string& rgb) {
    draw_frame(in_folder("a.svg"), run, run.frames() - 1, {color});
    return count_of(content_of(in_folder("a.svg")), "fill:rgb(" + rgb + ")");
  };
  const std::string lowest = "99.607843%,98.431373%,91.372549%", single = "86.666667%,86.666667%,86.666667%";
  EXPECT_GE(fills("stress_xx", lowest), 1);
  EXPECT_EQ(fills("stress_xx", single), 0);
  EXPECT_GE(fills("id", single), 12);
  try {
    draw_frame(in_folder("a.svg"), run, 0, {"shape_parameter"});
    FAIL();
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("choose from 'id', 'stress_xx'"), std::string::npos) << e.what();
  }
}

TEST_F(RunPicturesTest, DynamicsGivesStressAgainstTime) {
  draw_run_plot(in_folder("plot.svg"), make_run("dynamics", "1000"));
  EXPECT_EQ(count_of(content_of(in_folder("plot.svg")), last_cycle), 0);
}

}  // namespace
}  // namespace supple
