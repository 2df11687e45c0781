#include "supple/contact/site_grid.hpp"

#include <algorithm>
#include <cmath>

namespace supple {

namespace {

constexpr int most_levels = 16;

/// Cells as an integer, where `cells` may be any number at all.
long to_cell(double cells, long least, long most) {
  const double c = std::floor(cells);
  if (!(c > static_cast<double>(least))) return least;  // also where it is not a number
  return c < static_cast<double>(most) ? static_cast<long>(c) : most;
}

constexpr long far_away = 1L << 30;  ///< cells: farther than any image within reach

long floor_divide(long a, long n) { return a >= 0 ? a / n : -((n - 1 - a) / n); }

}  // namespace

/// The search of a site in one level: its position relative to the image at hand, and the sites found.
template <int Dim>
struct SiteGrid<Dim>::Search {
  const Level& level;
  std::int32_t site;
  double reach;     ///< in which every entry of the level lies that may be near
  double distance;  ///< its own radius and the skin
  Vec<Dim> at;
  std::vector<std::int32_t>& near;
};

template <int Dim>
SiteGrid<Dim>::SiteGrid(const System<Dim>& system, const std::vector<double>& radius, double skin)
    : box_(system.box), radius_(radius), position_(system.state.position), skin_(skin) {
  if (!system.topology.begin.empty()) body_ = bodies_of_sites(system.topology, system.state.size());
  Vec<Dim> still{};
  for (Vec<Dim>& x : position_) box_.wrap(x, still);
  double largest = 0;
  for (double r : radius) largest = std::max(largest, r);
  std::vector<Level> levels(most_levels);
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(radius.size()); ++i) {
    if (radius[i] < 0) continue;
    int k = 0;
    for (double bound = 0.5 * largest; radius[i] < bound && k < most_levels - 1; bound *= 0.5) ++k;
    levels[k].site.push_back(i);
    levels[k].radius = std::max(levels[k].radius, radius[i]);
  }
  for (Level& level : levels) {
    if (level.site.empty()) continue;
    choose_cells(level);
    sort(level);
    levels_.push_back(std::move(level));
  }
}

/// Makes cells as wide as the pairs of the level reach, or wider where there would be more than four cells
/// for each site.
template <int Dim>
void SiteGrid<Dim>::choose_cells(Level& level) const {
  const double width = 2 * level.radius + skin_, most = 4.0 * static_cast<double>(level.site.size()) + 8;
  double cells = 1;
  for (int d = 0; d < Dim; ++d) {
    level.count[d] = to_cell(box_.length[d] / width, 1, 1L << 20);
    cells *= static_cast<double>(level.count[d]);
  }
  while (cells > most) {
    long& longest = *std::max_element(level.count, level.count + Dim);
    cells /= static_cast<double>(longest);
    longest = (longest + 1) / 2;
    cells *= static_cast<double>(longest);
  }
  for (int d = 0; d < Dim; ++d) level.per_cell[d] = static_cast<double>(level.count[d]) / box_.length[d];
}

template <int Dim>
void SiteGrid<Dim>::sort(Level& level) const {
  std::size_t cells = 1;
  for (const long n : level.count) cells *= static_cast<std::size_t>(n);
  level.begin.assign(cells + 1, 0);
  std::vector<std::int32_t> cell;
  for (const std::int32_t i : level.site) {
    long index = 0;
    for (int d = Dim - 1; d >= 0; --d)
      index = index * level.count[d] + to_cell(position_[i][d] * level.per_cell[d], 0, level.count[d] - 1);
    cell.push_back(static_cast<std::int32_t>(index));
    ++level.begin[static_cast<std::size_t>(index) + 1];
  }
  for (std::size_t c = 1; c <= cells; ++c) level.begin[c] += level.begin[c - 1];
  level.entries.resize(level.site.size());
  std::vector<std::int32_t> next(level.begin.begin(), level.begin.end() - 1);
  for (std::size_t k = 0; k < level.site.size(); ++k) {
    const std::int32_t i = level.site[k];
    level.entries[static_cast<std::size_t>(next[static_cast<std::size_t>(cell[k])]++)] = {position_[i],
                                                                                          radius_[i], i};
  }
}

template <int Dim>
void SiteGrid<Dim>::append_near(std::int32_t i, std::vector<std::int32_t>& near) const {
  if (radius_[i] < 0) return;
  const auto before = static_cast<std::ptrdiff_t>(near.size());
  const double distance = radius_[i] + skin_;
  for (const Level& level : levels_) {
    Search search{level, i, distance + level.radius, distance, position_[i], near};
    search_rows(Dim - 1, 0, search);
  }
  if (body_.empty()) return;
  const auto same = [&](std::int32_t j) { return body_[j] == body_[i]; };
  near.erase(std::remove_if(near.begin() + before, near.end(), same), near.end());
}

/// All rows of cells, and images of them, that are within reach across direction d and those below it.
template <int Dim>
void SiteGrid<Dim>::search_rows(int d, long row, Search& search) const {
  if (d == flow) return search_row(row, search);
  const Level& level = search.level;
  const long n = level.count[d];
  const bool periodic = box_.periodic[d];
  const long least = periodic ? -far_away : 0, most = periodic ? far_away : n - 1;
  const Vec<Dim> at = search.at;
  const long last = to_cell((at[d] + search.reach) * level.per_cell[d], least, most);
  for (long c = to_cell((at[d] - search.reach) * level.per_cell[d], least, most); c <= last; ++c) {
    const long image = periodic ? floor_divide(c, n) : 0;
    search.at = at;
    if (image != 0) {
      Vec<Dim> cells{};
      cells[d] = static_cast<double>(image);
      search.at = at - box_.lattice().vector(cells);
    }
    search_rows(d - 1, row * n + c - image * n, search);
  }
  search.at = at;
}

/// The cells of a row follow each other in memory and are searched in one go, up to each end of the box.
template <int Dim>
void SiteGrid<Dim>::search_row(long row, Search& search) const {
  const Level& level = search.level;
  const long n = level.count[flow];
  const bool periodic = box_.periodic[flow];
  const double x = search.at[flow];
  // A sheared image may be many cells away along the flow.
  const double home = periodic ? std::floor(x / box_.length[flow]) * box_.length[flow] : 0;
  const long least = periodic ? -far_away : 0, most = periodic ? far_away : n - 1;
  long low = to_cell((x - home - search.reach) * level.per_cell[flow], least, most);
  const long high = to_cell((x - home + search.reach) * level.per_cell[flow], least, most);
  while (low <= high) {
    const long image = periodic ? floor_divide(low, n) : 0, last = std::min(high, (image + 1) * n - 1);
    const long cell = row * n - image * n;
    Vec<Dim> from = search.at;
    if (periodic) from[flow] -= home + static_cast<double>(image) * box_.length[flow];
    for (std::int32_t k = level.begin[cell + low]; k < level.begin[cell + last + 1]; ++k) {
      const Entry& entry = level.entries[k];
      const Vec<Dim> r = entry.position - from;
      const double limit = search.distance + entry.radius;
      if (dot(r, r) < limit * limit && entry.site > search.site) search.near.push_back(entry.site);
    }
    low = last + 1;
  }
}

template class SiteGrid<2>;
template class SiteGrid<3>;

}  // namespace supple
