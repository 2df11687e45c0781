/// Pictures of a particle between plates: what touches them is red.
#include <cairo/cairo.h>
#include <gmock/gmock.h>

#include <cstdint>
#include <cstring>

#include "supple/experiment/experiments.hpp"
#include "supple/io/run/file_recorder.hpp"
#include "supple/io/run/run_pictures.hpp"
#include "supple/io/text/case_file.hpp"
#include "tests/io/count_of.hpp"
#include "tests/io/temporary_folder.hpp"

namespace supple {
namespace {

using testing::content_of;
using testing::count_of;

constexpr const char* mark = "fill:rgb(80%,20%,6.666667%)";
constexpr const char* wall = "fill:rgb(60%,60%,60%)";

class PlatePictures : public testing::TemporaryFolder {
 protected:
  RunFile run_of(const std::string& text) {
    const std::string whole = "experiment = \"plate_compression\"\n" + text;
    Case c = read_case_text(whole, "case.toml");
    resolve_family(c);
    experiment_of(c).complete(c);
    FileRecorder recorder(in_folder("run.h5"), c, whole, Existing::replace);
    run(c, nullptr, recorder);
    recorder.finish("complete");
    return RunFile(in_folder("run.h5"));
  }
};

TEST_F(PlatePictures, MarkTheVerticesThatTouch) {
  const RunFile run = run_of(
      "[bodies]\nvertices = 24\n[plates]\nsteps = 6\nstrain = 0.4\ndecompress = false\n[output]\nframes = "
      "2\n");
  const std::vector<double> upper = run.column("plates", "upper_nodes"),
                            lower = run.column("plates", "lower_nodes");
  ASSERT_GT(upper.back(), 2);
  draw_frame(in_folder("a.svg"), run, 1);
  const std::string svg = content_of(in_folder("a.svg"));
  EXPECT_EQ(count_of(svg, mark), upper.back() + lower.back());
  EXPECT_EQ(count_of(svg, wall), 2);
}

/// Pixels of a picture that are red.
int red_pixels(const std::string& png) {
  cairo_surface_t* surface = cairo_image_surface_create_from_png(png.c_str());
  EXPECT_EQ(cairo_surface_status(surface), CAIRO_STATUS_SUCCESS);
  const unsigned char* data = cairo_image_surface_get_data(surface);
  int count = 0;
  for (int y = 0; y < cairo_image_surface_get_height(surface); ++y)
    for (int x = 0; x < cairo_image_surface_get_width(surface); ++x) {
      std::uint32_t pixel;
      std::memcpy(&pixel, data + y * cairo_image_surface_get_stride(surface) + 4 * x, 4);
      const auto red = pixel >> 16 & 255, green = pixel >> 8 & 255;
      count += red > 100 && red > 2 * green;
    }
  cairo_surface_destroy(surface);
  return count;
}

/// Of the undeformed particle on a triangle, three vertices touch the upper plate, seen from above; without
/// its colour, nothing is red.
TEST_F(PlatePictures, MarkThemIn3dToo) {
  const RunFile run = run_of(
      "[bodies]\ndim = 3\nvertices = 42\n[plates]\nsteps = 3\ndecompress = false\n[output]\nframes = 2\n");
  draw_frame(in_folder("a.png"), run, 1, {"", "z"});
  draw_frame(in_folder("b.png"), run, 1, {"volume", "z"});
  EXPECT_GT(red_pixels(in_folder("a.png")), 1000);
  EXPECT_EQ(red_pixels(in_folder("b.png")), 0);
}

}  // namespace
}  // namespace supple
