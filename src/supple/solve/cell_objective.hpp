/// Bodies in a cell that may change itself: what the minimisers work on at constant pressure.
#pragma once
#include "supple/solve/body_objective.hpp"

namespace supple {

/// What of the cell may change: its size, at a fixed ratio of its lengths, and its shear strain.
struct CellFreedom {
  bool size = true, shear = false;
};

/// The enthalpy H = U + P (A - A0) - tau A0 gamma of a periodic cell of area (3D: volume) A, A0 at
/// construction, under an outer pressure P and shear stress tau; gamma is the shear strain since
/// construction. (P A itself can be 1e8 times U, and minimisers could not see U change.) The numbers that it
/// is a function of: those of BodyDegrees in the cell as it was at construction, where the strain of the cell
/// moves bodies with their centres and does not deform them; then ln(size) and gamma, each times the first
/// length of the cell at construction, so that they are lengths too. At a minimum the net forces vanish, the
/// virial pressure is P, and the shear stress -Sigma_xy is tau A0/A.
template <int Dim>
class CellObjective final : public Objective {
 public:
  CellObjective(System<Dim>& system, ForceField<Dim>& field, const ForceTolerance& tolerance,
                CellFreedom freedom, double pressure, double shear_stress = 0);

  std::vector<double> coordinates() const;
  int size() const override { return bodies_.size() + extra(); }
  int block_size() const override { return Dim; }
  double evaluate(std::span<const double> x, std::span<double> slope) override;
  /// For the bodies their own second derivatives, as if the cell were that of construction; for the cell
  /// central differences of the slope.
  void hessian(std::span<const double> x, SparseMatrix& lower) override {
    assemble(x, HessianKind::exact, lower);
  }
  void preconditioner(std::span<const double> x, SparseMatrix& lower) override {
    assemble(x, HessianKind::sparse, lower);
  }
  double residual(std::span<const double> x, std::span<const double> slope) override;
  double tolerance() const override { return bodies_.tolerance(); }
  double largest_move() const override { return bodies_.largest_move(); }

 private:
  /// Positions that move together when the cell is strained: `count` vectors from number `first` on.
  struct Group {
    std::size_t first;
    int count;
  };

  void assemble(std::span<const double> x, HessianKind kind, SparseMatrix& lower);
  int extra() const { return freedom_.size + freedom_.shear; }
  void strain_cell(std::span<const double> x);

  System<Dim>& system_;
  ForceField<Dim>& field_;
  BodyObjective<Dim> bodies_;
  CellFreedom freedom_;
  double pressure_, shear_stress_;
  Box<Dim> start_;
  double growth_ = 1, shear_ = 0;  ///< of the cell, relative to `start_`
  std::vector<double> at_;         ///< numbers of the bodies where the cell is now
  std::vector<Group> groups_;
};

}  // namespace supple
