#include "supple/solve/degrees.hpp"

#include <algorithm>
#include <cstring>

#include "supple/model/rigid.hpp"

namespace supple {

static_assert(sizeof(Vec2) == 2 * sizeof(double), "positions are copied as numbers");

/// The index of a number, and dx/dq of a site for it.
struct BodyDegrees::Column {
  std::int32_t index;
  Vec2 slope;
};
struct BodyDegrees::Columns {
  int count = 0;
  Column column[3];
  const Column* begin() const { return column; }
  const Column* end() const { return column + count; }
};

BodyDegrees::BodyDegrees(const System<2>& system) {
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
      size_ += 2;
      sites_.push_back(i);
    }
  plain_ = sites_.size() == n;
  for (int r = 0; r < system.rigid.size(); ++r) {
    if (held(system, r)) continue;
    const int b = system.rigid.body[r];
    for (int i = system.topology.body_begin(b); i < system.topology.body_end(b); ++i) first_[i] = size_;
    size_ += 3;
    bodies_.push_back(r);
  }
}

void BodyDegrees::read(const System<2>& system, std::span<double> q) const {
  if (plain_) {
    if (size_ > 0)
      std::memcpy(q.data(), system.state.position.data(), static_cast<std::size_t>(size_) * sizeof(double));
    return;
  }
  double* at = q.data();
  for (const std::int32_t i : sites_)
    for (int d = 0; d < 2; ++d) *at++ = system.state.position[i][d];
  for (const std::int32_t r : bodies_) {
    for (int d = 0; d < 2; ++d) *at++ = system.rigid.centre[r][d];
    *at++ = system.rigid.angle[r] * gyration_radius(system.rigid, r);
  }
}

void BodyDegrees::write(std::span<const double> q, System<2>& system) const {
  if (plain_) {
    if (size_ > 0)
      std::memcpy(static_cast<void*>(system.state.position.data()), q.data(),
                  static_cast<std::size_t>(size_) * sizeof(double));
    return;
  }
  const double* at = q.data();
  for (const std::int32_t i : sites_)
    for (int d = 0; d < 2; ++d) system.state.position[i][d] = *at++;
  for (const std::int32_t r : bodies_) {
    for (int d = 0; d < 2; ++d) system.rigid.centre[r][d] = *at++;
    system.rigid.angle[r] = *at++ / gyration_radius(system.rigid, r);
  }
  place_sites(system);
}

void BodyDegrees::gradient(const System<2>& system, const std::vector<Vec2>& force,
                           std::span<double> g) const {
  double* at = g.data();
  for (const std::int32_t i : sites_)
    for (int d = 0; d < 2; ++d) *at++ = -force[i][d];
  for (const std::int32_t r : bodies_) {
    const RigidForce on_body = force_on_rigid(system, force, r);
    for (int d = 0; d < 2; ++d) *at++ = -on_body.force[d];
    *at++ = -on_body.torque / gyration_radius(system.rigid, r);
  }
}

BodyDegrees::Columns BodyDegrees::columns_of(const System<2>& system, std::int32_t site) const {
  const std::int32_t first = first_[site], r = rigid_[site];
  if (first < 0) return {};
  Columns columns{2, {{first, {1, 0}}, {first + 1, {0, 1}}, {}}};
  if (r < 0) return columns;
  const Vec2 arm = system.state.position[site] - system.rigid.centre[r];
  columns.column[columns.count++] = {first + 2, (1 / gyration_radius(system.rigid, r)) * turned_left(arm)};
  return columns;
}

namespace {

/// The Hessian where every number is a coordinate of a site, so that nothing must be looked up.
void copy_blocks(const HessianBlocks<2>& blocks, std::vector<MatrixEntry>& entries) {
  for (const HessianBlock<2>& block : blocks)
    for (int c = 0; c < 2; ++c)
      for (int d = 0; d < 2; ++d) {
        const std::int32_t row = 2 * block.a + c, column = 2 * block.b + d;
        if (block.a == block.b && row < column) continue;
        entries.emplace_back(std::max(row, column), std::min(row, column), block.h[c][d]);
      }
}

}  // namespace

void BodyDegrees::hessian(const System<2>& system, const HessianBlocks<2>& blocks,
                          const std::vector<Vec2>& force, std::vector<MatrixEntry>& entries) const {
  entries.clear();
  entries.reserve(4 * blocks.size());
  add_blocks(system, blocks, entries);
  for (const std::int32_t r : bodies_) add_turning(system, system.rigid.body[r], force, entries);
}

void BodyDegrees::add_blocks(const System<2>& system, const HessianBlocks<2>& blocks,
                             std::vector<MatrixEntry>& entries) const {
  if (plain_) return copy_blocks(blocks, entries);
  for (const HessianBlock<2>& block : blocks) {
    const Columns rows = columns_of(system, block.a), columns = columns_of(system, block.b);
    for (const Column& p : rows)
      for (const Column& q : columns) {
        if (block.a == block.b && p.index < q.index) continue;
        double value = 0;
        for (int c = 0; c < 2; ++c)
          for (int d = 0; d < 2; ++d) value += p.slope[c] * block.h[c][d] * q.slope[d];
        // For two sites of one rigid body the transposed block has the same numbers.
        if (block.a != block.b && p.index == q.index) value *= 2;
        entries.emplace_back(std::max(p.index, q.index), std::min(p.index, q.index), value);
      }
  }
}

void BodyDegrees::add_turning(const System<2>& system, int b, const std::vector<Vec2>& force,
                              std::vector<MatrixEntry>& entries) const {
  const int first_site = system.topology.body_begin(b);
  const std::int32_t r = rigid_[first_site];
  if (r < 0 || first_[first_site] < 0) return;
  double value = 0;  // d2x/d(angle)2 = -arm
  for (int i = first_site; i < system.topology.body_end(b); ++i)
    value += dot(force[i], system.state.position[i] - system.rigid.centre[r]);
  const std::int32_t angle = first_[first_site] + 2;
  entries.emplace_back(angle, angle, value * system.rigid.mass[r] / system.rigid.inertia[r]);
}

std::vector<double> BodyDegrees::masses(const System<2>& system) const {
  std::vector<double> masses;
  masses.reserve(static_cast<std::size_t>(size_));
  for (const std::int32_t i : sites_) masses.insert(masses.end(), 2, system.state.mass[i]);
  // Angle times radius of gyration has the mass of the body.
  for (const std::int32_t r : bodies_) masses.insert(masses.end(), 3, system.rigid.mass[r]);
  return masses;
}

}  // namespace supple
