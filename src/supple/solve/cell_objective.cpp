#include "supple/solve/cell_objective.hpp"

#include <algorithm>
#include <cmath>

namespace supple {

CellObjective::CellObjective(System<2>& system, ForceField& field, const ForceTolerance& tolerance, CellFreedom freedom, double pressure,
                             double shear_stress)
    : system_(system), field_(field), bodies_(system, field, tolerance), freedom_(freedom), pressure_(pressure),
      shear_stress_(shear_stress), start_(system.box), at_(static_cast<std::size_t>(bodies_.size())) {}

std::vector<double> CellObjective::coordinates() const {
  std::vector<double> x = bodies_.coordinates();
  x.resize(static_cast<std::size_t>(size()), 0.0);
  return x;
}

/// The cell of these numbers, and the bodies' numbers in it: x -> growth (x + shear y e_x).
void CellObjective::strain_cell(std::span<const double> x) {
  std::size_t next = static_cast<std::size_t>(bodies_.size());
  growth_ = freedom_.size ? std::exp(x[next++] / start_.length[0]) : 1;
  shear_ = freedom_.shear ? x[next] / start_.length[0] : 0;
  system_.box.length = growth_ * start_.length;
  system_.box.strain = start_.strain + shear_;
  std::copy(x.begin(), x.begin() + bodies_.size(), at_.begin());
  bodies_.for_positions([&](std::size_t k) {
    at_[k] = growth_ * (x[k] + shear_ * x[k + 1]);
    at_[k + 1] = growth_ * x[k + 1];
  });
}

double CellObjective::evaluate(std::span<const double> x, std::span<double> slope) {
  strain_cell(x);
  const double energy = bodies_.evaluate(at_, slope.first(at_.size()));
  bodies_.for_positions([&](std::size_t k) {
    slope[k + 1] = growth_ * (slope[k + 1] + shear_ * slope[k]);
    slope[k] *= growth_;
  });
  const Mat2& virial = bodies_.evaluation().virial;
  const double area = system_.box.volume(), start = start_.volume();
  std::size_t next = at_.size();
  if (freedom_.size) slope[next++] = (2 * pressure_ * area - virial[0][0] - virial[1][1]) / start_.length[0];
  if (freedom_.shear) slope[next] = (-virial[flow][gradient] - shear_stress_ * start) / start_.length[0];
  return energy + pressure_ * area - shear_stress_ * start * shear_;
}

double CellObjective::residual(std::span<const double> x, std::span<const double> slope) {
  double most = bodies_.residual(at_, slope.first(at_.size()));
  // Per vertex on the rim of the cell, or the whole cell would have to balance as well as one vertex.
  const double share = 1 / std::sqrt(static_cast<double>(std::max(1, system_.state.size())));
  for (std::size_t k = at_.size(); k < slope.size(); ++k) most = std::max(most, share * std::abs(slope[k]));
  return most;
}

void CellObjective::hessian(std::span<const double> x, SparseMatrix& lower) {
  strain_cell(x);
  SparseMatrix inner;
  bodies_.hessian(at_, inner);
  std::vector<Eigen::Triplet<double>> entries;
  const double square = growth_ * growth_;  // the shear of the coordinates since the start is small, and left out
  for (int c = 0; c < inner.outerSize(); ++c)
    for (SparseMatrix::InnerIterator it(inner, c); it; ++it)
      entries.emplace_back(static_cast<int>(it.row()), static_cast<int>(it.col()), square * it.value());
  std::vector<double> moved(x.begin(), x.end()), above(x.size()), below(x.size());
  const double step = 1e-6 * start_.length[0];
  for (int row = bodies_.size(); row < size(); ++row) {
    const auto k = static_cast<std::size_t>(row);
    moved[k] = x[k] + step;
    evaluate(moved, above);
    moved[k] = x[k] - step;
    evaluate(moved, below);
    moved[k] = x[k];
    for (int column = 0; column <= row; ++column)
      entries.emplace_back(row, column, (above[static_cast<std::size_t>(column)] - below[static_cast<std::size_t>(column)]) / (2 * step));
  }
  lower.resize(size(), size());
  lower.setFromTriplets(entries.begin(), entries.end());
  strain_cell(x);
}

}  // namespace supple
