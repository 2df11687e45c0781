#include "supple/io/run/picture_mark.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstdint>

#include "supple/core/error.hpp"
#include "supple/core/new_file.hpp"
#include "supple/core/path_kind.hpp"
#include "supple/draw/canvas/canvas.hpp"
#include "supple/draw/canvas/png.hpp"

namespace supple {

namespace {

constexpr std::size_t largest_picture = std::size_t{1} << 28;

/// FNV-1a, 64 bits.
class Digest {
 public:
  void add(std::string_view bytes) {
    for (const unsigned char c : bytes) hash_ = (hash_ ^ c) * 0x100000001b3;
  }
  void add(std::int64_t x) { add_bits(static_cast<std::uint64_t>(x)); }
  void add(double x) { add_bits(std::bit_cast<std::uint64_t>(x)); }
  std::uint64_t value() const { return hash_; }

 private:
  void add_bits(std::uint64_t bits) {
    for (int byte = 0; byte < 8; ++byte) hash_ = (hash_ ^ (bits >> 8 * byte & 0xff)) * 0x100000001b3;
  }
  std::uint64_t hash_ = 0xcbf29ce484222325;
};

std::string png_text(const std::string& text) {
  return png_chunk("tEXt", std::string("Source") + '\0' + text);
}

std::string jpeg_comment(const std::string& text) {
  const std::size_t size = text.size() + 2;
  return std::string("\xff\xfe") + static_cast<char>(size >> 8) + static_cast<char>(size & 0xff) + text;
}

/// Behind the first two segments: the start of the image, and the header that comes with it.
std::size_t behind_jpeg_header(const std::string& bytes) {
  const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(bytes.at(at)); };
  return 4 + static_cast<std::size_t>(byte(4) << 8 | byte(5));
}

/// Where the sites of the run end.
template <int Dim>
void add_last_positions(const RunFile& run, Digest& digest) {
  for (const Vec<Dim>& x : run.final_state<Dim>().first.state.position)
    for (int d = 0; d < Dim; ++d) digest.add(x[d]);
}

constexpr std::size_t png_end = 12;  // bytes of the last chunk, IEND

}  // namespace

std::string mark_of(const RunFile& run) {
  Digest digest;
  digest.add(run.version() + "\n" + run.case_text() + "\n" + run.status());
  digest.add(run.frames());
  for (const std::string& group : run.value_groups())
    for (const RunValue& v : run.values(group)) {
      if (v.name.name == "cpu_time") continue;
      digest.add(v.name.name);
      digest.add(v.value);
    }
  if (run.has_final_state()) {
    if (run.dimensions() == 2) add_last_positions<2>(run, digest);
    else add_last_positions<3>(run, digest);
  }
  return fmt::format("Supple run {:016x}", digest.value());
}

void mark_picture(const std::string& path, const std::string& mark) {
  std::string bytes = read_whole_file(path, "a picture", largest_picture);
  switch (picture_format(path)) {
    case PictureFormat::png: bytes.insert(bytes.size() - png_end, png_text(mark)); break;
    case PictureFormat::jpg: bytes.insert(behind_jpeg_header(bytes), jpeg_comment(mark)); break;
    case PictureFormat::svg: bytes += "<!-- " + mark + " -->\n"; break;
    case PictureFormat::pdf:
    case PictureFormat::ps: bytes += "% " + mark + "\n"; break;
  }
  write_whole_file(path, bytes);
}

bool is_marked(const std::string& path, const std::string& mark) {
  if (path_kind(path) != PathKind::file) return false;
  try {
    return read_whole_file(path, "a picture", largest_picture).find(mark) != std::string::npos;
  } catch (const Error&) {  // what cannot be read is not ours
    return false;
  }
}

}  // namespace supple
