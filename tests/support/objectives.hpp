/// Objectives that are simple enough to be read, for the tests of the minimisers.
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "supple/core/random.hpp"
#include "supple/solve/objective.hpp"

namespace supple::testing {

using Triplets = std::vector<MatrixEntry>;

inline void add_entry(Triplets& list, int i, int j, double value) {
  list.emplace_back(std::max(i, j), std::min(i, j), value);
}

/// Adds the second derivatives of an energy e(|d|) of two points a and b of the plane, d = x_b - x_a, whose
/// coordinates start at x[2a] and x[2b]; e1 and e2 are the first and second derivative of e.
inline void add_pair_block(Triplets& list, int a, int b, const double (&d)[2], double e1, double e2) {
  const double r = std::hypot(d[0], d[1]);
  for (int p = 0; p < 2; ++p)
    for (int q = 0; q < 2; ++q) {
      const double nn = d[p] * d[q] / (r * r), k = e2 * nn + e1 / r * ((p == q) - nn);
      if (p >= q) {
        add_entry(list, 2 * a + p, 2 * a + q, k);
        add_entry(list, 2 * b + p, 2 * b + q, k);
      }
      add_entry(list, 2 * b + p, 2 * a + q, -k);
    }
}

inline void build(const Triplets& list, int n, SparseMatrix& lower) { sum_entries(n, list, lower); }

/// sum k_i (x_i - i)^2 / 2 + coupling sum (x_i - x_{i+1} + 1)^2 / 2: the minimum 0 is at x_i = i.
class StiffChain : public Objective {
 public:
  StiffChain(int n, double condition, double coupling) : coupling_(coupling), k_(n) {
    for (int i = 0; i < n; ++i) k_[i] = std::pow(condition, -static_cast<double>(i * 37 % n) / (n - 1));
  }
  int size() const override { return static_cast<int>(k_.size()); }
  double evaluate(std::span<const double> x, std::span<double> g) override {
    double energy = 0;
    const int n = size();
    for (int i = 0; i < n; ++i) {
      g[i] = k_[i] * (x[i] - i);
      energy += 0.5 * k_[i] * (x[i] - i) * (x[i] - i);
    }
    for (int i = 0; i + 1 < n; ++i) {
      const double d = x[i] - x[i + 1] + 1;
      g[i] += coupling_ * d;
      g[i + 1] -= coupling_ * d;
      energy += 0.5 * coupling_ * d * d;
    }
    return energy;
  }
  void hessian(std::span<const double>, SparseMatrix& lower) override {
    Triplets list;
    for (int i = 0; i < size(); ++i) add_entry(list, i, i, k_[i]);
    for (int i = 0; i + 1 < size(); ++i) {
      add_entry(list, i, i, coupling_);
      add_entry(list, i + 1, i + 1, coupling_);
      add_entry(list, i, i + 1, -coupling_);
    }
    build(list, size(), lower);
  }
  double tolerance() const override { return goal; }
  double goal = 1e-12;

 private:
  double coupling_;
  std::vector<double> k_;
};

/// Rosenbrock's valley, chained: sum 100 (x_{i+1} - x_i^2)^2 + (1 - x_i)^2; the minimum 0 is at x_i = 1.
class Rosenbrock : public Objective {
 public:
  explicit Rosenbrock(int n) : n_(n) {}
  int size() const override { return n_; }
  double evaluate(std::span<const double> x, std::span<double> g) override {
    double energy = 0;
    std::fill(g.begin(), g.end(), 0.0);
    for (int i = 0; i + 1 < n_; ++i) {
      const double a = x[i + 1] - x[i] * x[i], b = 1 - x[i];
      energy += 100 * a * a + b * b;
      g[i] -= 400 * a * x[i] + 2 * b;
      g[i + 1] += 200 * a;
    }
    return energy;
  }
  void hessian(std::span<const double> x, SparseMatrix& lower) override {
    Triplets list;
    for (int i = 0; i + 1 < n_; ++i) {
      add_entry(list, i, i, 1200 * x[i] * x[i] - 400 * x[i + 1] + 2);
      add_entry(list, i, i + 1, -400 * x[i]);
      add_entry(list, i + 1, i + 1, 200);
    }
    build(list, n_, lower);
  }
  double tolerance() const override { return 1e-10; }
  double largest_move() const override { return 0.5; }

 private:
  int n_;
};

/// sum over i of k_i x_i^2 / 2 + q_i x_i^4 / 4, where k_i or q_i or both may be zero.
class Diagonal : public Objective {
 public:
  Diagonal(std::vector<double> k, std::vector<double> q) : k_(std::move(k)), q_(std::move(q)) {}
  int size() const override { return static_cast<int>(k_.size()); }
  double evaluate(std::span<const double> x, std::span<double> g) override {
    double energy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      g[i] = k_[i] * x[i] + q_[i] * x[i] * x[i] * x[i];
      energy += 0.5 * k_[i] * x[i] * x[i] + 0.25 * q_[i] * x[i] * x[i] * x[i] * x[i];
    }
    return energy;
  }
  void hessian(std::span<const double> x, SparseMatrix& lower) override {
    Triplets list;
    for (int i = 0; i < size(); ++i)
      if (k_[i] != 0 || q_[i] != 0) add_entry(list, i, i, k_[i] + 3 * q_[i] * x[i] * x[i]);
    build(list, size(), lower);
  }
  double tolerance() const override { return goal; }
  double largest_move() const override { return 1; }
  double goal = 1e-12;

 private:
  std::vector<double> k_, q_;
};

