/// Numbers in binary mesh files.
#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <string_view>

namespace supple {

/// The number whose bytes stand from `at` on, in this order; they must be there.
template <class T>
T number_at(std::string_view bytes, std::size_t at, std::endian order) {
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), bytes.data() + at, sizeof(T));
  if (order != std::endian::native) std::reverse(raw.begin(), raw.end());
  return std::bit_cast<T>(raw);
}

}  // namespace supple
