/// The search for the jammed state: protocols over a packing, whatever it is made of.
#pragma once
#include <functional>

#include "supple/experiment/packing.hpp"

namespace supple {

/// How the jammed state is searched for.
/// * chapter: shrink the cell by steps; above the pressure go back to the state before and halve the step
///   [MacKeith 2025, section 9.4].
/// * root: the same steps until the pressure is exceeded, then a root search between the last state below and
///   the first above. Only states within a factor of two of the window are minimised to the full tolerance:
///   of the others it is enough to know the side on which they are.
/// * pressure: minima of the enthalpy at the wanted pressure, with contacts that are soft at first and as the
///   case has them at the end. Contacts much harder than the shapes leave a narrow, crooked way down to a
///   minimum; soft ones lead near it. If this leads nowhere, a root search follows from where particles first
///   pressed on each other.
enum class JamSearch { chapter, root, pressure };

/// The search, and when it is done.
struct JamSpec {
  JamSearch search = JamSearch::root;
  double pressure = 1e-7, window = 0.01;  ///< done when 1 < P/pressure < 1 + window [pressure unit]
  double step = 1e-3;                     ///< largest relative step of the packing fraction
  double coarse =
      1e-3;  ///< force tolerance of states far from the end [mean contact force]; not with chapter
};

/// The search as the case describes it.
JamSpec jam_spec(const Case& c);

/// The state after a minimisation, and the work so far.
struct JamProgress {
  PackingState state;
  MinimiseReport last;
  long minimisations = 0, evaluations = 0, unconverged = 0;
  bool settled = true;  ///< the state is a minimum of the energy to the full tolerance
};
/// The packing fraction that the search has reached; of a settled state the exact one, as it will be
/// reported.
double reached_fraction(const Packing& packing, const JamProgress& progress);
/// Called after each minimisation; returns false to stop.
using JamCallback = std::function<bool(const JamProgress&)>;

/// Searches by minima of the enthalpy (JamSearch::pressure). False if these do not lead to a packing in the
/// window; the packing is then where its particles first pressed on each other.
bool jam_at_pressure(Packing& packing, const JamSpec& spec, const JamCallback& callback,
                     JamProgress& progress);

/// Whether 1 < pressure/spec.pressure < 1 + spec.window.
bool in_window(const JamSpec& spec, double pressure);

/// Throws an input error where the cell is so small that a body meets itself, or one neighbour through two
/// images.
void require_room(const Packing& packing);

/// Takes the packing to the wanted pressure by isotropic compression. Throws a numerics error where no state
/// in the window exists within rounding (the packing is then at the last state below), and where a
/// minimisation ran out of evaluations or that of the jammed state did not converge (the packing is then at
/// `relaxed`). Throws `interrupted` where the callback returns false (the packing is as just minimised) or
/// the user stops a minimisation (the packing is at `relaxed`), and an input error where the cell gets too
/// small for its particles.
JamProgress jam(Packing& packing, const JamSpec& spec, const JamCallback& callback = {});

}  // namespace supple