/// Springs of stiffness 1 between random points of the unit square that are nearer than `reach`; the whole is
/// free to translate and rotate. Rest lengths are the distances of the points hidden(), times 1 + `misfit` x
/// a random number in [-1, 1).
class Springs : public Objective {
 public:
  Springs(int points, double reach, double misfit, int seed) : hidden_(2 * points) {
    RandomStream stream(seed, Purpose::test);
    for (double& c : hidden_) c = stream.uniform();
    for (int a = 0; a < points; ++a)
      for (int b = a + 1; b < points; ++b) {
        const double r = std::hypot(hidden_[2 * a] - hidden_[2 * b], hidden_[2 * a + 1] - hidden_[2 * b + 1]);
        if (r < reach) springs_.push_back({a, b, r * (1 + misfit * stream.uniform(-1, 1))});
      }
  }
  std::vector<double> start(double shake) const {
    RandomStream stream(1, Purpose::test, 1);
    std::vector<double> x = hidden_;
    for (double& c : x) c += stream.uniform(-shake, shake);
    return x;
  }
  int size() const override { return static_cast<int>(hidden_.size()); }
  double evaluate(std::span<const double> x, std::span<double> g) override {
    double energy = 0;
    std::fill(g.begin(), g.end(), 0.0);
    for (const Spring& s : springs_) {
      const double d[2] = {x[2 * s.b] - x[2 * s.a], x[2 * s.b + 1] - x[2 * s.a + 1]},
                   r = std::hypot(d[0], d[1]);
      energy += 0.5 * (r - s.rest) * (r - s.rest);
      for (int p = 0; p < 2; ++p) {
        g[2 * s.a + p] -= (r - s.rest) * d[p] / r;
        g[2 * s.b + p] += (r - s.rest) * d[p] / r;
      }
    }
    return energy;
  }
  void hessian(std::span<const double> x, SparseMatrix& lower) override {
    Triplets list;
    for (const Spring& s : springs_) {
      const double d[2] = {x[2 * s.b] - x[2 * s.a], x[2 * s.b + 1] - x[2 * s.a + 1]};
      add_pair_block(list, s.a, s.b, d, std::hypot(d[0], d[1]) - s.rest, 1.0);
    }
    build(list, size(), lower);
  }
  double tolerance() const override { return goal; }
  double largest_move() const override { return 0.02; }
  double goal = 1e-13;

 private:
  struct Spring {
    int a, b;
    double rest;
  };
  std::vector<double> hidden_;
  std::vector<Spring> springs_;
};

/// Discs of two sizes (ratio 1.4) in a periodic square cell, energy (k/2)(sigma - r)_+^2 per pair, k = 1,
/// small diameter 1: n = 2 N. Residual: largest net force; tolerance: `relative` times the mean contact
/// force, at least `absolute`.
class SoftDiscs : public Objective {
 public:
  SoftDiscs(int discs, double phi) : radius(discs) {
    double area = 0;
    for (int i = 0; i < discs; ++i) {
      radius[i] = i < discs / 2 ? 0.5 : 0.7;
      area += M_PI * radius[i] * radius[i];
    }
    length = std::sqrt(area / phi);
  }
  std::vector<double> start(int seed) const {
    RandomStream stream(seed, Purpose::test);
    std::vector<double> x(2 * radius.size());
    for (double& c : x) c = stream.uniform(0, length);
    return x;
  }

  int size() const override { return static_cast<int>(2 * radius.size()); }
  double evaluate(std::span<const double> x, std::span<double> g) override {
    double energy = 0, force = 0;
    contacts = 0;
    std::fill(g.begin(), g.end(), 0.0);
    for_pairs(x, [&](int a, int b, const double(&d)[2], double r, double sigma) {
      energy += 0.5 * (sigma - r) * (sigma - r);
      force += sigma - r;
      ++contacts;
      for (int p = 0; p < 2; ++p) {
        g[2 * a + p] += (sigma - r) * d[p] / r;
        g[2 * b + p] -= (sigma - r) * d[p] / r;
      }
    });
    mean_force = contacts ? force / contacts : 0.0;
    return energy;
  }
  void hessian(std::span<const double> x, SparseMatrix& lower) override {
    Triplets list;
    for_pairs(x, [&](int a, int b, const double(&d)[2], double r, double sigma) {
      add_pair_block(list, a, b, d, r - sigma, 1.0);
    });
    build(list, size(), lower);
  }
  double residual(std::span<const double>, std::span<const double> g) override {
    double most = 0;
    for (std::size_t i = 0; i < g.size(); i += 2) most = std::max(most, g[i] * g[i] + g[i + 1] * g[i + 1]);
    return std::sqrt(most);
  }
  double tolerance() const override { return std::max(relative * mean_force, absolute); }
  double largest_move() const override { return 0.1; }

  std::vector<double> radius;
  double length = 0, relative = 0, absolute = 1e-13, mean_force = 0;
  int contacts = 0;

 private:
  template <class Visit>
  void for_pairs(std::span<const double> x, Visit&& visit) const {
    const int n = static_cast<int>(radius.size());
    for (int a = 0; a < n; ++a)
      for (int b = a + 1; b < n; ++b) {
        double d[2] = {x[2 * b] - x[2 * a], x[2 * b + 1] - x[2 * a + 1]};
        for (double& c : d) c -= length * std::nearbyint(c / length);
        const double sigma = radius[a] + radius[b], rr = d[0] * d[0] + d[1] * d[1];
        if (rr < sigma * sigma) visit(a, b, d, std::sqrt(rr), sigma);
      }
  }
};

}  // namespace supple::testing
