#include "supple/draw/canvas/png.hpp"

#include <algorithm>
#include <string_view>

#include "supple/core/checksum.hpp"
#include "supple/draw/canvas/pixel_stream.hpp"

namespace supple {

namespace {

constexpr std::size_t most_in_chunk = std::size_t{1} << 24;  // bytes; lengths are below 2^31

std::string big_endian(std::size_t x) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(x >> shift & 0xff);
  return bytes;
}

}  // namespace

std::string png_chunk(const std::string& type, std::string_view data) {
  std::string chunk = big_endian(data.size());
  chunk.append(type).append(data);
  return chunk += big_endian(checksum(std::string_view(chunk).substr(4)));
}

std::string encode_png(const PixelRows& pixels) {
  PixelStream stream(pixels.width);
  for (std::size_t y = 0; y < pixels.height; ++y) stream.add_row(pixels.first + y * pixels.stride);
  const std::string data = stream.finish();

  std::string bytes = "\x89PNG\r\n\x1a\n";
  // eight bits of each colour, RGB, and the one way there is to compress, filter, and not interlace
  bytes += png_chunk("IHDR",
                     big_endian(pixels.width) + big_endian(pixels.height) + std::string("\x08\x02\0\0\0", 5));
  for (std::size_t from = 0; from < data.size(); from += most_in_chunk)
    bytes += png_chunk("IDAT", std::string_view(data).substr(from, most_in_chunk));
  return bytes += png_chunk("IEND", "");
}

}  // namespace supple
