/// Minimisation to mechanical equilibrium: which minimiser, in which order.
#pragma once
#include <string_view>

#include "supple/solve/fire.hpp"
#include "supple/solve/newton.hpp"

namespace supple {

/// `automatic` begins with FIRE, which comes near a minimum cheaply, and ends with Newton, which reaches it.
enum class Minimiser { automatic, fire, newton };

/// The minimiser called "auto", "fire" or "newton"; throws an input error for other names.
Minimiser minimiser_named(std::string_view name);

/// Which minimiser, and when it ends.
struct MinimiseSpec {
  Minimiser method = Minimiser::automatic;
  long max_evaluations = 1'000'000;  ///< evaluations and factorisations together
  double handover = 100;             ///< automatic: FIRE until the residual is this many tolerances ...
  long fire_iterations = 3000;       ///< ... or for this many iterations
  long callback_interval = 100;      ///< iterations
  StopRequest stop_requested;        ///< none: it cannot be interrupted
  FireSpec fire;
  NewtonSpec newton;
};

/// Moves x downhill until the residual of the objective is at most its tolerance. Where it does not get there
/// the report says why; this is no error. The last evaluation of `objective` is always at the x returned.
/// Throws an input error if x does not have objective.size() numbers.
MinimiseReport minimise(Objective& objective, std::span<double> x, const MinimiseSpec& spec = {},
                        const MinimiseCallback& callback = {});

}  // namespace supple
