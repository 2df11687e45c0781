/// Laws of contacts by the species of the two bodies that meet.
#pragma once
#include <algorithm>
#include <array>
#include <concepts>
#include <cstdint>
#include <vector>

#include "supple/contact/laws/body.hpp"

namespace supple {

/// One law that holds for all contacts, and others for those pairs of species that are set. Species are
/// numbers from 0 (System::species); their order in a pair does not matter.
template <class Law>
class LawTable {
 public:
  template <class T>
  requires std::convertible_to<T, Law> LawTable(const T& common) : laws_{Law(common)} {}

  /// The law of all pairs that are not set.
  const Law& common() const { return laws_.front(); }
  bool is_uniform() const { return species_ == 0; }
  const Law& of(std::int32_t a, std::int32_t b) const {
    return a < species_ && b < species_ ? laws_[index_[a * species_ + b]] : laws_.front();
  }
  const Law& of(const std::array<std::int32_t, 2>& pair) const { return of(pair[0], pair[1]); }
  void set(std::int32_t a, std::int32_t b, const Law& law) {
    grow(std::max(a, b) + 1);
    std::int32_t& at = index_[a * species_ + b];
    if (at == 0)
      at = index_[b * species_ + a] = static_cast<std::int32_t>(laws_.size()), laws_.push_back(law);
    else laws_[at] = law;
  }

  /// The same table of what `change` makes of each law.
  template <class Change>
  auto map(const Change& change) const {
    LawTable<std::decay_t<decltype(change(common()))>> other(change(common()));
    for (std::int32_t a = 0; a < species_; ++a)
      for (std::int32_t b = 0; b <= a; ++b)
        if (index_[a * species_ + b] != 0) other.set(a, b, change(of(a, b)));
    return other;
  }
  /// The largest and the least of a measure of the laws.
  template <class Measure>
  double most(const Measure& measure) const {
    double x = measure(common());
    for (const Law& law : laws_) x = std::max<double>(x, measure(law));
    return x;
  }
  template <class Measure>
  double least(const Measure& measure) const {
    return -most([&](const Law& law) { return -measure(law); });
  }
  template <class Test>
  bool all(const Test& test) const {
    return std::all_of(laws_.begin(), laws_.end(), test);
  }

 private:
  void grow(std::int32_t species) {
    if (species <= species_) return;
    std::vector<std::int32_t> wider(static_cast<std::size_t>(species) * species);
    for (std::int32_t a = 0; a < species_; ++a)
      for (std::int32_t b = 0; b < species_; ++b) wider[a * species + b] = index_[a * species_ + b];
    index_.swap(wider);
    species_ = species;
  }

  std::vector<Law> laws_;  ///< the common one first
  std::int32_t species_ = 0;
  std::vector<std::int32_t> index_;  ///< into laws_, of each pair of species
};

/// The elastic laws of contacts of bodies.
using ContactLaws = LawTable<BodyLaw>;

/// How far the law of the longest range reaches, over the distance at which surfaces meet.
inline double widest_range(const ContactLaws& laws) {
  return laws.most([](const BodyLaw& law) { return law.range(); });
}

}  // namespace supple
