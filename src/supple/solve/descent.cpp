#include "supple/solve/descent.hpp"

#include <fmt/core.h>

#include <cmath>

namespace supple {

bool Descent::evaluate() {
  ++report.evaluations;
  report.energy = objective.evaluate(x, gradient);
  return look() && std::isfinite(report.energy);
}

bool Descent::evaluate_slope() {
  ++report.evaluations;
  objective.evaluate_slope(x, gradient);
  return look();
}

bool Descent::look() {
  report.residual = objective.residual(x, gradient);
  report.tolerance = objective.tolerance();
  if (stop_requested && stop_requested()) stop(Ending::interrupted, "interrupted");
  return std::isfinite(dot(gradient, gradient));
}

void Descent::count_iteration() {
  ++report.iterations;
  if (!callback || report.iterations % callback_interval != 0) return;
  if (!callback(report) && report.residual > report.tolerance) stop(Ending::stopped, "stopped by the caller");
}

bool Descent::finished() {
  if (stopped_) return true;
  if (report.residual <= report.tolerance) {
    report.converged = true;
    report.ending = Ending::converged;
    report.reason = "converged";
    return true;
  }
  if (report.evaluations + report.factorisations >= max_evaluations)
    stop(Ending::exhausted, fmt::format("{} evaluations were not enough", max_evaluations));
  return stopped_;
}

void Descent::stop(Ending ending, const std::string& reason) {
  if (stopped_) return;
  stopped_ = true;
  report.ending = ending;
  report.converged = false;
  report.reason = reason;
}

}  // namespace supple
