/// The degrees of freedom of bodies, as one vector of lengths.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "supple/model/hessian.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// One entry of a symmetric matrix, row >= column. Entries of the same place add up. Fits Eigen's
/// setFromTriplets.
class MatrixEntry {
 public:
  MatrixEntry(std::int32_t row, std::int32_t column, double value)
      : row_(row), column_(column), value_(value) {}
  std::int32_t row() const { return row_; }
  std::int32_t col() const { return column_; }
  double value() const { return value_; }

 private:
  std::int32_t row_, column_;
  double value_;
};

/// Numbers q [length] <-> system. First x, y of every free site that is in no rigid body, in the order of
/// sites; then x, y of the centre and angle times radius of gyration of every rigid body that is not held.
/// Nothing else moves. Which sites these are is taken from the system given at construction. Where all sites
/// are free and none is rigid, q are the positions, copied.
class BodyDegrees {
 public:
  explicit BodyDegrees(const System<2>& system);

  int size() const { return size_; }
  /// The first so many pairs of numbers are x, y of a site; three for each rigid body follow.
  int site_count() const { return static_cast<int>(sites_.size()); }
  /// The sites of these pairs, in their order.
  const std::vector<std::int32_t>& sites() const { return sites_; }
  void read(const System<2>& system, std::span<double> q) const;
  /// Velocities stay as they are, but for the sites of rigid bodies, which follow their body.
  void write(std::span<const double> q, System<2>& system) const;
  /// g = dU/dq = -generalised force, of forces on the sites (Evaluation::force).
  void gradient(const System<2>& system, const std::vector<Vec2>& force, std::span<double> g) const;
  /// d2U/dq2 = J^T H J + sum over sites of dU/dx d2x/dq2, J = dx/dq: lower triangle, of second derivatives by
  /// the sites and of the forces at the same positions.
  std::vector<MatrixEntry> hessian(const System<2>& system, const HessianBlocks<2>& blocks,
                                   const std::vector<Vec2>& force) const {
    std::vector<MatrixEntry> entries;
    hessian(system, blocks, force, entries);
    return entries;
  }
  /// The same into a vector that keeps its memory.
  void hessian(const System<2>& system, const HessianBlocks<2>& blocks, const std::vector<Vec2>& force,
               std::vector<MatrixEntry>& entries) const;
  /// Mass of each number: q moves by mass d2q/dt2 = -dU/dq.
  std::vector<double> masses(const System<2>& system) const;

 private:
  struct Column;
  struct Columns;
  Columns columns_of(const System<2>& system, std::int32_t site) const;

  bool plain_;
  int size_ = 0;
  std::vector<std::int32_t> sites_;   ///< that have degrees of their own
  std::vector<std::int32_t> bodies_;  ///< indices of System::rigid
  std::vector<std::int32_t> first_;   ///< first number of each site, or of its rigid body; -1: none
  std::vector<std::int32_t> rigid_;   ///< rigid body of each site, or -1
};

}  // namespace supple
