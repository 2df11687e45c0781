/// Prefix codes of DEFLATE (RFC 1951, section 3.2).
#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace supple {

/// Bits of each symbol's code, 0 where it does not occur: the shortest code (Huffman 1952) for these counts,
/// of at most `limit` bits. A symbol that is alone gets one bit.
std::vector<std::uint8_t> code_lengths(std::span<const std::uint32_t> counts, int limit);

/// The codes of these lengths, the first bit lowest, as a stream of DEFLATE takes them.
std::vector<std::uint16_t> codes_of(std::span<const std::uint8_t> lengths);

}  // namespace supple
