/// Bodies in a cell that is free itself: what the minimisers work on at constant pressure.
#pragma once
#include "supple/solve/body_objective.hpp"

namespace supple {

/// What of the cell moves: its size, keeping the ratio of its lengths, and its shear strain.
struct CellFreedom {
  bool size = true, shear = false;
};

/// The enthalpy H = U + P A + (shear stress) A0 (strain) of a periodic cell of area A under a wanted pressure
/// P and shear stress -Sigma_xy, both outside. Numbers: those of BodyDegrees in the cell as it was at
/// construction, whose bodies move with the strain of the cell by their centres, without deforming; then
/// ln(size) and shear strain, each times the first length of the cell, so that they are lengths too. At a
/// minimum the net forces vanish, P is the virial pressure, and so is the shear stress.
class CellObjective final : public Objective {
 public:
  CellObjective(System<2>& system, ForceField& field, const ForceTolerance& tolerance, CellFreedom freedom,
                double pressure, double shear_stress = 0);

  std::vector<double> coordinates() const;
  int size() const override { return bodies_.size() + extra(); }
  double evaluate(std::span<const double> x, std::span<double> slope) override;
  /// Of the bodies by their own second derivatives, as in the cell at construction; of the cell by central
  /// differences of the slope.
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
  /// Numbers that move together: `count` positions from number `first` on.
  struct Group {
    std::size_t first;
    int count;
  };

  void assemble(std::span<const double> x, HessianKind kind, SparseMatrix& lower);
  int extra() const { return freedom_.size + freedom_.shear; }
  void strain_cell(std::span<const double> x);

  System<2>& system_;
  ForceField& field_;
  BodyObjective bodies_;
  CellFreedom freedom_;
  double pressure_, shear_stress_;
  Box<2> start_;
  double growth_ = 1, shear_ = 0;  ///< of the cell, relative to `start_`
  std::vector<double> at_;         ///< numbers of the bodies where the cell is now
  std::vector<Group> groups_;
};

}  // namespace supple
