#include "supple/contact/row_images.hpp"

#include <algorithm>

namespace supple {

template <int Dim>
bool RowImages<Dim>::update(const System<Dim>& system) {
  const PairTable& pairs = system.pairs;
  const bool same_rows =
      version_ == pairs.version && index_.size() == static_cast<std::size_t>(pairs.size()) && !cells_.empty();
  if (same_rows && good_while_rows_live(system)) return false;
  before_.clear();
  if (same_rows)
    for (const std::int32_t k : index_) before_.push_back(cells_[k]);
  version_ = pairs.version;
  find(system);
  if (!same_rows) return true;
  for (std::size_t row = 0; row < index_.size(); ++row)
    if (!(cells_[index_[row]] == before_[row])) return true;
  return false;
}

/// A second image of a row's pair is at least a period less the distance of the first one away.
template <int Dim>
bool RowImages<Dim>::good_while_rows_live(const System<Dim>& system) const {
  for (int d = 0; d < Dim; ++d)
    if (system.box.periodic[d] && system.box.length[d] < 2 * system.pairs.reach) return false;
  return true;
}

template <int Dim>
void RowImages<Dim>::find(const System<Dim>& system) {
  const PairTable& pairs = system.pairs;
  cells_.assign(1, Vec<Dim>{});
  index_.resize(static_cast<std::size_t>(pairs.size()));
  const auto images = system.box.lattice();
  for (int row = 0; row < pairs.size(); ++row) {
    Vec<Dim> r = system.state.position[pairs.second[row]] - system.state.position[pairs.first[row]];
    const Vec<Dim> cells = images.reduce(r);
    auto at = std::find(cells_.begin(), cells_.end(), cells);
    if (at == cells_.end()) at = cells_.insert(at, cells);
    index_[row] = static_cast<std::int32_t>(at - cells_.begin());
  }
}

template <int Dim>
const std::vector<Vec<Dim>>& RowImages<Dim>::shifts(const Box<Dim>& box) {
  shifts_.resize(cells_.size());
  const Lattice<Dim> lattice = box.lattice();
  for (std::size_t k = 0; k < cells_.size(); ++k) shifts_[k] = lattice.vector(cells_[k]);
  return shifts_;
}

template class RowImages<2>;
template class RowImages<3>;

}  // namespace supple
