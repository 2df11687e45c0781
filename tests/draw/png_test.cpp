#include "supple/draw/canvas/png.hpp"

#include <cairo.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <random>
#include <vector>

namespace supple {
namespace {

struct Picture {
  std::size_t width, height;
  std::vector<std::uint32_t> pixels;

  PixelRows rows() const { return {pixels.data(), width, height, width}; }
};

/// Areas, edges and noise: `noise` of the pixels are any colour, the others in areas that go on in rows
/// below.
Picture sample(std::size_t width, std::size_t height, double noise, unsigned seed) {
  std::mt19937 random(seed);
  Picture p{width, height, std::vector<std::uint32_t>(width * height)};
  std::bernoulli_distribution is_noise(noise), changes(0.02);
  for (std::size_t i = 0; i < p.pixels.size(); ++i)
    p.pixels[i] = is_noise(random) || i == 0        ? random()
                  : changes(random) && i >= width   ? random() % 7 * 0x203040
                  : i >= width && random() % 2 == 0 ? p.pixels[i - width]
                                                    : p.pixels[i - 1];
  return p;
}

/// What libpng, by Cairo, reads from the bytes; the upper byte is zero.
Picture read_png(const std::string& bytes) {
  struct Source {
    const std::string& bytes;
    std::size_t at = 0;
  } source{bytes};
  const auto take = [](void* from, unsigned char* data, unsigned length) {
    auto& s = *static_cast<Source*>(from);
    if (length > s.bytes.size() - s.at) return CAIRO_STATUS_READ_ERROR;
    std::memcpy(data, s.bytes.data() + s.at, length);
    s.at += length;
    return CAIRO_STATUS_SUCCESS;
  };
  cairo_surface_t* image = cairo_image_surface_create_from_png_stream(take, &source);
  EXPECT_EQ(cairo_surface_status(image), CAIRO_STATUS_SUCCESS);
  EXPECT_EQ(source.at, bytes.size());
  Picture p{static_cast<std::size_t>(cairo_image_surface_get_width(image)),
            static_cast<std::size_t>(cairo_image_surface_get_height(image)),
            {}};
  const std::size_t stride = static_cast<std::size_t>(cairo_image_surface_get_stride(image)) / 4;
  const auto* data = reinterpret_cast<const std::uint32_t*>(cairo_image_surface_get_data(image));
  for (std::size_t y = 0; y < p.height; ++y)
    for (std::size_t x = 0; x < p.width; ++x) p.pixels.push_back(data[y * stride + x] & 0xffffff);
  cairo_surface_destroy(image);
  return p;
}

void expect_round_trip(const Picture& p) {
  const Picture back = read_png(encode_png(p.rows()));
  ASSERT_EQ(back.width, p.width);
  ASSERT_EQ(back.height, p.height);
  for (std::size_t i = 0; i < p.pixels.size(); ++i)
    ASSERT_EQ(back.pixels[i], p.pixels[i] & 0xffffff) << i << " of " << p.width << " x " << p.height;
}

TEST(Png, HoldsEveryPixel) {
  for (const std::size_t width : {1, 2, 3, 85, 86, 87, 172, 173, 601, 10922, 10923, 32767})
    for (const double noise : {0.0, 0.01, 0.3, 1.0})
      expect_round_trip(sample(width, width > 700 ? 3 : 40, noise, 1));
}

TEST(Png, HoldsPicturesOfManyBlocks) { expect_round_trip(sample(700, 500, 0.5, 2)); }

TEST(Png, HoldsWhatIsAllTheSame) {
  for (const std::uint32_t color : {0u, 0xffffffu, 0xab123456u})
    expect_round_trip({300, 200, std::vector<std::uint32_t>(300 * 200, color)});
}

TEST(Png, RowsMayLieApart) {
  const Picture p = sample(50, 20, 0.1, 3);
  const Picture part{40, 20, {}};
  const Picture back = read_png(encode_png({p.pixels.data(), part.width, part.height, p.width}));
  for (std::size_t y = 0; y < part.height; ++y)
    for (std::size_t x = 0; x < part.width; ++x)
      ASSERT_EQ(back.pixels[y * part.width + x], p.pixels[y * p.width + x] & 0xffffff);
}

TEST(Png, HasTheSameBytesEachTime) {
  const Picture p = sample(400, 300, 0.1, 4);
  EXPECT_EQ(encode_png(p.rows()), encode_png(p.rows()));
}

TEST(Png, AreasTakeFewBytes) {
  EXPECT_LT(encode_png({std::vector<std::uint32_t>(1000, 0xffffff).data(), 1000, 1, 1000}).size(), 300u);
  const Picture page{1000, 1000, std::vector<std::uint32_t>(1000 * 1000, 0xffffff)};
  EXPECT_LT(encode_png(page.rows()).size(), 20000u);
  Picture stripes = sample(1000, 1, 1, 6);  // edges that go on from row to row
  while (stripes.height++ < 1000)
    stripes.pixels.insert(stripes.pixels.end(), stripes.pixels.begin(), stripes.pixels.begin() + 1000);
  EXPECT_LT(encode_png({stripes.pixels.data(), 1000, 1000, 1000}).size(), 30000u);
  const Picture noise = sample(1000, 300, 1, 5);
  EXPECT_LT(encode_png(noise.rows()).size(), 1.01 * 3 * 1000 * 300);
}

}  // namespace
}  // namespace supple
