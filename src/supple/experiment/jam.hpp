/// The search for the jammed state: protocols over a packing, whatever it is made of.
#pragma once
#include <functional>

#include "supple/experiment/packing.hpp"

namespace supple {

/// Chapter: shrink by steps; above the pressure go back to the state before and halve the step [MacKeith
/// 2025, section 9.4]. Root: the same steps until the pressure is exceeded, then a root search between the
/// last state below it and the first above; only states within a factor of two of the window are minimised to
/// the last digit, as of the others no more is asked than on which side they are. Pressure: minima of the
/// enthalpy at the wanted pressure, with contacts that begin soft and end as they are; and the root search
/// from where particles first press on each other, should that lead nowhere. Contacts much harder than the
/// shapes leave a narrow, crooked way down to a minimum; soft ones lead near it.
enum class JamSearch { chapter, root, pressure };

struct JamSpec {
  JamSearch search = JamSearch::root;
  double pressure = 1e-7, window = 0.01;  ///< done when 1 < P/pressure < 1 + window [pressure unit]
  double step = 1e-3;                     ///< largest relative step of the packing fraction
  double coarse =
      1e-3;  ///< force tolerance of states far from the end [mean contact force]; not with chapter
};

/// The search that the case asks for.
JamSpec jam_spec(const Case& c);

/// After each minimisation: the state, and the work so far. The callback returns false to stop.
struct JamProgress {
  PackingState state;
  MinimiseReport last;
  long minimisations = 0, evaluations = 0, unconverged = 0;
  bool settled = true;  ///< the state is a minimum of the energy itself, to the tolerance that was asked for
};
/// The packing fraction where the search is: the exact one of a state that has settled, as it will be
/// reported.
double reached_fraction(const Packing& packing, const JamProgress& progress);
using JamCallback = std::function<bool(const JamProgress&)>;

/// The minima of the enthalpy of JamSearch::pressure. False if they do not lead to a packing in the window,
/// with the packing where its particles first pressed on each other.
bool jam_at_pressure(Packing& packing, const JamSpec& spec, const JamCallback& callback,
                     JamProgress& progress);

bool in_window(const JamSpec& spec, double pressure);

/// Input error where the cell is so small that a body meets itself, or one neighbour through two images.
void require_room(const Packing& packing);

/// Takes the packing to the wanted pressure by isotropic compression. Throws a numerics error where no state
/// in the window exists within rounding, with the packing at the last state below, or where a minimisation
/// was exhausted or that of the jammed state did not converge, with the packing last relaxed; `interrupted`
/// when the callback says so, with the packing just minimised, and within a minimisation, with the packing
/// last relaxed. An input error where the cell gets too small for its particles.
JamProgress jam(Packing& packing, const JamSpec& spec, const JamCallback& callback = {});

}  // namespace supple
