#include "supple/solve/factorisation.hpp"

#include <Eigen/OrderingMethods>
#include <algorithm>

namespace supple {

void Factorisation::set(const SparseMatrix& lower) {
  // An order made for other contacts stays good for a while, and costs as much as a factorisation to make.
  if (order_.size() != lower.rows() || factorise_work_ > 1.3 * work_when_ordered_) {
    order(lower);
    work_when_ordered_ = 0;
  }
  upper_.resize(lower.rows(), lower.cols());
  upper_.selfadjointView<Eigen::Upper>() = lower.selfadjointView<Eigen::Lower>().twistedBy(order_);
  solver_.analyzePattern(upper_);
  largest_diagonal_ = 0;
  for (Eigen::Index i = 0; i < upper_.rows(); ++i)
    largest_diagonal_ = std::max(largest_diagonal_, std::abs(upper_.coeff(i, i)));
}

void Factorisation::order(const SparseMatrix& lower) {
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> inverse;
  Eigen::AMDOrdering<int>()(lower.selfadjointView<Eigen::Lower>(), inverse);
  order_ = inverse.inverse();
}

void Factorisation::count_work() {
  const auto& factor = solver_.matrixL().nestedExpression();
  factorise_work_ = solve_work_ = 0;
  for (Eigen::Index j = 0; j < factor.cols(); ++j) {
    const double below = factor.outerIndexPtr()[j + 1] - factor.outerIndexPtr()[j];
    factorise_work_ += below * below;
    solve_work_ += 2 * below;
  }
  if (work_when_ordered_ == 0) work_when_ordered_ = factorise_work_;
}

bool Factorisation::factorise(double shift) {
  solver_.setShift(shift);
  solver_.factorize(upper_);
  count_work();
  if (solver_.info() != Eigen::Success) return false;
  pivot_ = solver_.vectorD();  // a copy: Eigen gives it by value
  for (Eigen::Index i = 0; i < pivot_.size(); ++i)
    if (!(pivot_[i] > 0)) return false;
  return true;
}

double Factorisation::negative_curvature() {
  if (solver_.info() != Eigen::Success) return 0;  // a pivot was exactly zero
  const Eigen::Index least = std::min_element(pivot_.data(), pivot_.data() + pivot_.size()) - pivot_.data();
  work_.setZero(upper_.rows());
  work_[least] = 1;
  solver_.matrixU().solveInPlace(work_);  // z with L^T z = e, so that z.Az = D
  const std::span<const double> z(work_.data(), static_cast<std::size_t>(work_.size()));
  return pivot_[least] / dot(z, z);
}

void Factorisation::solve(std::span<double> b) {
  Eigen::Map<Eigen::VectorXd> vector(b.data(), static_cast<Eigen::Index>(b.size()));
  work_ = order_ * vector;
  solver_.matrixL().solveInPlace(work_);
  work_.array() /= pivot_.array();
  solver_.matrixU().solveInPlace(work_);
  vector = order_.transpose() * work_;
}

}  // namespace supple
