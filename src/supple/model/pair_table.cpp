#include "supple/model/pair_table.hpp"

#include <atomic>

namespace supple {

std::uint64_t new_version() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

void set_history_width(PairTable& pairs, int width) {
  const std::vector<double> old = pairs.history;
  const int from = pairs.width;
  pairs.width = width;
  pairs.history.resize(static_cast<std::size_t>(pairs.size()) * width);
  for (int row = 0; row < pairs.size(); ++row) {
    double sum = 0;
    for (int w = 0; w < from; ++w) sum += old[static_cast<std::size_t>(row) * from + w];
    for (int w = 0; w < width; ++w)
      pairs.history[static_cast<std::size_t>(row) * width + w] =
          from == width ? old[static_cast<std::size_t>(row) * from + w] : sum / from;
  }
}

void index_rows(PairTable& pairs, int sites) {
  pairs.begin.assign(static_cast<std::size_t>(sites) + 1, 0);
  for (std::int32_t i : pairs.first) ++pairs.begin[i + 1];
  for (int i = 0; i < sites; ++i) pairs.begin[i + 1] += pairs.begin[i];
}

void drop_open(PairTable& pairs, int sites) {
  const auto width = static_cast<std::size_t>(pairs.width);
  int kept = 0;
  for (int r = 0; r < pairs.size(); ++r) {
    if (pairs.state[r] == ContactState::open) continue;
    pairs.first[kept] = pairs.first[r];
    pairs.second[kept] = pairs.second[r];
    pairs.state[kept] = pairs.state[r];
    for (std::size_t k = 0; k < width; ++k) pairs.history[kept * width + k] = pairs.history[r * width + k];
    if (!pairs.image.empty()) pairs.image[kept] = pairs.image[r];
    ++kept;
  }
  pairs.resize(kept);
  if (!pairs.image.empty()) pairs.image.resize(static_cast<std::size_t>(kept));
  index_rows(pairs, sites);
  pairs.skin = pairs.reach = 0;
  ++pairs.version;
}

void follow_images(PairTable& pairs, std::int32_t i, const std::array<std::int32_t, 3>& cells) {
  for (std::size_t row = 0; row < pairs.image.size(); ++row) {
    RowImage& image = pairs.image[row];
    if (!image.kept || (pairs.first[row] != i && pairs.second[row] != i)) continue;
    const int sign = pairs.first[row] == i ? 1 : -1;
    for (std::size_t d = 0; d < cells.size(); ++d) image.cells[d] += sign * cells[d];
  }
}

void set_pair_state(PairTable& pairs, int sites, std::int32_t i, std::int32_t j, ContactState state) {
  if (static_cast<int>(pairs.begin.size()) != sites + 1) index_rows(pairs, sites);
  int row = pairs.find(i, j);
  if (row < 0) {
    row = pairs.begin[i];
    while (row < pairs.begin[i + 1] && pairs.second[row] < j) ++row;
    pairs.first.insert(pairs.first.begin() + row, i);
    pairs.second.insert(pairs.second.begin() + row, j);
    pairs.state.insert(pairs.state.begin() + row, state);
    pairs.history.insert(pairs.history.begin() + static_cast<std::ptrdiff_t>(row) * pairs.width, pairs.width,
                         0.0);
    if (!pairs.image.empty()) pairs.image.insert(pairs.image.begin() + row, RowImage{});
    for (int k = i + 1; k <= sites; ++k) ++pairs.begin[k];
    pairs.version = new_version();
  }
  pairs.state[row] = state;
  for (int w = 0; w < pairs.width; ++w) pairs.history[static_cast<std::size_t>(row) * pairs.width + w] = 0;
}

}  // namespace supple
