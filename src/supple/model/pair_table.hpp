/// Pairs of sites that touch, are linked, or may soon touch, with the memory of each contact.
#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace supple {

/// State of a pair: apart (open), sticking or slipping along t, or a permanent link, which never opens.
enum class ContactState : std::uint8_t { open = 0, stick = 1, slip = 2, permanent = 3 };

/// Which image of its second site a row is about. Where `kept`, `cells` are subtracted from x_second -
/// x_first, by direction; else the row is about the nearest image.
struct RowImage {
  std::array<std::int32_t, 3> cells{};
  bool kept = false;  ///< false: the row is about the nearest image
  bool operator==(const RowImage&) const = default;
};

/// Rows first < second in ascending (first, second): the canonical order of every sum over contacts, which
/// does not depend on when the neighbour list was built. Rows of site i: [begin[i], begin[i+1]). `history`
/// holds `width` numbers a row: what the law remembers (tangential elongation [length]).
struct PairTable {
  std::vector<std::int32_t> begin, first, second;
  std::vector<ContactState> state;
  std::vector<double> history;
  int width = 1;
  /// One of each row while some link is so long that its image need not be the nearest one; else empty. A
  /// link keeps its image for life: NeighborList notes it, and wrap_site changes it when a site crosses the
  /// boundary.
  std::vector<RowImage> image;
  std::uint64_t version = 0;  ///< changes whenever rows come or go: new_version()
  /// How far pairs without a row were at least from touching when the table was made [length]; infinite for
  /// rows made by hand.
  double skin = std::numeric_limits<double>::infinity();
  /// Distance within which every pair has a row, links apart [length]; infinite for rows made by hand.
  double reach = std::numeric_limits<double>::infinity();

  int size() const { return static_cast<int>(first.size()); }
  void clear() {
    begin.clear();
    first.clear();
    second.clear();
    state.clear();
    history.clear();
    image.clear();
  }
  void resize(int rows) {
    first.resize(rows);
    second.resize(rows);
    state.resize(rows);
    history.resize(static_cast<std::size_t>(rows) * width);
  }
  /// Row of the pair (i, j), i < j, or -1.
  int find(std::int32_t i, std::int32_t j) const {
    if (i + 1 >= static_cast<int>(begin.size())) return -1;
    int low = begin[i], high = begin[i + 1];
    while (low < high) {
      const int middle = (low + high) / 2;
      if (second[middle] < j) low = middle + 1;
      else high = middle;
    }
    return low < begin[i + 1] && second[low] == j ? low : -1;
  }
};

/// A version that no table of this process has: what was made for one table is never taken for another.
std::uint64_t new_version();

/// Changes the numbers of history in a row to `width`. From two (the elongations of the published package) to
/// one the mean is kept; from one to two the number is repeated.
void set_history_width(PairTable& pairs, int width);

/// Fills `begin` from `first`, for `sites` sites.
void index_rows(PairTable& pairs, int sites);

/// Takes out the rows of pairs that are apart: which of these a table has depends on when the neighbour list
/// was built.
void drop_open(PairTable& pairs, int sites);

/// Keeps the rows of site i about the same images after `cells` were subtracted from its position.
void follow_images(PairTable& pairs, std::int32_t i, const std::array<std::int32_t, 3>& cells);

/// Sets the state of the pair (i, j), i < j, adding its row where it has none, and zeroes its history.
void set_pair_state(PairTable& pairs, int sites, std::int32_t i, std::int32_t j, ContactState state);

}  // namespace supple
