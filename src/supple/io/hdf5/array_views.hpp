/// Arrays of vectors, tuples and enums as flat arrays of numbers, and back: files hold the flat ones.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "supple/core/vec.hpp"

namespace supple {

/// The components of vectors, vector after vector.
template <int Dim>
std::span<const double> flat(const std::vector<Vec<Dim>>& vectors) {
  static_assert(sizeof(Vec<Dim>) == Dim * sizeof(double));
  return {reinterpret_cast<const double*>(vectors.data()), Dim * vectors.size()};
}

/// The numbers of tuples, tuple after tuple.
template <std::size_t N>
std::span<const std::int32_t> flat(const std::vector<std::array<std::int32_t, N>>& tuples) {
  static_assert(sizeof(std::array<std::int32_t, N>) == N * sizeof(std::int32_t));
  return {reinterpret_cast<const std::int32_t*>(tuples.data()), N * tuples.size()};
}

/// The numbers of an array of enums of one byte.
template <class Enum>
std::span<const std::uint8_t> codes(const std::vector<Enum>& values) {
  static_assert(std::is_same_v<std::underlying_type_t<Enum>, std::uint8_t>);
  return {reinterpret_cast<const std::uint8_t*>(values.data()), values.size()};
}

/// Vectors from their components, the inverse of flat().
template <int Dim>
std::vector<Vec<Dim>> vectors_from(const std::vector<double>& numbers) {
  std::vector<Vec<Dim>> out(numbers.size() / Dim);
  for (std::size_t i = 0; i < out.size(); ++i)
    for (int d = 0; d < Dim; ++d) out[i][d] = numbers[Dim * i + static_cast<std::size_t>(d)];
  return out;
}

/// Tuples from their numbers, the inverse of flat().
template <std::size_t N>
std::vector<std::array<std::int32_t, N>> tuples_from(const std::vector<std::int32_t>& numbers) {
  std::vector<std::array<std::int32_t, N>> out(numbers.size() / N);
  for (std::size_t i = 0; i < out.size(); ++i)
    for (std::size_t k = 0; k < N; ++k) out[i][k] = numbers[N * i + k];
  return out;
}

/// Enums from their numbers, the inverse of codes().
template <class Enum>
std::vector<Enum> enums_from(const std::vector<std::uint8_t>& values) {
  std::vector<Enum> out;
  out.reserve(values.size());
  for (const std::uint8_t v : values) out.push_back(static_cast<Enum>(v));
  return out;
}

}  // namespace supple
