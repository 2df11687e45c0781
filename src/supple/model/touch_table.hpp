/// What contacts and links between bodies of many sites remember.
#pragma once
#include <algorithm>
#include <array>
#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "supple/core/vec.hpp"
#include "supple/model/pair_table.hpp"

namespace supple {

/// Which contact: a site, what it touches, and the image. In rough contacts `other` is a site, in smooth ones
/// a body: a vertex that slides from one edge of a boundary to the next stays in the same contact. The
/// contact is about the vector x_site - x_other - n, n the lattice vector of `cells`.
enum class TouchOn : std::uint8_t { site, body };
struct TouchKey {
  std::int32_t site = 0, other = 0;
  TouchOn on = TouchOn::site;  ///< what the number `other` is of
  std::array<std::int32_t, 3> cells{};
  auto operator<=>(const TouchKey&) const = default;
};

/// The body on the other side; `body` holds the body of each site (bodies_of_sites).
inline std::int32_t body_of_other(const TouchKey& key, std::span<const std::int32_t> body) {
  return key.on == TouchOn::site ? body[key.other] : key.other;
}

/// A contact and its tangential spring.
struct Touch {
  TouchKey key;
  ContactState state = ContactState::stick;
  /// Integral of the tangential velocity of the site relative to the other side, along t = (-n_y, n_x), n
  /// toward the site [length].
  double elongation = 0;
  bool operator==(const Touch&) const = default;
};

/// Forces of a contact on its site beside the elastic one [force]: `viscous` along n, `tangential` along -t
/// (n and t as in Touch). `virial`: what they and their couples add to Evaluation::virial [energy].
struct TouchForce {
  TouchKey key;
  double viscous = 0, tangential = 0;
  Mat2 virial{};
};

/// The contacts that touch, in ascending order of their keys. A contact that opens leaves the table and is
/// forgotten.
struct TouchTable {
  std::vector<Touch> rows;

  /// The row of this key; null where it does not touch.
  const Touch* find(const TouchKey& key) const {
    const auto at = std::lower_bound(rows.begin(), rows.end(), key,
                                     [](const Touch& touch, const TouchKey& k) { return touch.key < k; });
    return at != rows.end() && at->key == key ? &*at : nullptr;
  }
};

/// A permanent link of two sites of different bodies. It never opens and keeps its image: its vector is
/// x_second - x_first - n, n the lattice vector of `cells`.
struct Link {
  std::int32_t first = 0, second = 0;
  std::array<std::int32_t, 3> cells{};
  double rest = 0;  ///< distance without force [length]
  /// Integral of the tangential velocity of second relative to first, along t = (-n_y, n_x), n toward second
  /// [length].
  double elongation = 0;
  bool operator==(const Link&) const = default;
};

/// Forces of a link on its second site [force]: elastic and viscous along n, tangential along -t (n and t as
/// in Link). `virial`: what they and their couples add to Evaluation::virial [energy].
struct LinkForce {
  double elastic = 0, viscous = 0, tangential = 0;
  Mat2 virial{};
};

}  // namespace supple
