#include "supple/geometry/nearest_in_hull.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace supple {

namespace {

/// At most four affinely independent points, and the weights of the nearest point of their hull.
struct Corral {
  std::array<Vec3, 4> point;
  std::array<double, 4> weight{};
  int size = 0;

  Vec3 nearest() const {
    Vec3 x{};
    for (int k = 0; k < size; ++k) x += weight[k] * point[k];
    return x;
  }

  /// Weights of the point of the affine hull that is nearest to the origin: (G + 1) u = 1, w = u / sum u with
  /// the Gram matrix G. False where the points are not independent, to rounding.
  bool affine_weights(std::array<double, 4>& out) const {
    double a[4][5];
    for (int i = 0; i < size; ++i) {
      for (int j = 0; j < size; ++j) a[i][j] = dot(point[i], point[j]) + 1;
      a[i][size] = 1;
    }
    for (int c = 0; c < size; ++c) {
      int pivot = c;
      for (int r = c + 1; r < size; ++r)
        if (std::abs(a[r][c]) > std::abs(a[pivot][c])) pivot = r;
      if (std::abs(a[pivot][c]) < 1e-14) return false;
      std::swap(a[c], a[pivot]);
      for (int r = 0; r < size; ++r)
        if (const double share = a[r][c] / a[c][c]; r != c)
          for (int k = c; k <= size; ++k) a[r][k] -= share * a[c][k];
    }
    double sum = 0;
    for (int c = 0; c < size; ++c) sum += out[c] = a[c][size] / a[c][c];
    for (int c = 0; c < size; ++c) out[c] /= sum;
    return true;
  }

  void drop(int k) {
    --size;
    point[k] = point[size];
    weight[k] = weight[size];
  }

  /// Moves to the nearest point of the hull of these points, and drops those that it does not need.
  bool reduce() {
    std::array<double, 4> wanted{};
    while (size > 0) {
      if (!affine_weights(wanted)) return false;
      double step = 1;
      int leaves = -1;
      for (int k = 0; k < size; ++k)
        if (wanted[k] <= 0)
          if (const double s = weight[k] / (weight[k] - wanted[k]); leaves < 0 || s < step)
            step = s, leaves = k;
      for (int k = 0; k < size; ++k) weight[k] += step * (wanted[k] - weight[k]);
      if (leaves < 0) return true;
      drop(leaves);
    }
    return false;
  }
};

}  // namespace

double distance_to_hull(std::span<const Vec3> points) {
  if (points.empty()) return std::numeric_limits<double>::infinity();
  const auto shorter = [](const Vec3& a, const Vec3& b) { return dot(a, a) < dot(b, b); };
  const auto [least, most] = std::minmax_element(points.begin(), points.end(), shorter);
  const double rounding = 1e-9 * norm(*most);
  Corral corral;
  corral.point[0] = *least;
  corral.weight[0] = corral.size = 1;
  Vec3 x = *least;
  for (int round = 0; round < 1000 && norm(x) > rounding; ++round) {
    const Vec3& next = *std::min_element(points.begin(), points.end(),
                                         [&](const Vec3& a, const Vec3& b) { return dot(x, a) < dot(x, b); });
    if (dot(x, x - next) <= rounding * norm(x) || corral.size == 4) break;
    corral.point[corral.size] = next;
    corral.weight[corral.size++] = 0;
    if (!corral.reduce()) break;
    x = corral.nearest();
  }
  return norm(x) > rounding ? norm(x) : 0;
}

}  // namespace supple
