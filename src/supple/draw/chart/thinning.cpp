#include <algorithm>
#include <array>
#include <cmath>

#include "supple/draw/chart/chart.hpp"

namespace supple {

namespace {

/// Neighbours on a curve, by their indices: the ends, and where x and y are last least and greatest, so that
/// a level stretch stays level to its end.
struct Run {
  std::size_t first, last, least[2], most[2];

  explicit Run(std::size_t i) : first(i), last(i), least{i, i}, most{i, i} {}
  void add(std::span<const Vec2> curve, std::size_t i) {
    last = i;
    for (int d = 0; d < 2; ++d) {
      if (curve[i][d] <= curve[least[d]][d]) least[d] = i;
      if (curve[i][d] >= curve[most[d]][d]) most[d] = i;
    }
  }
  double extent(std::span<const Vec2> curve) const {
    return std::min(curve[most[0]][0] - curve[least[0]][0], curve[most[1]][1] - curve[least[1]][1]);
  }
  void keep(std::span<const Vec2> curve, std::vector<Vec2>& kept) const {
    std::array<std::size_t, 6> index{first, least[0], most[0], least[1], most[1], last};
    std::sort(index.begin(), index.end());
    const auto end = std::unique(index.begin(), index.end());
    for (auto i = index.begin(); i != end; ++i) kept.push_back(curve[*i]);
  }
};

bool is_finite(const Vec2& x) { return std::isfinite(x[0]) && std::isfinite(x[1]); }

}  // namespace

std::vector<Vec2> thin(std::span<const Vec2> curve, double resolution) {
  std::vector<Vec2> kept;
  for (std::size_t i = 0; i < curve.size();) {
    if (!is_finite(curve[i])) {
      kept.push_back(curve[i++]);
      continue;
    }
    Run run(i++);
    for (Run longer = run; i < curve.size() && is_finite(curve[i]); ++i) {
      longer.add(curve, i);
      if (longer.extent(curve) >= resolution) break;
      run = longer;
    }
    run.keep(curve, kept);
  }
  return kept;
}

}  // namespace supple
