#include "supple/solve/newton.hpp"

#include <algorithm>
#include <cmath>

#include "supple/solve/line_search.hpp"

namespace supple {
namespace {

constexpr double least_shift =
    1e-11;  // of the largest diagonal element: above the rounding of the factorisation
constexpr double smallest_shift = 1e-290;  // or doubling would stay at 0
constexpr int window = 15;  // iterations over which the present rate of convergence is measured

bool is_finite(const SparseMatrix& lower) {
  return std::all_of(lower.value.begin(), lower.value.end(),
                     [](double value) { return std::isfinite(value); });
}

}  // namespace

bool Newton::run(Descent& descent, long iterations) {
  factorised_ = false;
  if (const int size = descent.objective.block_size(); size != block_size_) {
    factorisation_ = make_factorisation(size);
    block_size_ = size;
  }
  for (long i = 0; i < iterations && !descent.finished(); ++i)
    if (!iterate(descent)) return false;
  return true;
}

bool Newton::iterate(Descent& descent) {
  for (int attempt = 0; attempt < 6; ++attempt) {
    if ((!factorised_ || is_stale(descent.report.residual)) && !refresh(descent)) return descent.finished();
    find_direction(descent.gradient);
    double slope = dot(direction_, descent.gradient);
    if (!(slope < 0) && !pairs_.empty()) {
      pairs_.clear();
      find_direction(descent.gradient);
      slope = dot(direction_, descent.gradient);
    }
    before_ = descent.gradient;
    const double longest = largest(direction_), most = descent.objective.largest_move() / longest;
    const double step = slope < 0 ? line_search(descent, direction_, 1.0, most) : 0.0;
    if (step > 0) {
      remember(before_, step, descent.gradient);
      if (step < 0.1) damping_ = std::min(1e6, 3 * damping_);
      else if (step >= 0.9) damping_ = std::max(1e-6, damping_ / 2);
      history_.push_back(std::min(history_.back(), descent.report.residual));
      descent.count_iteration();
      return true;
    }
    if (descent.finished()) return true;
    if (history_.size() == 1) damping_ *= 10;
    factorised_ = false;
  }
  return false;
}

double Newton::shift_for(const Descent& descent) const {
  const double move = descent.objective.largest_move();
  const double scale = std::isfinite(move) ? move : 0.1 * std::max(1.0, largest(descent.x));
  return std::max({least_shift * factorisation_->largest_diagonal(),
                   damping_ * largest(descent.gradient) / scale, 0.5 * needed_shift_});
}

bool Newton::refresh(Descent& descent) {
  // Without memory the exact Hessian is needed; memory makes up for what a cheaper matrix leaves out.
  if (spec_.memory == 0) descent.objective.hessian(descent.x, hessian_);
  else descent.objective.preconditioner(descent.x, hessian_);
  factorised_ = false;
  if (!is_finite(hessian_)) return false;  // such as of two discs at one point
  factorisation_->set(hessian_);
  double shift = shift_for(descent);
  needed_shift_ = 0;
  while (++descent.report.factorisations, !factorisation_->factorise(shift)) {
    if (descent.finished()) return false;
    shift = std::max({2 * shift, shift - 2 * factorisation_->negative_curvature(), smallest_shift});
    if (!std::isfinite(shift)) return false;
    needed_shift_ = shift;
  }
  pairs_.clear();
  history_.assign(1, descent.report.residual);
  factorised_ = true;
  return true;
}

/// Whether a new factorisation now would have reduced the residual faster, per unit of work, than this one
/// still does: the present rate has fallen below the mean one, the cost of the factorisation included.
bool Newton::is_stale(double residual) {
  const int done = static_cast<int>(history_.size()) - 1;
  if (done == 0) return false;
  if (spec_.memory == 0) return true;
  const double n = static_cast<double>(direction_.size());
  const double iteration = factorisation_->solve_work() + 4 * n * spec_.memory + 20 * n;
  // A new matrix must also be assembled, ordered and analysed, and the memory of steps is lost with the old
  // one. The factors are measured.
  const double price = (4 * factorisation_->factorise_work() + 3000 * n) / iteration;  // in iterations
  if (done < window) return false;
  const double gain = std::log(history_.front() / history_.back());
  const double recent = std::log(history_[done - window] / history_.back());
  return recent / window <= gain / (price + done);
}

/// The two loops of L-BFGS round a solution with the factorisation.
void Newton::find_direction(std::span<const double> gradient) {
  direction_.assign(gradient.begin(), gradient.end());
  weight_.resize(pairs_.size());
  for (std::size_t k = pairs_.size(); k-- > 0;) {
    weight_[k] = pairs_[k].inverse * dot(pairs_[k].move, direction_);
    add_scaled(-weight_[k], pairs_[k].change, direction_);
  }
  factorisation_->solve(direction_);
  for (std::size_t k = 0; k < pairs_.size(); ++k)
    add_scaled(weight_[k] - pairs_[k].inverse * dot(pairs_[k].change, direction_), pairs_[k].move,
               direction_);
  for (double& d : direction_) d = -d;
}

void Newton::remember(const std::vector<double>& before, double step, std::span<const double> gradient) {
  if (spec_.memory == 0) return;
  Pair pair;
  if (static_cast<int>(pairs_.size()) == spec_.memory) {
    pair = std::move(pairs_.front());
    pairs_.erase(pairs_.begin());
  }
  pair.move.resize(before.size());
  pair.change.resize(before.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    pair.move[i] = step * direction_[i];
    pair.change[i] = gradient[i] - before[i];
  }
  const double product = dot(pair.move, pair.change);
  if (!(product > 1e-10 * std::sqrt(dot(pair.move, pair.move) * dot(pair.change, pair.change)))) return;
  pair.inverse = 1 / product;
  pairs_.push_back(std::move(pair));
}

}  // namespace supple
