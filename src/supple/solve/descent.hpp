/// A minimisation under way: the point, its gradient, and the account of the work done.
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
  stopped,      ///< by its callback, which had seen enough
  interrupted,  ///< the user asked to stop
  exhausted,    ///< max_evaluations were not enough
  stalled,      ///< the residual falls no further
  not_finite    ///< energy or gradient
};

/// What a minimisation reached, and why it stopped.
struct MinimiseReport {
  bool converged = false;
  Ending ending = Ending::stopped;
  long evaluations = 0, iterations = 0, factorisations = 0;
  double energy = 0, residual = 0, tolerance = 0;
  std::string reason;
};

/// Called every so many iterations; returns false to stop.
using MinimiseCallback = std::function<bool(const MinimiseReport&)>;

/// Whether the user asked to stop; asked at every evaluation, so it must be quick.
using StopRequest = std::function<bool()>;

/// The minimisers move `x` and call evaluate(); the last evaluation of a run is always at `x`.
struct Descent {
  Descent(Objective& function, std::span<double> point)
      : objective(function), x(point), gradient(point.size()) {}

  /// Energy, gradient, residual and tolerance at x. False if energy or gradient is not finite.
  bool evaluate();
  /// The same without the energy, which report holds of an earlier point then.
  bool evaluate_slope();
  /// Counts an iteration and calls back when it is time to.
  void count_iteration();
  /// Whether to stop: converged, out of evaluations, or told to. The report's reason then says why.
  /// Factorisations count as evaluations, as the time of a run is bounded by both.
  bool finished();
  /// Ends it as not converged; the first reason stays.
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
  /// Residual and tolerance at x. False if the gradient is not finite.
  bool look();

  bool stopped_ = false;
};

}  // namespace supple
