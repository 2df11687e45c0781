/// Arrays of vectors, tuples and enums as arrays of numbers in files, by the names and units of
/// model/quantities.hpp.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "supple/io/hdf5/hdf5.hpp"
#include "supple/model/quantities.hpp"

namespace supple {

/// Throws a file error, "the file is damaged", unless `good`; `what` says what cannot be.
void expect_sound(bool good, const h5::Object& object, const std::string& what);

/// The text of a unit in these units: "m/s", "1e-06 m/s", or nothing where a run has none.
std::string unit_text(const Units& units, const Unit& unit);

/// How a file holds a value: as numbers of type Number, with these lengths.
template <class T>
struct Element {
  using Number = T;
  static h5::Shape shape() { return {}; }
};
template <int Dim>
struct Element<Vec<Dim>> {
  using Number = double;
  static h5::Shape shape() { return {Dim}; }
};
template <int Dim>
struct Element<Mat<Dim>> {
  using Number = double;
  static h5::Shape shape() { return {Dim, Dim}; }
};
template <std::size_t N>
struct Element<std::array<std::int32_t, N>> {
  using Number = std::int32_t;
  static h5::Shape shape() { return {N}; }
};
template <std::size_t N>
struct Element<std::array<bool, N>> {
  using Number = std::uint8_t;
  static h5::Shape shape() { return {N}; }
};
/// An enum of one byte, and its last value.
template <auto most>
struct Code {
  using Number = std::uint8_t;
  static h5::Shape shape() { return {}; }
  static constexpr auto last = static_cast<std::uint8_t>(most);
};
template <>
struct Element<Mobility> : Code<Mobility::fixed> {};
template <>
struct Element<ContactState> : Code<ContactState::permanent> {};
template <>
struct Element<TouchOn> : Code<TouchOn::body> {};

template <class T>
using NumberOf = typename Element<T>::Number;

/// The numbers of values, one after the other.
template <class T>
std::span<const NumberOf<T>> flat(std::span<const T> values) {
  constexpr std::size_t width = sizeof(T) / sizeof(NumberOf<T>);
  return {reinterpret_cast<const NumberOf<T>*>(values.data()), width * values.size()};
}
template <class T>
std::span<const NumberOf<T>> flat(const std::vector<T>& values) {
  return flat(std::span<const T>(values));
}

/// Values from their numbers, the inverse of flat(). A file error, by the name of the array, for the code of
/// no enumerator.
template <class T>
std::vector<T> values_from(const std::vector<NumberOf<T>>& numbers, const h5::Group& group,
                           const std::string& name) {
  if constexpr (std::is_enum_v<T>)
    for (const std::uint8_t code : numbers)
      expect_sound(code <= Element<T>::last, group, name + ": a code without a meaning");
  std::vector<T> out(numbers.size() * sizeof(NumberOf<T>) / sizeof(T));
  if constexpr (std::is_same_v<NumberOf<T>, std::uint8_t> && !std::is_enum_v<T>)
    for (std::size_t k = 0; k < numbers.size(); ++k)
      out[k / out[0].size()][k % out[0].size()] = numbers[k] != 0;
  else if (!out.empty()) std::memcpy(static_cast<void*>(out.data()), numbers.data(), out.size() * sizeof(T));
  return out;
}

/// Lengths, then those of one T.
template <class T>
h5::Shape shape_of(h5::Shape lengths) {
  for (const std::uint64_t length : Element<T>::shape()) lengths.push_back(length);
  return lengths;
}

template <class Q>
void describe(h5::Object& made, const Q& quantity, const Units& units) {
  if (const std::string text = unit_text(units, quantity.unit); !text.empty()) made.set("unit", text);
  if (*quantity.meaning) made.set("meaning", std::string(quantity.meaning));
}

template <class Q, class T>
void write(h5::Group& group, const Q& quantity, const std::vector<T>& values, const Units& units) {
  h5::Object made = group.write(quantity.name, flat(values), shape_of<T>({values.size()}));
  describe(made, quantity, units);
}
template <class Q, class T>
void write(h5::Group& group, const Q& quantity, const T& value, const Units& units) {
  h5::Object made;
  if constexpr (std::is_same_v<T, NumberOf<T>>) made = group.write_scalar(quantity.name, value);
  else made = group.write(quantity.name, flat(std::span(&value, 1)), Element<T>::shape());
  describe(made, quantity, units);
}

/// All values of an array; of one number or vector where `out` is one. A file error where it has other
/// lengths.
template <class T>
void read(const h5::Group& group, const std::string& name, std::vector<T>& out) {
  const h5::Shape shape = group.shape(name), row = Element<T>::shape();
  expect_sound(shape.size() == row.size() + 1 && std::equal(row.begin(), row.end(), shape.begin() + 1), group,
               name + " has another dimension");
  out = values_from<T>(group.read<NumberOf<T>>(name), group, name);
}
template <class T>
void read(const h5::Group& group, const std::string& name, T& out) {
  expect_sound(group.shape(name) == Element<T>::shape(), group, name + " has another dimension");
  out = values_from<T>(group.read<NumberOf<T>>(name), group, name).at(0);
}

/// Every quantity of a struct.
template <class Struct>
void write_all(h5::Group& group, const Struct& values, const Units& units) {
  for_each_quantity(values, [&](const auto& q, const auto& value) { write(group, q, value, units); });
}
/// What becomes of a quantity that a file lacks: an error, or, where older files have fewer, nothing.
enum class Missing { refused, left };
template <class Struct>
void read_all(const h5::Group& group, Struct& values, Missing missing = Missing::refused) {
  for_each_quantity(values, [&](const auto& q, auto& value) {
    if (missing == Missing::refused || group.has(q.name)) read(group, q.name, value);
  });
}

/// Whether all arrays of a struct have `count` values.
template <class Struct>
bool all_have(const Struct& values, std::size_t count) {
  bool good = true;
  for_each_quantity(values, [&](const auto&, const auto& array) { good = good && array.size() == count; });
  return good;
}

/// A column of each quantity of Struct; `in` finds it in a row.
template <class Struct, class Row, class In>
void write_columns(h5::Group& group, const std::vector<Row>& rows, const Units& units, In&& in) {
  for_each_quantity(static_cast<const Struct&>(Struct{}), [&]<class T>(const auto& q, const T&) {
    std::vector<T> column;
    for (const Row& row : rows) column.push_back(in(row).*(q.member));
    write(group, q, column, units);
  });
}

/// The number of rows of the columns of `group`, by one of them.
inline std::uint64_t rows_in(const h5::Group& group, const std::string& column) {
  const h5::Shape shape = group.shape(column);
  expect_sound(shape.size() == 1, group, column + " is no column");
  return shape[0];
}

/// Those columns, `total` rows long, from row `first` on into `rows`. A file error where one has another
/// length.
template <class Struct, class Row, class In>
void read_columns(const h5::Group& group, std::uint64_t first, std::uint64_t total, std::vector<Row>& rows,
                  In&& in) {
  for_each_quantity(static_cast<const Struct&>(Struct{}), [&]<class T>(const auto& q, const T&) {
    const h5::Shape shape = group.shape(q.name), expected = shape_of<T>({total});
    expect_sound(
        shape.size() == expected.size() && std::equal(shape.begin() + 1, shape.end(), expected.begin() + 1),
        group, std::string(q.name) + " has another shape than contacts");
    expect_sound(shape == expected, group, std::string(q.name) + ": rows are missing, or too many");
    const auto column =
        values_from<T>(group.read_rows<NumberOf<T>>(q.name, first, rows.size()), group, q.name);
    for (std::size_t k = 0; k < rows.size(); ++k) in(rows[k]).*(q.member) = column.at(k);
  });
}

}  // namespace supple
