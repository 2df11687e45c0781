#include "supple/solve/degrees.hpp"

#include <algorithm>
#include <cstring>

#include "supple/core/rotation.hpp"
#include "supple/model/rigid.hpp"

namespace supple {

static_assert(sizeof(Vec2) == 2 * sizeof(double) && sizeof(Vec3) == 3 * sizeof(double),
              "positions are copied as numbers");

/// The index of a number, and dx/dq of a site for it.
template <int Dim>
struct BodyDegrees<Dim>::Column {
  std::int32_t index;
  Vec<Dim> slope;
};
template <int Dim>
struct BodyDegrees<Dim>::Columns {
  int count = 0;
  Column column[rigid_numbers<Dim>];
  const Column* begin() const { return column; }
  const Column* end() const { return column + count; }
};

namespace {

/// Angles of a rigid body.
template <int Dim>
constexpr int angles = rigid_numbers<Dim> - Dim;

/// Component k of an angle or torque, of which there is one in 2D.
double& part(double& angle, int) { return angle; }
double part(const double& angle, int) { return angle; }
double& part(Vec3& angle, int k) { return angle[k]; }
double part(const Vec3& angle, int k) { return angle[k]; }

Vec3 column_of(const Mat<3>& m, int c) { return {m[0][c], m[1][c], m[2][c]}; }

/// What a torque does along the numbers of the angle: T^T torque.
double along_angles(double, double torque) { return torque; }
Vec3 along_angles(const Vec3& angle, const Vec3& torque) {
  const Mat<3> t = turning(angle);
  return {dot(column_of(t, 0), torque), dot(column_of(t, 1), torque), dot(column_of(t, 2), torque)};
}

}  // namespace

template <int Dim>
BodyDegrees<Dim>::BodyDegrees(const System<Dim>& system) {
  const auto n = static_cast<std::size_t>(system.state.size());
  first_.assign(n, -1);
  rigid_.assign(n, -1);
  for (int r = 0; r < system.rigid.size(); ++r) {
    const int b = system.rigid.body[r];
    for (int i = system.topology.body_begin(b); i < system.topology.body_end(b); ++i) rigid_[i] = r;
  }
  for (std::int32_t i = 0; i < system.state.size(); ++i)
    if (rigid_[i] < 0 && system.state.mobility[i] == Mobility::free) {
      first_[i] = size_;
      size_ += Dim;
      sites_.push_back(i);
    }
  plain_ = sites_.size() == n;
  for (int r = 0; r < system.rigid.size(); ++r) {
    if (held(system, r)) continue;
    const int b = system.rigid.body[r];
    for (int i = system.topology.body_begin(b); i < system.topology.body_end(b); ++i) first_[i] = size_;
    size_ += rigid_numbers<Dim>;
    bodies_.push_back(r);
  }
}

template <int Dim>
void BodyDegrees<Dim>::read(const System<Dim>& system, std::span<double> q) const {
  if (plain_) {
    if (size_ > 0)
      std::memcpy(q.data(), system.state.position.data(), static_cast<std::size_t>(size_) * sizeof(double));
    return;
  }
  double* at = q.data();
  for (const std::int32_t i : sites_)
    for (int d = 0; d < Dim; ++d) *at++ = system.state.position[i][d];
  for (const std::int32_t r : bodies_) {
    for (int d = 0; d < Dim; ++d) *at++ = system.rigid.centre[r][d];
    const double radius = gyration_radius(system.rigid, r);
    for (int k = 0; k < angles<Dim>; ++k) *at++ = part(system.rigid.angle[r], k) * radius;
  }
}

template <int Dim>
void BodyDegrees<Dim>::write(std::span<const double> q, System<Dim>& system) const {
  if (plain_) {
    if (size_ > 0)
      std::memcpy(static_cast<void*>(system.state.position.data()), q.data(),
                  static_cast<std::size_t>(size_) * sizeof(double));
    return;
  }
  const double* at = q.data();
  for (const std::int32_t i : sites_)
    for (int d = 0; d < Dim; ++d) system.state.position[i][d] = *at++;
  for (const std::int32_t r : bodies_) {
    for (int d = 0; d < Dim; ++d) system.rigid.centre[r][d] = *at++;
    const double radius = gyration_radius(system.rigid, r);
    for (int k = 0; k < angles<Dim>; ++k) part(system.rigid.angle[r], k) = *at++ / radius;
  }
  place_sites(system);
}

template <int Dim>
void BodyDegrees<Dim>::gradient(const System<Dim>& system, const std::vector<Vec<Dim>>& force,
                                std::span<double> g) const {
  double* at = g.data();
  for (const std::int32_t i : sites_)
    for (int d = 0; d < Dim; ++d) *at++ = -force[i][d];
  for (const std::int32_t r : bodies_) {
    const RigidForceOf<Dim> on_body = force_on_rigid(system, force, r);
    const Angular<Dim> along = along_angles(system.rigid.angle[r], on_body.torque);
    const double radius = gyration_radius(system.rigid, r);
    for (int d = 0; d < Dim; ++d) *at++ = -on_body.force[d];
    for (int k = 0; k < angles<Dim>; ++k) *at++ = -part(along, k) / radius;
  }
}

template <int Dim>
typename BodyDegrees<Dim>::Columns BodyDegrees<Dim>::columns_of(const System<Dim>& system,
                                                                std::int32_t site) const {
  const std::int32_t first = first_[site], r = rigid_[site];
  if (first < 0) return {};
  Columns columns{Dim, {}};
  for (int d = 0; d < Dim; ++d) {
    columns.column[d].index = first + d;
    columns.column[d].slope[d] = 1;
  }
  if (r < 0) return columns;
  const Vec<Dim> arm = system.state.position[site] - system.rigid.centre[r];
  const double scale = 1 / gyration_radius(system.rigid, r);
  if constexpr (Dim == 2) {
    columns.column[columns.count++] = {first + 2, scale * turned_left(arm)};
  } else {
    const Mat<3> t = turning(system.rigid.angle[r]);
    for (int k = 0; k < 3; ++k)
      columns.column[columns.count++] = {first + 3 + k, scale * cross(column_of(t, k), arm)};
  }
  return columns;
}

namespace {

/// The Hessian where every number is a coordinate of a site, so that nothing must be looked up.
template <int Dim>
void copy_blocks(const HessianBlocks<Dim>& blocks, std::vector<MatrixEntry>& entries) {
  for (const HessianBlock<Dim>& block : blocks)
    for (int c = 0; c < Dim; ++c)
      for (int d = 0; d < Dim; ++d) {
        const std::int32_t row = Dim * block.a + c, column = Dim * block.b + d;
        if (block.a == block.b && row < column) continue;
        entries.emplace_back(std::max(row, column), std::min(row, column), block.h[c][d]);
      }
}

}  // namespace

template <int Dim>
void BodyDegrees<Dim>::hessian(const System<Dim>& system, const HessianBlocks<Dim>& blocks,
                               const std::vector<Vec<Dim>>& force, std::vector<MatrixEntry>& entries) const {
  entries.clear();
  entries.reserve(static_cast<std::size_t>(Dim * Dim) * blocks.size());
  add_blocks(system, blocks, entries);
  for (const std::int32_t r : bodies_) add_turning(system, system.rigid.body[r], force, entries);
}

template <int Dim>
void BodyDegrees<Dim>::add_blocks(const System<Dim>& system, const HessianBlocks<Dim>& blocks,
                                  std::vector<MatrixEntry>& entries) const {
  if (plain_) return copy_blocks(blocks, entries);
  for (const HessianBlock<Dim>& block : blocks) {
    const Columns rows = columns_of(system, block.a), columns = columns_of(system, block.b);
    for (const Column& p : rows)
      for (const Column& q : columns) {
        if (block.a == block.b && p.index < q.index) continue;
        double value = 0;
        for (int c = 0; c < Dim; ++c)
          for (int d = 0; d < Dim; ++d) value += p.slope[c] * block.h[c][d] * q.slope[d];
        // For two sites of one rigid body the transposed block has the same numbers.
        if (block.a != block.b && p.index == q.index) value *= 2;
        entries.emplace_back(std::max(p.index, q.index), std::min(p.index, q.index), value);
      }
  }
}

namespace {

/// Sum of -F . d2x/dq2, q a rotation vector, over sites x whose forces F have this torque and this moment,
/// the sum of F arm^T. As dx = T dq x arm, d2x/dq_k dq_l = dt_k/dq_l x arm + t_k x (t_l x arm), t_k the
/// columns of T.
Mat<3> by_angles(const Vec3& angle, const Vec3& torque, const Mat<3>& moment) {
  const Mat<3> t = turning(angle), slope = turning_slope(angle, torque);
  const double trace = moment[0][0] + moment[1][1] + moment[2][2];
  Mat<3> h;
  for (int k = 0; k < 3; ++k) {
    const Vec3 along = moment * column_of(t, k);
    for (int l = 0; l < 3; ++l) {
      const Vec3 other = column_of(t, l);
      h[k][l] = dot(other, column_of(t, k)) * trace - dot(other, along) - slope[k][l];
    }
  }
  return h;
}

}  // namespace

template <int Dim>
void BodyDegrees<Dim>::add_turning(const System<Dim>& system, int b, const std::vector<Vec<Dim>>& force,
                                   std::vector<MatrixEntry>& entries) const {
  const int first_site = system.topology.body_begin(b);
  const std::int32_t r = rigid_[first_site];
  if (r < 0 || first_[first_site] < 0) return;
  const std::int32_t angle = first_[first_site] + Dim;
  if constexpr (Dim == 2) {
    double value = 0;  // d2x/d(angle)2 = -arm
    for (int i = first_site; i < system.topology.body_end(b); ++i)
      value += dot(force[i], system.state.position[i] - system.rigid.centre[r]);
    entries.emplace_back(angle, angle, value * system.rigid.mass[r] / system.rigid.inertia[r]);
  } else {
    Mat<3> moment;
    for (int i = first_site; i < system.topology.body_end(b); ++i)
      moment.add_outer(1, force[i], system.state.position[i] - system.rigid.centre[r]);
    const Vec3 torque = force_on_rigid(system, force, r).torque;
    const Mat<3> h = by_angles(system.rigid.angle[r], torque, moment);
    const double radius = gyration_radius(system.rigid, r);
    for (int k = 0; k < 3; ++k)
      for (int l = 0; l <= k; ++l) entries.emplace_back(angle + k, angle + l, h[k][l] / (radius * radius));
  }
}

template <int Dim>
std::vector<double> BodyDegrees<Dim>::masses(const System<Dim>& system) const {
  std::vector<double> masses;
  masses.reserve(static_cast<std::size_t>(size_));
  for (const std::int32_t i : sites_) masses.insert(masses.end(), Dim, system.state.mass[i]);
  // Angle times radius of gyration has the mass of the body.
  for (const std::int32_t r : bodies_) masses.insert(masses.end(), rigid_numbers<Dim>, system.rigid.mass[r]);
  return masses;
}

template class BodyDegrees<2>;
template class BodyDegrees<3>;

}  // namespace supple
