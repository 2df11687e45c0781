#include "supple/contact/neighbor_list.hpp"

#include <algorithm>
#include <cmath>

#include "supple/core/parallel.hpp"

namespace supple {

namespace {

/// Sites sorted into cells no smaller than the reach; in a small box one cell holds all.
template <int Dim>
class CellGrid {
 public:
  CellGrid(const System<Dim>& system, const std::vector<double>& radius, double skin, double reach)
      : box_(system.box), radius_(radius), reach_(reach), skin_(skin) {
    if (!system.topology.begin.empty()) body_ = bodies_of_sites(system.topology, system.state.size());
    // No more cells than a few for each site, however empty the box.
    const int most = std::max(4, static_cast<int>(2 * std::pow(system.state.size(), 1.0 / Dim)));
    long cells = 1;
    for (int d = 0; d < Dim; ++d) {
      // A row is searched over up to four cells along the flow, three across; fewer would meet a cell twice.
      const int least = d == flow ? 4 : 3;
      count_[d] = std::clamp(static_cast<int>(box_.length[d] / reach), 1, most);
      if (count_[d] < least) single_ = true;
    }
    if (single_) for (int& n : count_) n = 1;
    for (int d = 0; d < Dim; ++d) {
      per_cell_[d] = count_[d] / box_.length[d];
      cells *= count_[d];
    }
    sort(system.state, cells);
  }

  /// Appends the sites j > i of other bodies that are closer to site i than the sum of their radii and the skin.
  void append_near(const State<Dim>& state, std::int32_t i, std::vector<std::int32_t>& near) const {
    const auto before = static_cast<std::ptrdiff_t>(near.size());
    append_all_near(state.position[i], i, near);
    if (body_.empty()) return;
    const auto same = [&](std::int32_t j) { return body_[j] == body_[i]; };
    near.erase(std::remove_if(near.begin() + before, near.end(), same), near.end());
  }

 private:
  struct Entry {
    Vec<Dim> position;
    double radius;
    std::int32_t site;
  };

  void append_all_near(Vec<Dim> x, std::int32_t i, std::vector<std::int32_t>& near) const {
    const double reach = radius_[i] + skin_;
    if (!body_.empty()) {  // bodies may stick out of the cell
      Vec<Dim> still{};
      box_.wrap(x, still);
    }
    if (single_) {
      const auto images = box_.images();
      for (const Entry& e : entries_) {
        Vec<Dim> r = e.position - x;
        images.reduce(r);
        append_if_near(r, reach, i, e, near);
      }
      return;
    }
    int offset[Dim];
    for_rows(1, offset, [&] { search_row(x, reach, i, offset, near); });
  }

  static void append_if_near(const Vec<Dim>& r, double reach, std::int32_t i, const Entry& e,
                             std::vector<std::int32_t>& near) {
    const double limit = reach + e.radius;
    if (dot(r, r) < limit * limit && e.site > i) near.push_back(e.site);
  }

  int cell_of(const Vec<Dim>& x, int d) const {
    const double c = std::floor(x[d] * per_cell_[d]);
    return c > 0 ? static_cast<int>(std::min(c, count_[d] - 1.0)) : 0;  // also where c is not a number
  }

  void sort(const State<Dim>& state, long cells) {
    const auto n = state.position.size();
    std::vector<std::int32_t> cell(n);
    std::vector<Vec<Dim>> wrapped = state.position;
    if (!body_.empty())
      for (Vec<Dim>& x : wrapped) {
        Vec<Dim> still{};
        box_.wrap(x, still);
      }
    begin_.assign(static_cast<std::size_t>(cells) + 1, 0);
    for (std::size_t i = 0; i < n; ++i) {
      long index = 0;
      for (int d = Dim - 1; d >= 0; --d) index = index * count_[d] + cell_of(wrapped[i], d);
      cell[i] = static_cast<std::int32_t>(index);
      ++begin_[static_cast<std::size_t>(index) + 1];
    }
    for (std::size_t c = 1; c < begin_.size(); ++c) begin_[c] += begin_[c - 1];
    entries_.resize(n);
    std::vector<std::int32_t> next(begin_.begin(), begin_.end() - 1);
    for (std::size_t i = 0; i < n; ++i)
      entries_[next[cell[i]]++] = {wrapped[i], radius_[i], static_cast<std::int32_t>(i)};
  }

  /// body() for every row of cells beside the present one: offsets -1, 0, 1 in each direction but the flow.
  template <class Body>
  void for_rows(int d, int (&offset)[Dim], const Body& body) const {
    if (d == Dim) return body();
    for (int o = -1; o <= 1; ++o) {
      offset[d] = o;
      for_rows(d + 1, offset, body);
    }
  }

