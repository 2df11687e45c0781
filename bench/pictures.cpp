#include "bench/pictures.hpp"

#include <fmt/core.h>
#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <functional>
#include <limits>
#include <vector>

#include "bench/machine.hpp"
#include "supple/core/new_file.hpp"
#include "supple/core/path_kind.hpp"
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

std::uint32_t big_endian(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (int k = 0; k < 4; ++k) value = value << 8 | static_cast<unsigned char>(bytes[at + k]);
  return value;
}

/// A picture that Supple wrote: the bytes of its rows as they are, and its pixels.
struct Picture {
  std::size_t width, height, file_bytes;
  std::vector<unsigned char> rows;
  std::vector<std::uint32_t> pixels;

  explicit Picture(const std::string& path) {
    const std::string bytes = read_whole_file(path, "a picture", std::size_t{1} << 28);
    width = big_endian(bytes, 16);
    height = big_endian(bytes, 20);
    file_bytes = bytes.size();
    std::string stream;
    for (std::size_t at = 8; at < bytes.size(); at += 12 + big_endian(bytes, at))
      if (bytes.compare(at + 4, 4, "IDAT") == 0) stream += bytes.substr(at + 8, big_endian(bytes, at));
    rows.resize((3 * width + 1) * height);
    uLongf size = rows.size();
    uncompress(rows.data(), &size, reinterpret_cast<const Bytef*>(stream.data()), stream.size());
    const std::size_t length = 3 * width + 1;
    for (std::size_t y = 0; y < height; ++y) {
      unsigned char* row = &rows[y * length];
      for (std::size_t k = 1; row[0] == 2 && y > 0 && k < length; ++k) row[k] += (row - length)[k];
      row[0] = 0;
      for (const unsigned char* p = row + 1; p < row + length; p += 3)
        pixels.push_back(p[0] << 16 | p[1] << 8 | p[2]);
    }
  }
};

void print_encoding(const char* name, const Picture& picture) {
  std::size_t bytes = 0;
  const double ours = milliseconds(
      [&] {
        bytes = encode_png({picture.pixels.data(), picture.width, picture.height, picture.width}).size();
      },
      15);
  std::vector<std::uint32_t> copy(picture.pixels.size());
  const double copied =
      milliseconds([&] { std::memcpy(copy.data(), picture.pixels.data(), 4 * copy.size()); }, 15);
  std::vector<Bytef> packed(compressBound(picture.rows.size()));
  const auto zlib = [&](int level) {
    uLongf size = packed.size();
    const double time = milliseconds(
        [&] {
          size = packed.size();
          compress2(packed.data(), &size, picture.rows.data(), picture.rows.size(), level);
        },
        level == 1 ? 10 : 3);
    return std::pair(time, static_cast<double>(size));
  };
  const auto [fast, fast_bytes] = zlib(1);
  const auto [usual, usual_bytes] = zlib(6);
  fmt::print("  {:<9}{:>5} x {:<5}{:>8.2f}{:>10.2f}{:>10.1f}{:>10.1f}{:>13.2f}{:>8.2f}\n", name,
             picture.width, picture.height, ours, copied, fast, usual,
             static_cast<double>(bytes) / usual_bytes, fast_bytes / usual_bytes);
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
  fmt::print("\nTheir pixels as PNG, CPU ms; bytes relative to level 6 of zlib\n");
  fmt::print("  {:<22}{:>8}{:>10}{:>10}{:>10}{:>13}{:>8}\n", "", "Supple", "copy", "level 1", "level 6",
             "Supple/6", "1/6");
  print_encoding("figure", Picture(in_folder("plot.png")));
  print_encoding("cell", Picture(in_folder("cell.png")));
  std::filesystem::remove_all(folder);
}

}  // namespace supple::bench
