#include "supple/solve/degrees.hpp"

#include <algorithm>
#include <cstring>

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
  Column column[3];
  const Column* begin() const { return column; }
  const Column* end() const { return column + count; }
};

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
  if constexpr (Dim == 2)
    for (int r = 0; r < system.rigid.size(); ++r) {
      if (held(system, r)) continue;
      const int b = system.rigid.body[r];
      for (int i = system.topology.body_begin(b); i < system.topology.body_end(b); ++i) first_[i] = size_;
      size_ += 3;
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
  if constexpr (Dim == 2)
    for (const std::int32_t r : bodies_) {
      for (int d = 0; d < 2; ++d) *at++ = system.rigid.centre[r][d];
      *at++ = system.rigid.angle[r] * gyration_radius(system.rigid, r);
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
  if constexpr (Dim == 2)
    for (const std::int32_t r : bodies_) {
      for (int d = 0; d < 2; ++d) system.rigid.centre[r][d] = *at++;
      system.rigid.angle[r] = *at++ / gyration_radius(system.rigid, r);
    }
  if constexpr (Dim == 2) place_sites(system);
}

template <int Dim>
void BodyDegrees<Dim>::gradient(const System<Dim>& system, const std::vector<Vec<Dim>>& force,
                                std::span<double> g) const {
  double* at = g.data();
  for (const std::int32_t i : sites_)
    for (int d = 0; d < Dim; ++d) *at++ = -force[i][d];
  if constexpr (Dim == 2)
    for (const std::int32_t r : bodies_) {
      const RigidForce on_body = force_on_rigid(system, force, r);
      for (int d = 0; d < 2; ++d) *at++ = -on_body.force[d];
      *at++ = -on_body.torque / gyration_radius(system.rigid, r);
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
  if constexpr (Dim == 2) {
    const Vec2 arm = system.state.position[site] - system.rigid.centre[r];
    columns.column[columns.count++] = {first + 2, (1 / gyration_radius(system.rigid, r)) * turned_left(arm)};
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

template <int Dim>
void BodyDegrees<Dim>::add_turning(const System<Dim>& system, int b, const std::vector<Vec<Dim>>& force,
                                   std::vector<MatrixEntry>& entries) const {
  const int first_site = system.topology.body_begin(b);
  const std::int32_t r = rigid_[first_site];
  if (r < 0 || first_[first_site] < 0) return;
  double value = 0;  // d2x/d(angle)2 = -arm
  if constexpr (Dim == 2)
    for (int i = first_site; i < system.topology.body_end(b); ++i)
      value += dot(force[i], system.state.position[i] - system.rigid.centre[r]);
  const std::int32_t angle = first_[first_site] + 2;
  entries.emplace_back(angle, angle, value * system.rigid.mass[r] / system.rigid.inertia[r]);
}

template <int Dim>
std::vector<double> BodyDegrees<Dim>::masses(const System<Dim>& system) const {
  std::vector<double> masses;
  masses.reserve(static_cast<std::size_t>(size_));
  for (const std::int32_t i : sites_) masses.insert(masses.end(), Dim, system.state.mass[i]);
  // Angle times radius of gyration has the mass of the body.
  for (const std::int32_t r : bodies_) masses.insert(masses.end(), 3, system.rigid.mass[r]);
  return masses;
}

template class BodyDegrees<2>;
template class BodyDegrees<3>;

}  // namespace supple
