#include "supple/draw/canvas/pixel_stream.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "supple/draw/canvas/prefix_code.hpp"

namespace supple {

namespace {

constexpr std::size_t block_tokens = 1 << 15;
constexpr std::size_t longest_run = 86;  // pixels: 258 bytes, the longest repetition
constexpr int end_of_block = 256, first_length = 257, literals = 286, distances = 30, length_limit = 15;
constexpr std::uint32_t adler_modulus = 65521;

/// A symbol with the bits that follow its code.
struct Symbol {
  int code, extra_bits;
  std::uint32_t extra;
};

/// Of a repetition from three bytes back, a pixel.
constexpr Symbol one_pixel_back{2, 0, 0};

/// RFC 1951, section 3.2.5, lengths of 3 to 258: codes in fours; 258 has one of its own.
Symbol length_symbol(std::size_t length) {
  if (length == 258) return {first_length + 28, 0, 0};
  const auto d = static_cast<std::uint32_t>(length - 3);
  if (d < 8) return {first_length + static_cast<int>(d), 0, 0};
  const int bits = std::bit_width(d) - 3;
  return {first_length + 4 * bits + 4 + static_cast<int>(d >> bits & 3), bits, d & ((1u << bits) - 1)};
}

/// Bits to write, the first one lowest.
struct Bits {
  std::uint64_t value = 0;
  int count = 0;

  Bits& operator+=(const Bits& more) {
    value |= more.value << count;
    count += more.count;
    return *this;
  }
};

struct Code {
  std::vector<std::uint8_t> lengths;
  std::vector<std::uint16_t> codes;

  Code(std::span<const std::uint32_t> counts, int limit)
      : lengths(code_lengths(counts, limit)), codes(codes_of(lengths)) {}
  Bits operator[](int symbol) const { return {codes[symbol], lengths[symbol]}; }
  Bits operator()(const Symbol& s) const { return (*this)[s.code] += Bits{s.extra, s.extra_bits}; }
};

/// Writes whole bytes of what it gets; what is left is handed on.
class BitWriter {
 public:
  BitWriter(std::string& bytes, std::size_t room, std::uint64_t bits, int count)
      : bytes_(bytes), bits_{bits, count} {
    const std::size_t size = bytes.size();
    bytes.resize(size + room);
    at_ = bytes.data() + size;
  }
  /// At most 56 bits.
  void put(const Bits& more) {
    bits_ += more;
    std::uint64_t lowest_first = bits_.value;
    if constexpr (std::endian::native == std::endian::big) lowest_first = __builtin_bswap64(lowest_first);
    std::memcpy(at_, &lowest_first, 8);
    at_ += bits_.count >> 3;
    bits_.value >>= bits_.count & ~7;
    bits_.count &= 7;
  }
  /// Cuts `bytes` behind the last whole one; returns the bits after it.
  Bits finish() {
    bytes_.resize(static_cast<std::size_t>(at_ - bytes_.data()));
    return bits_;
  }

