/// The degrees of freedom of bodies, as one vector of lengths.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "supple/model/hessian.hpp"
#include "supple/model/system.hpp"
#include "supple/solve/sparse_matrix.hpp"

namespace supple {

/// The degrees of freedom of a system as a vector q [length]. First the coordinates of every free site
/// outside rigid bodies, in the order of sites; then, for every rigid body that is not held, the coordinates
/// of its centre and its angle (in 3D the three numbers of its rotation vector) times its radius of gyration.
/// Nothing else moves. Which sites and bodies these are is decided at construction. Where all sites are free
/// and none is rigid, q holds the positions. A rotation vector is a good coordinate up to a length of pi
/// (shorten_angles); its slope is T^T torque, T = dw/dq of core/rotation.hpp, which is the torque at angle 0.
template <int Dim>
class BodyDegrees {
 public:
  explicit BodyDegrees(const System<Dim>& system);

  int size() const { return size_; }
  /// Number of sites among q: their coordinates come first; `rigid_numbers` for each rigid body follow.
  int site_count() const { return static_cast<int>(sites_.size()); }
  /// These sites, in their order.
  const std::vector<std::int32_t>& sites() const { return sites_; }
  void read(const System<Dim>& system, std::span<double> q) const;
  /// Moves the system to q. Velocities stay as they are, except of sites of rigid bodies, which follow their
  /// body.
  void write(std::span<const double> q, System<Dim>& system) const;
  /// Fills g = dU/dq, minus the generalised forces, from the forces on the sites (Evaluation::force).
  void gradient(const System<Dim>& system, const std::vector<Vec<Dim>>& force, std::span<double> g) const;
  /// The lower triangle of d2U/dq2 = J^T H J + sum over sites of dU/dx d2x/dq2, with J = dx/dq, from the
  /// second derivatives H with respect to sites and the forces -dU/dx at the same positions.
  std::vector<MatrixEntry> hessian(const System<Dim>& system, const HessianBlocks<Dim>& blocks,
                                   const std::vector<Vec<Dim>>& force) const {
    std::vector<MatrixEntry> entries;
    hessian(system, blocks, force, entries);
    return entries;
  }
  /// The same, into a vector whose memory is used again.
  void hessian(const System<Dim>& system, const HessianBlocks<Dim>& blocks,
               const std::vector<Vec<Dim>>& force, std::vector<MatrixEntry>& entries) const;
  /// The parts of hessian(): J^T H J of `blocks`, added to `entries`,
  void add_blocks(const System<Dim>& system, const HessianBlocks<Dim>& blocks,
                  std::vector<MatrixEntry>& entries) const;
  /// and the sum of dU/dx d2x/dq2 over the sites of body b, which is nothing unless it is rigid and not held.
  void add_turning(const System<Dim>& system, int b, const std::vector<Vec<Dim>>& force,
                   std::vector<MatrixEntry>& entries) const;
  /// The first number of a free site, or of the rigid body that it belongs to; -1: it does not move.
  std::int32_t first_number(std::int32_t site) const { return first_[site]; }
  bool is_rigid(std::int32_t site) const { return rigid_[site] >= 0; }
  /// Mass of each number q_k: mass d2q_k/dt2 = -dU/dq_k. Of angles in 3D near angle 0, and as far as the
  /// moments of inertia of the body are alike.
  std::vector<double> masses(const System<Dim>& system) const;

 private:
  struct Column;
  struct Columns;
  Columns columns_of(const System<Dim>& system, std::int32_t site) const;

  bool plain_;
  int size_ = 0;
  std::vector<std::int32_t> sites_;   ///< free sites outside rigid bodies
  std::vector<std::int32_t> bodies_;  ///< rigid bodies that are not held, as indices of System::rigid
  std::vector<std::int32_t> first_;   ///< first number of each site, or of its rigid body; -1: none
  std::vector<std::int32_t> rigid_;   ///< rigid body of each site, or -1
};

}  // namespace supple