  void search_row(const Vec<Dim>& x, double reach, std::int32_t i, const int (&offset)[Dim],
                  std::vector<std::int32_t>& near) const {
    long row = 0;
    Vec<Dim> at = x;  // as seen from the image of the row in this cell of the box
    for (int d = Dim - 1; d >= 1; --d) {
      int c = cell_of(x, d) + offset[d];
      if (c < 0 || c >= count_[d]) {
        if (!box_.periodic[d]) return;
        const int up = c < 0 ? -1 : 1;
        c -= up * count_[d];
        at[d] -= up * box_.length[d];
        if (d == gradient) at[flow] -= up * box_.strain * box_.length[gradient];
      }
      row = row * count_[d] + c;
    }
    if (!std::isfinite(at[flow])) return;
    const int n = count_[flow];
    long low = static_cast<long>(std::floor((at[flow] - reach_) * per_cell_[flow]));
    long high = static_cast<long>(std::floor((at[flow] + reach_) * per_cell_[flow]));
    if (!box_.periodic[flow]) {
      low = std::clamp(low, 0L, n - 1L);
      high = std::clamp(high, 0L, n - 1L);
    } else if (high - low >= n) {
      high = low + n - 1;
    }
    // Cells of a row lie behind one another: search them in one go up to each end of the box.
    while (low <= high) {
      const long image = low >= 0 ? low / n : -((n - 1 - low) / n), last = std::min(high, (image + 1) * n - 1);
      const long first_cell = row * n + low - image * n, last_cell = row * n + last - image * n;
      Vec<Dim> from = at;
      from[flow] -= static_cast<double>(image) * box_.length[flow];
      for (std::int32_t k = begin_[first_cell]; k < begin_[last_cell + 1]; ++k)
        append_if_near(entries_[k].position - from, reach, i, entries_[k], near);
      low = last + 1;
    }
  }

