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
  CellGrid(const System<Dim>& system, double reach) : box_(system.box), reach_(reach) {
    long cells = 1;
    for (int d = 0; d < Dim; ++d) {
      // A row is searched over up to four cells along the flow, three across; fewer would meet a cell twice.
      const int least = d == flow ? 4 : 3;
      count_[d] = std::clamp(static_cast<int>(box_.length[d] / reach), 1, 1 << 10);
      if (count_[d] < least) single_ = true;
    }
    if (single_) for (int& n : count_) n = 1;
    for (int n : count_) cells *= n;
    sort(system.state.position, cells);
  }

  /// visit(j) for every site that may be within reach of x, each once.
  template <class Visit>
  void near(const Vec<Dim>& x, Visit&& visit) const {
    if (single_) {
      for (std::int32_t j : sites_) visit(j);
      return;
    }
    int offset[Dim];
    for_rows(x, 1, offset, visit);
  }

 private:
  int cell_of(const Vec<Dim>& x, int d) const {
    const double c = std::floor(x[d] / box_.length[d] * count_[d]);
    return c > 0 ? static_cast<int>(std::min(c, count_[d] - 1.0)) : 0;  // also where c is not a number
  }
  void sort(const std::vector<Vec<Dim>>& position, long cells) {
    std::vector<std::int32_t> cell(position.size());
    begin_.assign(static_cast<std::size_t>(cells) + 1, 0);
    for (std::size_t i = 0; i < position.size(); ++i) {
      long index = 0;
      for (int d = Dim - 1; d >= 0; --d) index = index * count_[d] + cell_of(position[i], d);
      cell[i] = static_cast<std::int32_t>(index);
      ++begin_[static_cast<std::size_t>(index) + 1];
    }
    for (std::size_t c = 1; c < begin_.size(); ++c) begin_[c] += begin_[c - 1];
    sites_.resize(position.size());
    std::vector<std::int32_t> next(begin_.begin(), begin_.end() - 1);
    for (std::size_t i = 0; i < position.size(); ++i) sites_[next[cell[i]]++] = static_cast<std::int32_t>(i);
  }
  template <class Visit>
  void for_rows(const Vec<Dim>& x, int d, int (&offset)[Dim], Visit&& visit) const {
    if (d == Dim) return visit_row(x, offset, visit);
    for (int o = -1; o <= 1; ++o) {
      offset[d] = o;
      for_rows(x, d + 1, offset, visit);
    }
  }
  template <class Visit>
  void visit_row(const Vec<Dim>& x, const int (&offset)[Dim], Visit&& visit) const {
    long row = 0;
    double shift = 0;
    for (int d = Dim - 1; d >= 1; --d) {
      int c = cell_of(x, d) + offset[d];
      if (c < 0 || c >= count_[d]) {
        if (!box_.periodic[d]) return;
        const int up = c < 0 ? -1 : 1;
        c -= up * count_[d];
        if (d == gradient) shift = -up * box_.strain * box_.length[gradient];
      }
      row = row * count_[d] + c;
    }
    const double cell = box_.length[flow] / count_[flow], at = x[flow] + shift;
    if (!std::isfinite(at)) return;
    long low = static_cast<long>(std::floor((at - reach_) / cell));
    long high = static_cast<long>(std::floor((at + reach_) / cell));
    if (!box_.periodic[flow]) {
      low = std::clamp(low, 0L, count_[flow] - 1L);
      high = std::clamp(high, 0L, count_[flow] - 1L);
    } else if (high - low >= count_[flow]) {
      high = low + count_[flow] - 1;
    }
    for (long c = low; c <= high; ++c) {
      const long wrapped = ((c % count_[flow]) + count_[flow]) % count_[flow];
      const long index = row * count_[flow] + wrapped;
      for (std::int32_t k = begin_[index]; k < begin_[index + 1]; ++k) visit(sites_[k]);
    }
  }

  const Box<Dim>& box_;
  double reach_;
  bool single_ = false;
  int count_[Dim];
  std::vector<std::int32_t> begin_, sites_;
};

