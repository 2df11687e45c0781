/// Counter-based random numbers (Philox 4x32-10, Salmon et al. 2011), keyed by (seed, purpose, index): a draw
/// does not depend on the number of threads, the order of calls, or how many other things are drawn.
#pragma once
#include <array>
#include <cstdint>

namespace supple {

/// What a stream is for. Append only: with other numbers a published seed would give another sample.
enum class Purpose : std::uint32_t {
  disc_position = 1,
  disc_size = 2,
  particle_seed = 3,
  edge_fuzziness = 4,
  cut_line = 5,
  link_removal = 6,
  isolated_join = 7,
  coincident_normal = 8,
  body_position = 9,
  body_angle = 10,
  body_velocity = 11,
  area_sample = 12,
  line_lattice = 13,
  solid_node = 14,
  test = 100
};

/// One stream index from two numbers, such as an attempt and a disc; neither may be negative.
inline std::uint64_t stream_index(std::int32_t high, std::int32_t low) {
  return (static_cast<std::uint64_t>(high) << 32) | static_cast<std::uint32_t>(low);
}

/// The stream (seed, purpose, index): a sequence of independent draws.
class RandomStream {
 public:
  RandomStream(std::uint64_t seed, Purpose purpose, std::uint64_t index = 0)
      : key_{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)},
        counter_{0, static_cast<std::uint32_t>(purpose), static_cast<std::uint32_t>(index),
                 static_cast<std::uint32_t>(index >> 32)} {}

  /// Uniform in [0, 1), 53 bits.
  double uniform() {
    const std::uint64_t bits = (static_cast<std::uint64_t>(word()) << 32) | word();
    return static_cast<double>(bits >> 11) * 0x1.0p-53;
  }
  /// Uniform in [low, high).
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Uniform integer in [0, n), n > 0.
  std::uint64_t below(std::uint64_t n) {
    const std::uint64_t x = static_cast<std::uint64_t>(uniform() * static_cast<double>(n));
    return x < n ? x : n - 1;
  }

 private:
  std::uint32_t word() {
    if (used_ == block_.size()) fill_block();
    return block_[used_++];
  }
  /// The next four words.
  void fill_block();

  std::array<std::uint32_t, 2> key_;
  std::array<std::uint32_t, 4> counter_, block_{};
  std::size_t used_ = block_.size();
};

}  // namespace supple
