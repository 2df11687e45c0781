#include "supple/geometry/nearest_in_hull.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace supple {

namespace {

/// At most Dim + 1 affinely independent points, and the weights of the nearest point of their hull.
template <int Dim>
struct Corral {
  static constexpr int most = Dim + 1;
  std::array<Vec<Dim>, most> point;
  std::array<double, most> weight{};
  int size = 0;

  Vec<Dim> nearest() const {
    Vec<Dim> x{};
    for (int k = 0; k < size; ++k) x += weight[k] * point[k];
    return x;
  }

  /// Weights of the point of the affine hull that is nearest to the origin: (G + 1) u = 1, w = u / sum u with
  /// the Gram matrix G. False where the points are not independent, to rounding.
  bool affine_weights(std::array<double, most>& out) const {
    double a[most][most + 1];
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
    std::array<double, most> wanted{};
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

template <int Dim>
double distance_to_hull(std::span<const Vec<Dim>> points) {
  if (points.empty()) return std::numeric_limits<double>::infinity();
  const auto shorter = [](const Vec<Dim>& a, const Vec<Dim>& b) { return dot(a, a) < dot(b, b); };
  const auto [least, most] = std::minmax_element(points.begin(), points.end(), shorter);
  const double rounding = 1e-9 * norm(*most);
  Corral<Dim> corral;
  corral.point[0] = *least;
  corral.weight[0] = corral.size = 1;
  Vec<Dim> x = *least;
  for (int round = 0; round < 1000 && norm(x) > rounding; ++round) {
    const Vec<Dim>& next =
        *std::min_element(points.begin(), points.end(),
                          [&](const Vec<Dim>& a, const Vec<Dim>& b) { return dot(x, a) < dot(x, b); });
    if (dot(x, x - next) <= rounding * norm(x) || corral.size == Corral<Dim>::most) break;
    corral.point[corral.size] = next;
    corral.weight[corral.size++] = 0;
    if (!corral.reduce()) break;
    x = corral.nearest();
  }
  return norm(x) > rounding ? norm(x) : 0;
}

template double distance_to_hull(std::span<const Vec2>);
template double distance_to_hull(std::span<const Vec3>);
template double distance_to_hull(std::span<const Vec<6>>);

}  // namespace supple
