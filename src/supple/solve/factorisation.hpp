/// Sparse factorisation of a symmetric matrix plus a multiple of the identity.
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "supple/solve/sparse_matrix.hpp"

namespace supple {

/// H + shift I = L D L^T for a sparse symmetric H.
class Factorisation {
 public:
  virtual ~Factorisation() = default;
  /// Takes H (lower triangle) and analyses its pattern.
  virtual void set(const SparseMatrix& lower) = 0;
  /// Factorises H + shift I. True if it is positive definite. Rows of H may be empty when shift > 0.
  virtual bool factorise(double shift) = 0;
  /// After factorise() returned false: a curvature z.(H + shift I)z / z.z that is not positive. The least
  /// eigenvalue of H + shift I is at most as large.
  virtual double negative_curvature() = 0;
  /// Replaces b by (H + shift I)^-1 b.
  virtual void solve(std::span<double> b) = 0;

  virtual double largest_diagonal() const = 0;
  /// Numbers of multiplications in one factorisation and in one solve().
  virtual double factorise_work() const = 0;
  virtual double solve_work() const = 0;
};

/// A factorisation in blocks of so many rows (Objective::block_size): 2 or 3, input error otherwise.
std::unique_ptr<Factorisation> make_factorisation(int block_size);

}  // namespace supple
