#include "supple/contact/row_images.hpp"

#include <algorithm>

namespace supple {

template <int Dim>
bool RowImages<Dim>::update(const System<Dim>& system) {
  const PairTable& pairs = system.pairs;
  if (version_ == pairs.version && index_.size() == static_cast<std::size_t>(pairs.size()) && !cells_.empty())
    return false;
  version_ = pairs.version;
  cells_.assign(1, Vec<Dim>{});
  index_.resize(static_cast<std::size_t>(pairs.size()));
  const auto images = system.box.images();
  for (int row = 0; row < pairs.size(); ++row) {
    Vec<Dim> r = system.state.position[pairs.second[row]] - system.state.position[pairs.first[row]];
    const Vec<Dim> cells = images.reduce(r);
    auto at = std::find(cells_.begin(), cells_.end(), cells);
    if (at == cells_.end()) at = cells_.insert(at, cells);
    index_[row] = static_cast<std::int32_t>(at - cells_.begin());
  }
  return true;
}

template <int Dim>
const std::vector<Vec<Dim>>& RowImages<Dim>::shifts(const Box<Dim>& box) {
  shifts_.resize(cells_.size());
  for (std::size_t k = 0; k < cells_.size(); ++k) {
    for (int d = 0; d < Dim; ++d) shifts_[k][d] = cells_[k][d] * box.length[d];
    shifts_[k][flow] += cells_[k][gradient] * (box.strain * box.length[gradient]);
  }
  return shifts_;
}

template class RowImages<2>;
template class RowImages<3>;

}  // namespace supple
