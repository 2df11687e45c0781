#include "supple/observe/touching_plates.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "supple/core/error.hpp"

namespace supple {

template <int Dim>
PlateForces sum_plate_forces(std::span<const SiteForce<Dim>> wall) {
  PlateForces sum;
  for (const SiteForce<Dim>& w : wall) {
    const double up = w.force[Dim - 1];
    if (up > 0) sum.lower += up, ++sum.lower_sites;
    if (up < 0) sum.upper -= up, ++sum.upper_sites;
  }
  return sum;
}

template <int Dim>
BodyReach reach_along(const System<Dim>& system, int body, int direction) {
  constexpr double far = std::numeric_limits<double>::infinity();
  BodyReach reach{far, -far};
  for (int i = system.topology.body_begin(body); i < system.topology.body_end(body); ++i) {
    const double x = system.state.position[i][direction], radius = system.state.radius[i];
    reach.low = std::min(reach.low, x - radius);
    reach.high = std::max(reach.high, x + radius);
  }
  return reach;
}

namespace {

template <int Dim>
Vec<Dim> mean_of(std::span<const Vec<Dim>> points) {
  Vec<Dim> sum{};
  for (const Vec<Dim>& p : points) sum += p;
  return (1.0 / static_cast<double>(points.size())) * sum;
}

/// The nearest rotation of pairs with the sums s_kl = sum p_k q_l: in 2D the one that makes sum (R p).q
/// largest.
double nearest_turn(const Mat<2>& s) { return std::abs(std::atan2(s[0][1] - s[1][0], s[0][0] + s[1][1])); }
/// In 3D the quaternion of that rotation is the eigenvector of the largest eigenvalue of this matrix.
double nearest_turn(const Mat<3>& s) {
  const double x = s[1][2] - s[2][1], y = s[2][0] - s[0][2], z = s[0][1] - s[1][0];
  Eigen::Matrix4d m;
  m << s[0][0] + s[1][1] + s[2][2], x, y, z,                                 //
      x, s[0][0] - s[1][1] - s[2][2], s[0][1] + s[1][0], s[2][0] + s[0][2],  //
      y, s[0][1] + s[1][0], s[1][1] - s[0][0] - s[2][2], s[1][2] + s[2][1],  //
      z, s[2][0] + s[0][2], s[1][2] + s[2][1], s[2][2] - s[0][0] - s[1][1];
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(m);
  const Eigen::Vector4d q = solver.eigenvectors().col(3);
  return 2 * std::atan2(std::sqrt(q[1] * q[1] + q[2] * q[2] + q[3] * q[3]), std::abs(q[0]));
}

}  // namespace

template <int Dim>
double turned_by(std::span<const Vec<Dim>> before, std::span<const Vec<Dim>> after) {
  if (before.size() != after.size())
    throw input_error("cannot say how far points have turned", "there are not as many as before");
  if (before.size() < 2) return 0;
  const Vec<Dim> from = mean_of(before), to = mean_of(after);
  Mat<Dim> sums{};
  for (std::size_t k = 0; k < before.size(); ++k) sums.add_outer(1, before[k] - from, after[k] - to);
  return nearest_turn(sums);
}

#define SUPPLE_TOUCHING(Dim)                                              \
  template PlateForces sum_plate_forces(std::span<const SiteForce<Dim>>); \
  template BodyReach reach_along(const System<Dim>&, int, int);           \
  template double turned_by(std::span<const Vec<Dim>>, std::span<const Vec<Dim>>);
SUPPLE_TOUCHING(2)
SUPPLE_TOUCHING(3)
#undef SUPPLE_TOUCHING

}  // namespace supple
