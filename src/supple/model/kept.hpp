/// What a run is besides its tables: plain data by name, from which it goes on bit for bit.
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "supple/core/error.hpp"
#include "supple/model/quantities.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// One kept value: a number, a list of numbers, a text, or a whole system.
using KeptValue = std::variant<std::int64_t, double, std::string, std::vector<std::int64_t>,
                               std::vector<double>, System<2>, System<3>>;
/// Names are those of the members, "search.low.density".
using Kept = std::map<std::string, KeptValue>;

/// Saves values into a Kept, or restores them from one: the same list of members, a function keep(Keeper&),
/// serves both ways. Restoring throws a file error where a value is missing or of another type.
class Keeper {
 public:
  static Keeper saving(Kept& to) { return Keeper(&to, nullptr); }
  static Keeper restoring(const Kept& from) { return Keeper(nullptr, &from); }

  bool restores() const { return from_ != nullptr; }
  /// How many values were saved or restored.
  std::size_t count() const { return count_; }

  /// Keeps a value under a name: numbers, enums, texts, vectors and arrays of numbers, optional values,
  /// systems, structs with quantities, and what has a function keep.
  template <class T>
  void operator()(const std::string& name, T& value) {
    const std::string full = prefix_ + name;
    if constexpr (std::is_same_v<T, double> || std::is_same_v<T, System<2>> || std::is_same_v<T, System<3>> ||
                  std::is_same_v<T, std::string> || std::is_same_v<T, std::vector<double>> ||
                  std::is_same_v<T, std::vector<std::int64_t>>)
      exchange(full, value);
    else if constexpr (std::is_integral_v<T> || std::is_enum_v<T>) as_integer(full, value);
    else within(full, [&] { parts(value); });
  }

 private:
  Keeper(Kept* to, const Kept* from) : to_(to), from_(from) {}

  template <class T>
  void exchange(const std::string& name, T& value) {
    ++count_;
    if (to_) {
      to_->insert_or_assign(name, value);
      return;
    }
    const auto at = from_->find(name);
    if (at == from_->end())
      throw file_error("the checkpoint lacks " + name, "it is of another version of Supple");
    if (const T* kept = std::get_if<T>(&at->second)) value = *kept;
    else
      throw file_error("the checkpoint holds another kind of " + name, "it is of another version of Supple");
  }

  template <class T>
  void as_integer(const std::string& name, T& value) {
    auto number = static_cast<std::int64_t>(value);
    exchange(name, number);
    value = static_cast<T>(number);
  }

  template <class Work>
  void within(const std::string& name, Work&& work) {
    const std::string outer = std::exchange(prefix_, name + ".");
    work();
    prefix_ = outer;
  }

  template <class T>
  void parts(std::optional<T>& value) {
    bool has = value.has_value();
    (*this)("is_there", has);
    if (!has) return value.reset();
    if (!value) value.emplace();
    (*this)("value", *value);
  }

  template <class T>
  void parts(std::vector<T>& values) {
    if constexpr (std::is_integral_v<T> || std::is_enum_v<T>) {
      std::vector<std::int64_t> numbers;
      for (const T value : values) numbers.push_back(static_cast<std::int64_t>(value));
      (*this)("numbers", numbers);
      values.clear();
      for (const std::int64_t number : numbers) values.push_back(static_cast<T>(number));
    } else if constexpr (std::is_same_v<T, Vec2>) {
      std::vector<double> numbers;
      for (const Vec2& v : values) numbers.insert(numbers.end(), {v[0], v[1]});
      (*this)("numbers", numbers);
      values.assign(numbers.size() / 2, {});
      for (std::size_t k = 0; k < values.size(); ++k) values[k] = {numbers[2 * k], numbers[2 * k + 1]};
    } else {
      auto count = static_cast<std::int64_t>(values.size());
      (*this)("count", count);
      values.resize(static_cast<std::size_t>(count));
      for (std::size_t k = 0; k < values.size(); ++k) (*this)(std::to_string(k), values[k]);
    }
  }

  template <class T, std::size_t N>
  void parts(T (&values)[N]) {
    for (std::size_t k = 0; k < N; ++k) (*this)(std::to_string(k), values[k]);
  }
  template <class T, std::size_t N>
  void parts(std::array<T, N>& values) {
    for (std::size_t k = 0; k < N; ++k) (*this)(std::to_string(k), values[k]);
  }
  template <int Dim>
  void parts(Vec<Dim>& v) {
    parts(v.e);
  }
  template <int Dim>
  void parts(Mat<Dim>& m) {
    parts(m.e);
  }

  template <class T>
  void parts(T& value) {
    if constexpr (requires { value.keep(*this); }) value.keep(*this);
    else if constexpr (requires { keep(*this, value); }) keep(*this, value);
    else for_each_quantity(value, [&](const auto& q, auto& member) { (*this)(q.name, member); });
  }

  Kept* to_;
  const Kept* from_;
  std::size_t count_ = 0;
  std::string prefix_;
};

}  // namespace supple
