/// Rows of pixels as a stream of zlib (RFC 1950), in one pass.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace supple {

/// What a drawing is made of are areas of one colour and edges that go on from row to row. So each row is
/// stored as it is or less the row above, whichever has more pixels as the one before, and only these
/// repetitions are looked for, where a compressor for anything searches everywhere. Each block of tokens has
/// its own prefix codes.
class PixelStream {
 public:
  /// Of rows of `width` pixels, three bytes each behind the number of their filter, as in PNG.
  explicit PixelStream(std::size_t width);

  /// Adds a row; of each pixel 0x..RRGGBB the upper byte means nothing.
  void add_row(const std::uint32_t* pixels);
  /// The stream, which ends here.
  std::string finish();

 private:
  /// A pixel (0x00RRGGBB); or, its kind in the upper byte, the filter of a row that begins, or for how many
  /// pixels the last one is repeated.
  using Token = std::uint32_t;
  enum Kind : std::uint32_t { pixel = 0, row_start = 1, again = 2 };

  void repeat(std::size_t pixels);
  void add_checksum(const std::vector<std::uint32_t>& row, std::uint32_t filter);
  void write_block(bool last);

  struct Filtered {
    std::vector<std::uint32_t> row;  ///< with an upper byte of zero
    std::vector<std::uint8_t> same;  ///< whether a pixel is that to its left
  };
  std::size_t width_;  ///< pixels
  std::vector<std::uint32_t> previous_;
  Filtered plain_, less_above_;
  std::uint32_t sum_ = 1, sum_of_sums_ = 0;  ///< of Adler-32
  std::vector<Token> tokens_;
  std::string bytes_;
  std::uint64_t bits_ = 0;  ///< not yet written
  int bit_count_ = 0;
};

}  // namespace supple
