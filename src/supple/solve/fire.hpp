/// FIRE 2.0: minimisation by dynamics that turns the velocity toward the force and stops where it would go
/// uphill.
#pragma once
#include <vector>

#include "supple/solve/descent.hpp"

namespace supple {

/// Parameters of FIRE; names in the comments are those of Guénolé et al. (2020).
struct FireSpec {
  double step =
      0.7;  ///< largest time step, in units of the stability limit 2/sqrt(largest eigenvalue), unit masses
  double growth = 1.1, cut = 0.5;             ///< f_inc, f_dec: factors of the time step
  int delay = 5;                              ///< N_delay: steps downhill before the time step grows
  double mixing = 0.25, mixing_decay = 0.99;  ///< alpha_start, f_alpha
  long refresh = 1000;                        ///< iterations after which the eigenvalue is estimated again
};

/// FIRE 2.0 with semi-implicit Euler steps [Guénolé, Nöhring, Vaid, Houllé, Xie, Prakash, Bitzek,
/// Comput. Mater. Sci. 175, 109584 (2020)]. The largest eigenvalue of the Hessian sets the largest time step.
class Fire {
 public:
  explicit Fire(const FireSpec& spec = {}) : spec_(spec) {}

  /// Moves until descent.finished(), until the residual is at most `factor` times the tolerance, or for
  /// `iterations` iterations. Starts at rest from the point last evaluated.
  void run(Descent& descent, double factor, long iterations);
  /// Largest eigenvalue of the Hessian as last estimated; 0 before that.
  double stiffness() const { return stiffness_; }

 private:
  void start(Descent& descent);
  void step(Descent& descent);
  void turn_back(Descent& descent);
  void recover(Descent& descent);
  void set_largest_step(Descent& descent, int iterations);

  FireSpec spec_;
  std::vector<double> velocity_, direction_, last_good_;
  double stiffness_ = 0, safety_ = 1;
  double dt_ = 0, dt_max_ = 0, mixing_ = 0;
  double energy_at_rest_ = 0;
  bool energy_known_ = true;  ///< the energy of the point last evaluated is known
  long downhill_ = 0, since_refresh_ = 0;
};

/// A lower estimate of the largest eigenvalue of the Hessian at the point last evaluated, by power iterations
/// on differences of the gradient, one evaluation each. Begins with `direction` if it has the right size, and
/// leaves the eigenvector found there.
double largest_eigenvalue(Descent& descent, std::vector<double>& direction, int iterations);

}  // namespace supple
