#include "supple/contact/neighbor_list.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "supple/contact/reach.hpp"
#include "supple/contact/site_grid.hpp"
#include "supple/core/parallel.hpp"
#include "supple/model/row_separation.hpp"

namespace supple {

namespace {

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
void append_partners(const SiteGrid<Dim>& grid, std::int32_t i, const PairTable& old,
                     std::vector<std::int32_t>& partners) {
  const auto first = static_cast<std::ptrdiff_t>(partners.size());
  grid.append_near(i, partners);
  const OldRows rows(old, i);
  for (int r = rows.at; r < rows.end; ++r)
    if (old.state[r] == ContactState::permanent) partners.push_back(old.second[r]);
  std::sort(partners.begin() + first, partners.end());
  partners.erase(std::unique(partners.begin() + first, partners.end()), partners.end());
}

/// Fills state, history and image of the rows of a site with what the old ones remember.
template <int Dim>
class CarryOver {
 public:
  CarryOver(const System<Dim>& system, const PairTable& old, double skin, double reach)
      : state_(system.state), old_(old), images_(system.box.lattice()) {
    double shortest = std::numeric_limits<double>::infinity();
    for (int d = 0; d < Dim; ++d)
      if (system.box.periodic[d]) shortest = std::min(shortest, system.box.length[d]);
    // While the table lives two sites change their distance d by less than skin + d skin/reach, and the
    // period by less than skin/reach of itself.
    const double change = reach > 0 ? skin / reach : 0;
    longest_ = (0.5 * shortest * (1 - change) - skin) / (1 + change);
  }

  /// Returns whether a link is so long that another image may come nearer while the table lives.
  bool fill(std::int32_t i, PairTable& pairs) const {
    OldRows rows(old_, i);
    bool long_link = false;
    for (int row = pairs.begin[i]; row < pairs.begin[i + 1]; ++row) {
      while (rows.at < rows.end && old_.second[rows.at] < pairs.second[row]) ++rows.at;
      const bool found = rows.at < rows.end && old_.second[rows.at] == pairs.second[row];
      pairs.first[row] = i;
      pairs.state[row] = found ? old_.state[rows.at] : ContactState::open;
      for (int w = 0; w < old_.width; ++w)
        pairs.history[static_cast<std::size_t>(row) * old_.width + w] =
            found ? old_.history[static_cast<std::size_t>(rows.at) * old_.width + w] : 0.0;
      pairs.image[row] = {};
      if (pairs.state[row] == ContactState::permanent)
        long_link |=
            keep_image(state_.position[pairs.second[row]] - state_.position[i], rows.at, pairs.image[row]);
    }
    return long_link;
  }

 private:
  bool keep_image(Vec<Dim> r, int old_row, RowImage& image) const {
    if (!old_.image.empty() && old_.image[old_row].kept) {
      image = old_.image[old_row];
      images_.subtract(cells_of<Dim>(image), r);
    } else {
      const Vec<Dim> cells = images_.reduce(r);
      for (int d = 0; d < Dim; ++d)
        image.cells[static_cast<std::size_t>(d)] = static_cast<std::int32_t>(cells[d]);
      image.kept = true;
    }
    return !(norm(r) < longest_);
  }

  const State<Dim>& state_;
  const PairTable& old_;
  Lattice<Dim> images_;
  double longest_;
};

}  // namespace

template <int Dim>
bool NeighborList<Dim>::update(System<Dim>& system) {
  const bool rebuild = stale(system);
  if (rebuild) build(system);
  else require_periods(system.box);
  return rebuild;
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
  // How many sites are within the limit; a position that is not a number is not. Few bodies are ever wrapped:
  // the nearest image is asked for only where it matters.
  const auto all = static_cast<std::int64_t>(position_at_build_.size());
  const auto within = [&](const auto& nearest) {
    return sum_chunks<std::int64_t>(all, [&](std::int64_t begin, std::int64_t end) {
      std::int64_t count = 0;
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
        Vec<Dim> u = system.state.position[i];
        for (int d = 0; d < Dim; ++d) u[d] -= growth[d] * position_at_build_[i][d];
        u[flow] -= strain_change * (position_at_build_[i][gradient] - middle);
        nearest(u);
        count += dot(u, u) <= limit;
      }
      return count;
    });
  };
  if (within([](Vec<Dim>&) {}) == all) return false;
  return within([images = box.lattice()](Vec<Dim>& u) { images.reduce(u); }) != all;
}

template <int Dim>
void NeighborList<Dim>::require_periods(const Box<Dim>& box) const {
  if (const auto period = short_period(box, least_period_)) throw period->error(ErrorKind::input);
}

template <int Dim>
void NeighborList<Dim>::build(System<Dim>& system) {
  const State<Dim>& state = system.state;
  const int n = state.size();
  double sum = 0, largest = 0;
  for (double r : state.radius) sum += r;
  const std::vector<double> radius = reach_of_sites(system, meeting_, range_);
  least_period_ = least_period(system, radius);
  require_periods(system.box);
  for (double r : radius) largest = std::max(largest, r);
  skin_ = relative_skin_ * sum / std::max(n, 1);
  reach_ = 2 * largest + skin_;

  PairTable& pairs = system.pairs;
  std::swap(pairs, old_);
  pairs.width = old_.width;
  pairs.version = version_ = new_version();
  pairs.skin = skin_;
  pairs.reach = reach_;
  pairs.begin.assign(static_cast<std::size_t>(n) + 1, 0);

  const SiteGrid<Dim> grid(system, radius, skin_);
  partners_.resize(static_cast<std::size_t>(chunk_count(n)));
  for_chunks(n, [&](std::int64_t c, std::int64_t begin, std::int64_t end) {
    auto& partners = partners_[static_cast<std::size_t>(c)];
    partners.clear();
    for (auto i = static_cast<std::int32_t>(begin); i < end; ++i) {
      const auto before = partners.size();
      append_partners(grid, i, old_, partners);
      pairs.begin[i + 1] = static_cast<std::int32_t>(partners.size() - before);
    }
  });
  for (int i = 0; i < n; ++i) pairs.begin[i + 1] += pairs.begin[i];
  pairs.resize(pairs.begin[n]);
  pairs.image.resize(pairs.first.size());
  const CarryOver<Dim> carry_over(system, old_, skin_, reach_);
  std::vector<std::uint8_t> long_links(static_cast<std::size_t>(chunk_count(n)), 0);
  for_chunks(n, [&](std::int64_t c, std::int64_t begin, std::int64_t end) {
    const auto& partners = partners_[static_cast<std::size_t>(c)];
    std::copy(partners.begin(), partners.end(), pairs.second.begin() + pairs.begin[begin]);
    for (auto i = static_cast<std::int32_t>(begin); i < end; ++i)
      long_links[static_cast<std::size_t>(c)] |= carry_over.fill(i, pairs);
  });
  if (std::find(long_links.begin(), long_links.end(), 1) == long_links.end()) pairs.image.clear();

  position_at_build_ = state.position;
  strain_at_build_ = system.box.strain;
  length_at_build_ = system.box.length;
  built_ = true;
  ++builds_;
}

template class NeighborList<2>;
template class NeighborList<3>;

}  // namespace supple
