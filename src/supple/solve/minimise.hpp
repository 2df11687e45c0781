/// The way down to mechanical equilibrium: which minimiser, in which order.
#pragma once
#include <string_view>

#include "supple/solve/fire.hpp"
#include "supple/solve/newton.hpp"

namespace supple {

/// `automatic` begins with FIRE, which finds the basin cheaply, and ends with Newton, which finds its bottom.
enum class Minimiser { automatic, fire, newton };

/// The minimiser called "auto", "fire" or "newton"; throws an input error for other names.
Minimiser minimiser_named(std::string_view name);

struct MinimiseSpec {
  Minimiser method = Minimiser::automatic;
  long max_evaluations = 1'000'000;  ///< and factorisations
  double handover = 100;             ///< automatic: FIRE until the residual is this many tolerances ...
  long fire_iterations = 3000;       ///< ... or for so many iterations
  long callback_interval = 100;      ///< iterations
  StopRequest stop_requested;        ///< none: it cannot be interrupted
  FireSpec fire;
  NewtonSpec newton;
};

/// Moves x downhill until the objective's residual is at most its tolerance. Not to get there is no error:
/// the report says why. The last evaluation of `objective` is always that of the x returned. Throws an input
/// error if x has not objective.size() numbers.
MinimiseReport minimise(Objective& objective, std::span<double> x, const MinimiseSpec& spec = {},
                        const MinimiseCallback& callback = {});

}  // namespace supple
