/// Rows of pixels as a stream of zlib (RFC 1950), in one pass.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace supple {

/// What a drawing is made of are areas of one colour and edges that go on from row to row. So only two
/// repetitions are looked for, of the pixel to the left and of the row above, where a compressor for anything
/// searches everywhere. Each block of tokens has its own prefix codes.
class PixelStream {
 public:
  /// Of rows of `width` pixels, three bytes each behind a zero, which is the filter "none" of PNG.
  explicit PixelStream(std::size_t width);

  /// Adds a row; of each pixel 0x..RRGGBB the upper byte means nothing.
  void add_row(const std::uint32_t* pixels);
  /// The stream, which ends here.
  std::string finish();

 private:
  /// A pixel (0x00RRGGBB); or, `kind` in the upper byte, the zero before a row, or so many pixels again.
  using Token = std::uint32_t;
  enum Kind : std::uint32_t { pixel = 0, row_start = 1, as_left = 2, as_above = 3 };

  void repeat(Kind kind, std::size_t pixels);
  void add_checksum();
  void write_block(bool last);

  std::size_t width_, above_ = 0;              ///< pixels; bytes from a pixel to the one above, 0: too far
  std::vector<std::uint32_t> row_, previous_;  ///< with an upper byte of zero
  std::vector<std::uint8_t> same_left_, same_above_;  ///< whether pixels repeat
  bool first_ = true;
  std::uint32_t sum_ = 1, sum_of_sums_ = 0;  ///< of Adler-32
  std::vector<Token> tokens_;
  std::string bytes_;
  std::uint64_t bits_ = 0;  ///< not yet written
  int bit_count_ = 0;
};

}  // namespace supple
