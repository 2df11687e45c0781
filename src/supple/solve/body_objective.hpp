/// The energy of bodies as a function of their degrees of freedom: what the minimisers work on.
#pragma once
#include "supple/force/force_field.hpp"
#include "supple/solve/degrees.hpp"
#include "supple/solve/minimise.hpp"

namespace supple {

/// When a packing is in equilibrium: the largest net force on a degree of freedom is below relative * (mean
/// contact force), or below least [force], which serves where nothing touches; never less than what the last
/// digits of the positions make.
struct ForceTolerance {
  double relative = 1e-6, least = 1e-13;
};

/// U of (System, ForceField) over the free sites and rigid bodies of the system, in a cell that stays as it
/// is.
class BodyObjective final : public Objective {
 public:
  BodyObjective(System<2>& system, ForceField& field, const ForceTolerance& tolerance);

  /// The present state as numbers.
  std::vector<double> coordinates() const;

  int size() const override { return degrees_.size(); }
  double evaluate(std::span<const double> x, std::span<double> gradient) override;
  void evaluate_slope(std::span<const double> x, std::span<double> slope) override {
    evaluate(x, slope, Detail::forces);
  }
  void hessian(std::span<const double> x, SparseMatrix& lower) override {
    assemble(x, HessianKind::exact, lower);
  }
  void preconditioner(std::span<const double> x, SparseMatrix& lower) override {
    assemble(x, HessianKind::sparse, lower);
  }
  /// Largest net force on a site, or on a rigid body along one of its numbers.
  double residual(std::span<const double> x, std::span<const double> slope) override;
  const BodyDegrees& degrees() const { return degrees_; }
  /// The last one, with energies.
  const Evaluation<2>& evaluation() const { return out_; }
  double tolerance() const override { return tolerance_now_; }
  double largest_move() const override { return largest_move_; }

 private:
  void evaluate(std::span<const double> x, std::span<double> slope, Detail detail);
  void assemble(std::span<const double> x, HessianKind kind, SparseMatrix& lower);
  void refresh_tolerance(std::span<const double> x);

  System<2>& system_;
  ForceField& field_;
  BodyDegrees degrees_;
  ForceTolerance tolerance_;
  Evaluation<2> out_;
  HessianBlocks<2> blocks_;  ///< these two kept for their memory
  std::vector<MatrixEntry> entries_;
  double largest_move_, tolerance_now_;
  double stiffness_;  ///< of the stiffest vertex, roughly
  int until_refresh_ = 0;
};

/// Largest net force of these forces on the sites: on a free site, or on a rigid body along one of its
/// numbers.
double largest_net_force(const System<2>& system, const std::vector<Vec2>& force);

/// Mean magnitude of the forces of the contacts, 0 where nothing touches.
double mean_contact_force(const System<2>& system, BodyContacts& contacts);

}  // namespace supple