  const Box<Dim>& box_;
  const std::vector<double>& radius_;
  std::vector<std::int32_t> body_;  ///< of each site; empty: every site is a body
  double reach_, skin_;
  bool single_ = false;
  int count_[Dim];
  double per_cell_[Dim];
  std::vector<std::int32_t> begin_;
  std::vector<Entry> entries_;  ///< cell after cell
};

/// Rows of the table before the build that belong to one site.
struct OldRows {
  int at, end;
  OldRows(const PairTable& old, std::int32_t i) {
    const bool known = i + 1 < static_cast<int>(old.begin.size());
    at = known ? old.begin[i] : 0;
    end = known ? old.begin[i + 1] : 0;
  }
};

/// Partners of the rows that site i will have, ascending: what is near, and links however long.
template <int Dim>
void append_partners(const CellGrid<Dim>& grid, const State<Dim>& state, std::int32_t i, const PairTable& old,
                     std::vector<std::int32_t>& partners) {
  const auto first = static_cast<std::ptrdiff_t>(partners.size());
  grid.append_near(state, i, partners);
  const OldRows rows(old, i);
  for (int r = rows.at; r < rows.end; ++r)
    if (old.state[r] == ContactState::permanent) partners.push_back(old.second[r]);
  std::sort(partners.begin() + first, partners.end());
  partners.erase(std::unique(partners.begin() + first, partners.end()), partners.end());
}

/// Fills state and history of the rows of site i with what the old ones remember.
void carry_over(const PairTable& old, std::int32_t i, PairTable& pairs) {
  OldRows rows(old, i);
  for (int row = pairs.begin[i]; row < pairs.begin[i + 1]; ++row) {
    while (rows.at < rows.end && old.second[rows.at] < pairs.second[row]) ++rows.at;
    const bool found = rows.at < rows.end && old.second[rows.at] == pairs.second[row];
    pairs.first[row] = i;
    pairs.state[row] = found ? old.state[rows.at] : ContactState::open;
    for (int w = 0; w < old.width; ++w)
      pairs.history[static_cast<std::size_t>(row) * old.width + w] =
          found ? old.history[static_cast<std::size_t>(rows.at) * old.width + w] : 0.0;
  }
}

}  // namespace

template <int Dim>
bool NeighborList<Dim>::update(System<Dim>& system) {
  if (!stale(system)) return false;
  build(system);
  return true;
}

template <int Dim>
bool NeighborList<Dim>::stale(const System<Dim>& system) const {
  const Box<Dim>& box = system.box;
  if (!built_ || position_at_build_.size() != system.state.position.size()) return true;
  if (system.pairs.version != version_) return true;  // another table: a state that was put back
  const double strain_change = box.strain - strain_at_build_;
  Vec<Dim> growth;
  double largest_growth = 0;
  for (int d = 0; d < Dim; ++d) {
    growth[d] = box.length[d] / length_at_build_[d];
    largest_growth = std::max(largest_growth, std::abs(growth[d] - 1));
  }
  const double slack = skin_ - (std::abs(strain_change) + largest_growth) * reach_;
  if (!(slack > 0)) return true;
  const double limit = 0.25 * slack * slack, middle = 0.5 * box.length[gradient];
  // How many sites are within the limit; a position that is not a number is not. Few bodies are ever wrapped: the
  // nearest image is asked for only where it matters.
  const auto within = [&](const auto& nearest) {
    std::int64_t count = 0;
    for (std::size_t i = 0; i < position_at_build_.size(); ++i) {
      Vec<Dim> u = system.state.position[i];
      for (int d = 0; d < Dim; ++d) u[d] -= growth[d] * position_at_build_[i][d];
      u[flow] -= strain_change * (position_at_build_[i][gradient] - middle);
      nearest(u);
      count += dot(u, u) <= limit;
    }
    return count;
  };
  const auto all = static_cast<std::int64_t>(position_at_build_.size());
  if (within([](Vec<Dim>&) {}) == all) return false;
  return within([images = box.images()](Vec<Dim>& u) { images.reduce(u); }) != all;
}

/// Radii within which sites may meet something: their own, and half of the longest facet there.
template <int Dim>
std::vector<double> NeighborList<Dim>::reach_of_sites(const System<Dim>& system) const {
  std::vector<double> reach = system.state.radius;
  if (meeting_ == Meeting::sites) return reach;
  std::vector<double> longest(reach.size());
  for (const auto& facet : system.topology.facet)
    for (int a = 0; a < Dim; ++a)
      for (int b = 0; b < a; ++b) {
        const double length = norm(system.state.position[facet[a]] - system.state.position[facet[b]]);
        for (const std::int32_t site : {facet[a], facet[b]}) longest[site] = std::max(longest[site], length);
      }
  for (std::size_t i = 0; i < reach.size(); ++i) reach[i] += 0.5 * longest[i];
  return reach;
}

template <int Dim>
void NeighborList<Dim>::build(System<Dim>& system) {
  const State<Dim>& state = system.state;
  const int n = state.size();
  double sum = 0, largest = 0;
  for (double r : state.radius) sum += r;
  const std::vector<double> radius = reach_of_sites(system);
  for (double r : radius) largest = std::max(largest, r);
  skin_ = relative_skin_ * sum / std::max(n, 1);
  reach_ = 2 * largest + skin_;

  PairTable& pairs = system.pairs;
  std::swap(pairs, old_);
  pairs.width = old_.width;
  pairs.version = version_ = std::max(old_.version, version_) + 1;
  pairs.skin = skin_;
  pairs.begin.assign(static_cast<std::size_t>(n) + 1, 0);

  const CellGrid<Dim> grid(system, radius, skin_, reach_);
  partners_.resize(static_cast<std::size_t>(chunk_count(n)));
  for_chunks(n, [&](std::int64_t c, std::int64_t begin, std::int64_t end) {
    auto& partners = partners_[static_cast<std::size_t>(c)];
    partners.clear();
    for (auto i = static_cast<std::int32_t>(begin); i < end; ++i) {
      const auto before = partners.size();
      append_partners(grid, state, i, old_, partners);
      pairs.begin[i + 1] = static_cast<std::int32_t>(partners.size() - before);
    }
  });
  for (int i = 0; i < n; ++i) pairs.begin[i + 1] += pairs.begin[i];
  pairs.resize(pairs.begin[n]);
  for_chunks(n, [&](std::int64_t c, std::int64_t begin, std::int64_t end) {
    const auto& partners = partners_[static_cast<std::size_t>(c)];
    std::copy(partners.begin(), partners.end(), pairs.second.begin() + pairs.begin[begin]);
    for (auto i = static_cast<std::int32_t>(begin); i < end; ++i) carry_over(old_, i, pairs);
  });

  position_at_build_ = state.position;
  strain_at_build_ = system.box.strain;
  length_at_build_ = system.box.length;
  built_ = true;
  ++builds_;
}

template class NeighborList<2>;
template class NeighborList<3>;

}  // namespace supple
