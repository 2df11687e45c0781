/// Second-order minimisation: limited-memory BFGS preconditioned by a factorised Hessian; without memory it
/// is a regularised Newton method.
#pragma once
#include <memory>
#include <vector>

#include "supple/solve/descent.hpp"
#include "supple/solve/factorisation.hpp"

namespace supple {

/// Parameter of Newton.
struct NewtonSpec {
  int memory =
      12;  ///< steps whose change of gradient corrects the factorisation; 0: a factorisation every step
};

/// Steps along -B g, with the gradient g and B the inverse of H + shift I, corrected by the L-BFGS recursion
/// (Nocedal 1980) with the steps since the factorisation. The shift keeps H + shift I positive definite and
/// steps short; it falls with the gradient.
class Newton {
 public:
  explicit Newton(const NewtonSpec& spec = {}) : spec_(spec) {}

  /// Moves until descent.finished() or for `iterations` iterations. False if it cannot go on from where it
  /// is.
  bool run(Descent& descent, long iterations);

 private:
  struct Pair {
    std::vector<double> move, change;  ///< of x and of the gradient
    double inverse = 0;                ///< 1 / move.change
  };

  bool iterate(Descent& descent);
  /// Makes a new factorisation. False, without one, where second derivatives are not finite or it is time to
  /// stop.
  bool refresh(Descent& descent);
  void find_direction(std::span<const double> gradient);
  void remember(const std::vector<double>& before, double step, std::span<const double> gradient);
  bool is_stale(double residual);
  double shift_for(const Descent& descent) const;

  NewtonSpec spec_;
  std::unique_ptr<Factorisation> factorisation_;  ///< in blocks of block_size_, from the first run on
  int block_size_ = 0;
  SparseMatrix hessian_;
  std::vector<Pair> pairs_;  ///< the oldest first
  std::vector<double> direction_, before_, weight_;
  std::vector<double> history_;  ///< smallest residual after each iteration since the factorisation
  bool factorised_ = false;
  double damping_ = 0.1;     ///< the shift over (largest |component| of the gradient / largest move)
  double needed_shift_ = 0;  ///< shift that the last factorisation needed to be positive definite; 0: none
};

}  // namespace supple
