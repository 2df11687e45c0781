/// The energy of bodies as a function of their degrees of freedom: what the minimisers work on.
#pragma once
#include "supple/force/force_field.hpp"
#include "supple/solve/degrees.hpp"
#include "supple/solve/minimise.hpp"

namespace supple {

/// When a packing counts as in equilibrium: the largest net force on a site, or on a rigid body along one of
/// its numbers (BodyDegrees), is below the largest of three: relative * (mean contact force); least [force],
/// for packings in which nothing touches; and the force that a change in the last digit of the positions
/// makes.
struct ForceTolerance {
  double relative = 1e-6, least = 1e-13;
};

/// The energy of a system under a force field as a function of its free sites and rigid bodies (BodyDegrees),
/// in a cell that stays as it is. Evaluating it moves the system. In 3D, making it gives rigid bodies the
/// shortest of their rotation vectors.
template <int Dim>
class BodyObjective final : public Objective {
 public:
  BodyObjective(System<Dim>& system, ForceField<Dim>& field, const ForceTolerance& tolerance);

  /// The numbers of the present state.
  std::vector<double> coordinates() const;

  int size() const override { return degrees_.size(); }
  int block_size() const override { return Dim; }
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
  /// Largest net force on a site, or on a rigid body along one of its numbers [force].
  double residual(std::span<const double> x, std::span<const double> slope) override;
  const BodyDegrees<Dim>& degrees() const { return degrees_; }
  /// The last evaluation; with energies, if it was by evaluate().
  const Evaluation<Dim>& evaluation() const { return out_; }
  double tolerance() const override { return tolerance_now_; }
  double largest_move() const override { return largest_move_; }

 private:
  void evaluate(std::span<const double> x, std::span<double> slope, Detail detail);
  void assemble(std::span<const double> x, HessianKind kind, SparseMatrix& lower);
  void refresh_tolerance(std::span<const double> x);

  System<Dim>& system_;
  ForceField<Dim>& field_;
  BodyDegrees<Dim> degrees_;
  ForceTolerance tolerance_;
  Evaluation<Dim> out_;
  HessianBlocks<Dim> blocks_;  ///< this and `entries_` are kept for their memory
  std::vector<MatrixEntry> entries_;
  double largest_move_, tolerance_now_;
  double stiffness_;  ///< of the stiffest vertex, roughly [energy/length^2]
  int until_refresh_ = 0;
};

/// Largest net force, given the forces on all sites: on a free site, or on a rigid body along one of its
/// numbers.
template <int Dim>
double largest_net_force(const System<Dim>& system, const std::vector<Vec<Dim>>& force);

/// Mean magnitude of the forces of contacts [force]; 0 where nothing touches.
template <int Dim>
double mean_contact_force(const System<Dim>& system, BodyContacts<Dim>& contacts);

}  // namespace supple
