/// A minimisation under way: the point, its gradient, and a report of the work done.
#pragma once
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "supple/solve/objective.hpp"

namespace supple {

/// Why a minimisation ended.
enum class Ending {
  converged,
  stopped,      ///< by the callback
  interrupted,  ///< the user asked to stop
  exhausted,    ///< max_evaluations were not enough
  stalled,      ///< the residual falls no further
  not_finite    ///< energy or gradient
};

/// What a minimisation reached, and why it ended.
struct MinimiseReport {
  bool converged = false;
  Ending ending = Ending::stopped;
  long evaluations = 0, iterations = 0, factorisations = 0;
  double energy = 0, residual = 0, tolerance = 0;
  std::string reason;
};

/// Called every `callback_interval` iterations; returns false to stop.
using MinimiseCallback = std::function<bool(const MinimiseReport&)>;

/// Whether the user asked to stop. Called at every evaluation, so it must be quick.
using StopRequest = std::function<bool()>;

/// What the minimisers share: they move `x` and evaluate there. At the end of a run the last evaluation is at
/// `x`.
struct Descent {
  Descent(Objective& function, std::span<double> point)
      : objective(function), x(point), gradient(point.size()) {}

  /// Computes energy, gradient, residual and tolerance at x. False if energy or gradient is not finite.
  bool evaluate();
  /// The same without the energy; the one in `report` is then that of an earlier point.
  bool evaluate_slope();
  /// Counts an iteration and calls back when it is time to.
  void count_iteration();
  /// Whether to stop: converged, out of evaluations, or asked to. The report then says why. Factorisations
  /// count as evaluations, because they take time too.
  bool finished();
  /// Ends the minimisation as not converged. Only the first call sets ending and reason.
  void stop(Ending ending, const std::string& reason);

  Objective& objective;
  std::span<double> x;
  std::vector<double> gradient;
  MinimiseReport report;
  long max_evaluations = 1'000'000;
  long callback_interval = 100;  ///< iterations
  MinimiseCallback callback;
  StopRequest stop_requested;

 private:
  /// Computes residual and tolerance at x. False if the gradient is not finite.
  bool look();

  bool stopped_ = false;
};

}  // namespace supple
