#include "supple/solve/factorisation.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

#include "supple/solve/sums.hpp"

namespace supple {

using Matrix = Eigen::SparseMatrix<double>;
using Permutation = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>;

struct Factorisation::Solver {
  Eigen::SimplicialLDLT<Matrix, Eigen::Upper, Eigen::NaturalOrdering<int>> ldlt;
  Permutation order;
  Matrix upper;  ///< in the order of elimination
  Eigen::VectorXd work, pivot;

  void find_order(const Eigen::Map<const Matrix>& lower) {
    Permutation inverse;
    Eigen::AMDOrdering<int>()(lower.selfadjointView<Eigen::Lower>(), inverse);
    order = inverse.inverse();
  }
};

Factorisation::Factorisation() : solver_(std::make_unique<Solver>()) {}
Factorisation::~Factorisation() = default;

void Factorisation::set(const SparseMatrix& matrix) {
  const Eigen::Map<const Matrix> lower(matrix.size, matrix.size,
                                       static_cast<Eigen::Index>(matrix.value.size()), matrix.begin.data(),
                                       matrix.row.data(), matrix.value.data());
  Solver& s = *solver_;
  // An order made for other contacts stays good for a while, and costs as much as a factorisation to make.
  if (s.order.size() != lower.rows() || factorise_work_ > 1.3 * work_when_ordered_) {
    s.find_order(lower);
    work_when_ordered_ = 0;
  }
  s.upper.resize(lower.rows(), lower.cols());
  s.upper.selfadjointView<Eigen::Upper>() = lower.selfadjointView<Eigen::Lower>().twistedBy(s.order);
  s.ldlt.analyzePattern(s.upper);
  largest_diagonal_ = 0;
  for (Eigen::Index i = 0; i < s.upper.rows(); ++i)
    largest_diagonal_ = std::max(largest_diagonal_, std::abs(s.upper.coeff(i, i)));
}

void Factorisation::count_work() {
  const auto& factor = solver_->ldlt.matrixL().nestedExpression();
  factorise_work_ = solve_work_ = 0;
  for (Eigen::Index j = 0; j < factor.cols(); ++j) {
    const double below = factor.outerIndexPtr()[j + 1] - factor.outerIndexPtr()[j];
    factorise_work_ += below * below;
    solve_work_ += 2 * below;
  }
  if (work_when_ordered_ == 0) work_when_ordered_ = factorise_work_;
}

bool Factorisation::factorise(double shift) {
  Solver& s = *solver_;
  s.ldlt.setShift(shift);
  s.ldlt.factorize(s.upper);
  count_work();
  if (s.ldlt.info() != Eigen::Success) return false;
  s.pivot = s.ldlt.vectorD();  // a copy: Eigen gives it by value
  for (Eigen::Index i = 0; i < s.pivot.size(); ++i)
    if (!(s.pivot[i] > 0)) return false;
  return true;
}

double Factorisation::negative_curvature() {
  Solver& s = *solver_;
  if (s.ldlt.info() != Eigen::Success) return 0;  // a pivot was exactly zero
  const Eigen::Index least =
      std::min_element(s.pivot.data(), s.pivot.data() + s.pivot.size()) - s.pivot.data();
  s.work.setZero(s.upper.rows());
  s.work[least] = 1;
  s.ldlt.matrixU().solveInPlace(s.work);  // z with L^T z = e, so that z.Az = D
  const std::span<const double> z(s.work.data(), static_cast<std::size_t>(s.work.size()));
  return s.pivot[least] / dot(z, z);
}

void Factorisation::solve(std::span<double> b) {
  Solver& s = *solver_;
  Eigen::Map<Eigen::VectorXd> vector(b.data(), static_cast<Eigen::Index>(b.size()));
  s.work = s.order * vector;
  s.ldlt.matrixL().solveInPlace(s.work);
  s.work.array() /= s.pivot.array();
  s.ldlt.matrixU().solveInPlace(s.work);
  vector = s.order.transpose() * s.work;
}

}  // namespace supple