/// Rows of one site, new neighbours and old links merged, with what old rows remember.
void append_rows(std::int32_t i, std::vector<std::int32_t>& near, const PairTable& old, PairTable& rows) {
  const bool known = i + 1 < static_cast<int>(old.begin.size());
  int at = known ? old.begin[i] : 0;
  const int end = known ? old.begin[i + 1] : 0;
  for (int r = at; r < end; ++r)
    if (old.state[r] == ContactState::permanent) near.push_back(old.second[r]);
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  for (std::int32_t j : near) {
    while (at < end && old.second[at] < j) ++at;
    const bool found = at < end && old.second[at] == j;
    rows.first.push_back(i);
    rows.second.push_back(j);
    rows.state.push_back(found ? old.state[at] : ContactState::open);
    for (int w = 0; w < old.width; ++w)
      rows.history.push_back(found ? old.history[static_cast<std::size_t>(at) * old.width + w] : 0.0);
  }
}

void concatenate(std::vector<PairTable>& chunks, int sites, PairTable& pairs) {
  const int width = pairs.width;
  const auto version = pairs.version;
  pairs.clear();
  pairs.width = width;
  pairs.version = version + 1;
  for (const PairTable& c : chunks) {
    pairs.first.insert(pairs.first.end(), c.first.begin(), c.first.end());
    pairs.second.insert(pairs.second.end(), c.second.begin(), c.second.end());
    pairs.state.insert(pairs.state.end(), c.state.begin(), c.state.end());
    pairs.history.insert(pairs.history.end(), c.history.begin(), c.history.end());
  }
  index_rows(pairs, sites);
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
  if (!built_ || position_at_build_.size() != system.state.position.size() || !(length_at_build_ == box.length)) return true;
  const double strain_change = box.strain - strain_at_build_;
  const double slack = skin_ - std::abs(strain_change) * reach_;
  if (slack <= 0) return true;
  const double limit = 0.25 * slack * slack;
  for (std::size_t i = 0; i < position_at_build_.size(); ++i) {
    Vec<Dim> affine = position_at_build_[i];
    affine[flow] += strain_change * (affine[gradient] - 0.5 * box.length[gradient]);
    const Vec<Dim> u = box.displacement(affine, system.state.position[i]);
    // Written so that a position that is not a number is stale, too.
    if (!(dot(u, u) <= limit)) return true;
  }
  return false;
}

template <int Dim>
void NeighborList<Dim>::build(System<Dim>& system) {
  const State<Dim>& state = system.state;
  const int n = state.size();
  double sum = 0, largest = 0;
  for (double r : state.radius) {
    sum += r;
    largest = std::max(largest, r);
  }
  skin_ = relative_skin_ * sum / std::max(n, 1);
  reach_ = 2 * largest + skin_;

  const CellGrid<Dim> grid(system, reach_);
  std::vector<PairTable> chunks(static_cast<std::size_t>(chunk_count(n)));
  for_chunks(n, [&](std::int64_t c, std::int64_t begin, std::int64_t end) {
    std::vector<std::int32_t> near;
    for (std::int32_t i = static_cast<std::int32_t>(begin); i < end; ++i) {
      near.clear();
      grid.near(state.position[i], [&](std::int32_t j) {
        if (j <= i) return;
        const Vec<Dim> r = system.box.displacement(state.position[i], state.position[j]);
        const double reach = state.radius[i] + state.radius[j] + skin_;
        if (dot(r, r) < reach * reach) near.push_back(j);
      });
      append_rows(i, near, system.pairs, chunks[static_cast<std::size_t>(c)]);
    }
  });
  concatenate(chunks, n, system.pairs);

  position_at_build_ = state.position;
  strain_at_build_ = system.box.strain;
  length_at_build_ = system.box.length;
  built_ = true;
  ++builds_;
}

template class NeighborList<2>;
template class NeighborList<3>;

}  // namespace supple
