#include "supple/draw/canvas/png.hpp"

#include <png.h>

#include <vector>

#include "supple/core/checksum.hpp"
#include "supple/core/error.hpp"

namespace supple {

namespace {

std::string big_endian(std::size_t x) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(x >> shift & 0xff);
  return bytes;
}

std::vector<std::uint8_t> in_rgb(const PixelRows& pixels) {
  std::vector<std::uint8_t> out;
  out.reserve(3 * pixels.width * pixels.height);
  for (std::size_t y = 0; y < pixels.height; ++y)
    for (std::size_t x = 0; x < pixels.width; ++x)
      for (const int shift : {16, 8, 0})
        out.push_back(static_cast<std::uint8_t>(pixels.first[y * pixels.stride + x] >> shift));
  return out;
}

}  // namespace

std::string png_chunk(const std::string& type, std::string_view data) {
  std::string chunk = big_endian(data.size());
  chunk.append(type).append(data);
  return chunk += big_endian(checksum(std::string_view(chunk).substr(4)));
}

std::string encode_png(const PixelRows& pixels) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(pixels.width);
  image.height = static_cast<png_uint_32>(pixels.height);
  image.format = PNG_FORMAT_RGB;
  // No filter and little search: drawings have large areas of one colour, which are found anyway.
  image.flags = PNG_IMAGE_FLAG_FAST;
  const std::vector<std::uint8_t> colors = in_rgb(pixels);
  std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(image), '\0');
  png_alloc_size_t size = bytes.size();
  const bool written = png_image_write_to_memory(&image, bytes.data(), &size, 0, colors.data(), 0, nullptr);
  const std::string message = image.message;
  png_image_free(&image);
  if (!written) throw file_error("the picture cannot be encoded as PNG", message);
  bytes.resize(size);
  return bytes;
}

}  // namespace supple