 private:
  std::string& bytes_;
  char* at_;
  Bits bits_;
};

/// The head of a block with codes of its own (RFC 1951, section 3.2.7), without repetitions among the
/// lengths.
void put_head(BitWriter& out, bool last, const Code& literal, const Code& distance) {
  constexpr std::array<int, 19> order{16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15};
  std::array<std::uint32_t, 19> counts{};
  for (const Code* code : {&literal, &distance})
    for (const std::uint8_t length : code->lengths) ++counts[length];
  const Code length_code(counts, 7);
  out.put({last ? 1u : 0u, 1});
  out.put({2, 2});
  out.put({literals - first_length, 5});
  out.put({distances - 1, 5});
  out.put({order.size() - 4, 4});
  for (const int symbol : order) out.put({length_code.lengths[symbol], 3});
  for (const Code* code : {&literal, &distance})
    for (const std::uint8_t length : code->lengths) out.put(length_code[length]);
}

void compare(const std::uint32_t* row, const std::uint32_t* other, std::size_t count, std::uint8_t* same) {
  for (std::size_t x = 0; x < count; ++x) same[x] = row[x] == other[x];
}

/// From `x` on, how many of these are 1.
std::size_t run_of(const std::vector<std::uint8_t>& same, std::size_t x) {
  if (same[x] == 0) return 0;
  const void* end = std::memchr(&same[x], 0, same.size() - x);
  return end ? static_cast<std::size_t>(static_cast<const std::uint8_t*>(end) - &same[x]) : same.size() - x;
}

/// Bytes of one pixel less those of the other, each by itself.
std::uint32_t difference(std::uint32_t a, std::uint32_t b) {
  return (((a | 0x80808080) - (b & 0x7f7f7f7f)) ^ ((a ^ ~b) & 0x80808080)) & 0xffffff;
}

/// What a row takes, about, in codes: two for a pixel, one for a run of pixels as before.
std::size_t cost_of(const std::vector<std::uint8_t>& same) {
  std::size_t pixels = 0, runs = 0;
  for (const std::uint8_t s : same) pixels += s == 0;
  for (std::size_t x = 1; x < same.size(); ++x) runs += same[x] > same[x - 1];
  return 2 * pixels + runs;
}

}  // namespace

PixelStream::PixelStream(std::size_t width) : width_(width), previous_(width) {
  for (Filtered* way : {&plain_, &less_above_})
    *way = {std::vector<std::uint32_t>(width), std::vector<std::uint8_t>(width)};
  tokens_.reserve(block_tokens + width + 1);
  bytes_ = "\x78\x01";  // 32 KiB of memory; fastest
}

void PixelStream::add_row(const std::uint32_t* pixels) {
  if (tokens_.size() >= block_tokens) write_block(false);
  std::swap(plain_.row, previous_);
  for (std::size_t x = 0; x < width_; ++x) plain_.row[x] = pixels[x] & 0xffffff;
  for (std::size_t x = 0; x < width_; ++x) less_above_.row[x] = difference(plain_.row[x], previous_[x]);
  for (Filtered* way : {&plain_, &less_above_})
    if (width_ > 1) compare(&way->row[1], &way->row[0], width_ - 1, &way->same[1]);
  const bool is_plain = cost_of(plain_.same) <= cost_of(less_above_.same);
  const auto& [row, same] = is_plain ? plain_ : less_above_;
  const std::uint32_t filter = is_plain ? 0 : 2;  // "none" and "up" of PNG
  add_checksum(row, filter);

  tokens_.push_back(row_start << 24 | filter);
  for (std::size_t x = 0; x < width_;) {
    const std::size_t run = run_of(same, x);
    if (run == 0) tokens_.push_back(row[x++]);
    else repeat(run);
    x += run;
  }
}

void PixelStream::repeat(std::size_t pixels) {
  for (; pixels > longest_run; pixels -= longest_run) tokens_.push_back(again << 24 | longest_run);
  tokens_.push_back(again << 24 | static_cast<std::uint32_t>(pixels));
}

/// Adler-32 (RFC 1950, section 8.2) of the filter and the row: of bytes c[0..n), the first sum grows by the
/// sum of c[i], the second by n times the first as it was and the sum of (n - i) c[i].
void PixelStream::add_checksum(const std::vector<std::uint32_t>& row, std::uint32_t filter) {
  const std::uint64_t n = 3 * width_ + 1;
  std::uint64_t sum = filter, weighted = n * filter;
  for (std::size_t x = 0; x < width_; ++x) {
    const std::uint64_t red = row[x] >> 16, green = row[x] >> 8 & 0xff, blue = row[x] & 0xff;
    const std::uint64_t all = red + green + blue;
    sum += all;
    weighted += (3 * (width_ - x)) * all - green - 2 * blue;
  }
  sum_of_sums_ = static_cast<std::uint32_t>(
      (sum_of_sums_ + n % adler_modulus * sum_ + weighted % adler_modulus) % adler_modulus);
  sum_ = static_cast<std::uint32_t>((sum_ + sum) % adler_modulus);
}

void PixelStream::write_block(bool last) {
  std::array<std::uint32_t, literals> literal_counts{};
  std::array<std::uint32_t, distances> distance_counts{};
  literal_counts[end_of_block] = 1;
  std::array<std::uint32_t, longest_run + 1> runs{};
  for (const Token t : tokens_) {
    const std::uint32_t kind = t >> 24;
    if (kind == again) {
      ++runs[t & 0xff];
      continue;
    }
    ++literal_counts[t & 0xff];
    if (kind == row_start) continue;
    ++literal_counts[t >> 16];
    ++literal_counts[t >> 8 & 0xff];
  }
  for (std::size_t k = 1; k <= longest_run; ++k) {
    literal_counts[length_symbol(3 * k).code] += runs[k];
    distance_counts[one_pixel_back.code] += runs[k];
  }
  const Code literal(literal_counts, length_limit), distance(distance_counts, length_limit);

  std::array<Bits, 256> byte;
  for (int c = 0; c < 256; ++c) byte[c] = literal[c];
  std::array<Bits, longest_run + 1> run{};
  for (std::size_t k = 1; k <= longest_run; ++k)
    (run[k] = literal(length_symbol(3 * k))) += distance(one_pixel_back);

  std::uint64_t size = 0;  // [bits], with all that may follow a code
  for (int s = 0; s < literals; ++s) size += std::uint64_t{literal_counts[s]} * (literal.lengths[s] + 5);
  for (int s = 0; s < distances; ++s) size += std::uint64_t{distance_counts[s]} * (distance.lengths[s] + 13);
  BitWriter out(bytes_, size / 8 + 512, bits_, bit_count_);
  put_head(out, last, literal, distance);
  for (const Token t : tokens_) {
    if (const std::uint32_t kind = t >> 24; kind != pixel) {
      out.put(kind == again ? run[t & 0xff] : byte[t & 0xff]);
      continue;
    }
    Bits color = byte[t >> 16];
    out.put((color += byte[t >> 8 & 0xff]) += byte[t & 0xff]);
  }
  out.put(literal[end_of_block]);
  const Bits rest = out.finish();
  bits_ = rest.value;
  bit_count_ = rest.count;
  tokens_.clear();
}

std::string PixelStream::finish() {
  write_block(true);
  if (bit_count_ > 0) bytes_ += static_cast<char>(bits_);
  for (const std::uint32_t sum : {sum_of_sums_, sum_})
    for (const int shift : {8, 0}) bytes_ += static_cast<char>(sum >> shift & 0xff);
  return std::move(bytes_);
}

}  // namespace supple
