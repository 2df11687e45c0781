#include "bench/pictures.hpp"

#include <fmt/core.h>
#include <png.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <functional>
#include <limits>
#include <vector>

#include "bench/machine.hpp"
#include "supple/core/error.hpp"
#include "supple/core/new_file.hpp"
#include "supple/draw/canvas/png.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/io/run/file_recorder.hpp"
#include "supple/io/run/run_pictures.hpp"

namespace supple::bench {
namespace {

double milliseconds(const std::function<void()>& work, int repeats) {
  double best = std::numeric_limits<double>::infinity();
  for (int k = 0; k < repeats; ++k) {
    const double start = cpu_seconds();
    work();
    best = std::min(best, 1e3 * (cpu_seconds() - start));
  }
  return best;
}

/// The pixels of a picture that Supple wrote.
struct Picture {
  std::size_t width = 0, height = 0;
  std::vector<std::uint32_t> pixels;

  explicit Picture(const std::string& path) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    if (!png_image_begin_read_from_file(&image, path.c_str())) throw file_error(path, image.message);
    image.format = PNG_FORMAT_BGRA;  // 0xAARRGGBB
    width = image.width;
    height = image.height;
    pixels.resize(width * height);
    if (!png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr))
      throw file_error(path, image.message);
  }
};

/// The limit of an encoder is to meet every pixel once.
void print_encoding(const char* name, const Picture& picture) {
  const double encoded = milliseconds(
      [&] {
        encode_png({picture.pixels.data(), picture.width, picture.height, picture.width});
      },
      15);
  std::vector<std::uint32_t> copy(picture.pixels.size());
  const double copied =
      milliseconds([&] { std::memcpy(copy.data(), picture.pixels.data(), 4 * copy.size()); }, 15);
  fmt::print("  {:<9}{:>5} x {:<5}{:>8.1f}{:>10.2f}\n", name, picture.width, picture.height, encoded, copied);
}

}  // namespace

void print_pictures() {
  const auto folder = std::filesystem::temp_directory_path() / "supple_bench_pictures";
  std::filesystem::create_directories(folder);
  const auto in_folder = [&](const char* name) { return (folder / name).string(); };
  const std::string path = in_folder("run.h5");
  const double without = milliseconds(
      [&] {
        FileRecorder recorder(path, Case{}, "", Existing::replace);
        run(Case{}, nullptr, recorder);
        recorder.finish("complete");
      },
      3);
  const double plot = milliseconds([&] { draw_run_plot(in_folder("plot.png"), RunFile(path)); }, 5);
  const double cell = milliseconds(
      [&] {
        const RunFile run(path);
        const std::vector<double> strains = run.strains();
        draw_frame(in_folder("cell.png"), run, std::ranges::max_element(strains) - strains.begin());
      },
      5);
  const int images = 20;
  const double film =
      milliseconds([&] { draw_frames(folder.string(), "png", RunFile(path), images); }, 2) / images;

  fmt::print("\nPictures of the default oscillatory run, CPU ms and in shares of the run without them\n");
  fmt::print(
      "  run {:.0f}; figure {:.1f} ({:.1f} %), cell {:.1f} ({:.1f} %); of a film, each {:.1f} ({:.1f} %)\n",
      without, plot, 100 * plot / without, cell, 100 * cell / without, film, 100 * film / without);
  fmt::print("\nTheir pixels, CPU ms\n");
  fmt::print("  {:<22}{:>8}{:>10}\n", "", "as PNG", "copied");
  print_encoding("figure", Picture(in_folder("plot.png")));
  print_encoding("cell", Picture(in_folder("cell.png")));
  std::filesystem::remove_all(folder);
}

}  // namespace supple::bench
