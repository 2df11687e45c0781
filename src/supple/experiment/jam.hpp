/// The search for the jammed state: protocols over a packing, whatever it is made of.
#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <type_traits>

#include "supple/experiment/packing.hpp"

namespace supple {

/// How the jammed state is searched for.
/// * chapter: shrink the cell by steps; above the pressure go back to the state before and halve the step
///   [MacKeith 2025, section 9.4].
/// * root: the same steps until the pressure is exceeded, then a root search between the last state below and
///   the first above. Only states within a factor of two of the window are minimised to the full tolerance:
///   of the others it is enough to know the side on which they are.
/// * pressure: minima of the enthalpy, at a high pressure and with soft contacts at first, then at pressures
///   that fall to the wanted one, then with contacts that harden to those of the case. Contacts that yield
///   little leave a narrow, crooked way down to a minimum; the more they yield, the longer its steps. If this
///   leads nowhere, a root search follows from where particles first pressed on each other.
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
template <int Dim>
struct JamProgress {
  PackingState<Dim> state;
  MinimiseReport last;
  long minimisations = 0, evaluations = 0, unconverged = 0;
  bool settled = true;   ///< the state is a minimum of the energy to the full tolerance
  double stiffness = 1;  ///< of the contacts, as a share of the case's
  /// Share of the work that is done, where the search knows it (JamSearch::pressure).
  std::optional<double> share;

  void keep(Keeper& k) {
    k("state", state);
    k("last", last);
    k("minimisations", minimisations);
    k("evaluations", evaluations);
    k("unconverged", unconverged);
    k("settled", settled);
    k("stiffness", stiffness);
    k("share", share);
  }
};
/// Whether the state is a minimum with contacts as they are at this stage of the search.
template <int Dim>
bool is_minimum(const JamProgress<Dim>& p) {
  return p.settled || (p.stiffness < 1 && p.last.converged);
}
/// The packing fraction that the search has reached; of a minimum the exact one, as it will be reported.
template <int Dim>
double reached_fraction(const Packing<Dim>& packing, const JamProgress<Dim>& progress);
/// Called after each minimisation; returns false to stop.
template <int Dim>
using JamCallback = std::function<bool(const JamProgress<Dim>&)>;

/// Called before each minimisation, where the search can go on from its state.
using BeforeMinimisation = std::function<void()>;

/// A state of the search on a line of packing fractions.
template <int Dim>
struct JamPoint {
  System<Dim> system;
  double density = 0;  ///< ln phi + constant
  double pressure = 0;

  void keep(Keeper& k) {
    k("system", system);
    k("density", density);
    k("pressure", pressure);
  }
};

/// How far the search along the packing fraction has got (JamSearch::chapter and root).
template <int Dim>
struct LineSearchState {
  /// What the next minimisation is for.
  enum class Way { start, halve, stride, descend, root };
  /// From which end of the interval a root search starts its minimisations. On the way down a packing stays
  /// jammed at densities at which it had not jammed on the way up.
  enum class From { below, above };
  Way way = Way::start;
  std::optional<JamPoint<Dim>> low, high;  ///< the last states below and above the pressure
  double step = 0;                         ///< the next, of ln phi
  From from = From::below;
  double low_weight = 1, high_weight = 1;
  int narrowed = 0, turns = 0;
  double slope = 0;  ///< dP/d(ln phi) between the last two states above; 0: not known

  void keep(Keeper& k) {
    k("way", way);
    k("low", low);
    k("high", high);
    k("step", step);
    k("from", from);
    k("low_weight", low_weight);
    k("high_weight", high_weight);
    k("narrowed", narrowed);
    k("turns", turns);
    k("slope", slope);
  }
};

/// How far the search at a pressure has got (JamSearch::pressure).
template <int Dim>
struct PressState {
  enum class Part { approach, soften, harden, failed };
  Part part = Part::approach;
  std::optional<System<Dim>> good;  ///< in the approach: the last sound state; then where it led
  double step = 0;                  ///< of the approach, of ln phi
  int stage = 0;                    ///< of softened contacts
  int round = 0, losses = 0;        ///< of hardened contacts
  int pressed = 0;                  ///< minima of the enthalpy in this stage or round
  bool is_pressed = false;          ///< whether the last of them was found
  double ratio = 1;                 ///< of the pressure of all forces to the one wanted

  void keep(Keeper& k) {
    k("part", part);
    k("good", good);
    k("step", step);
    k("stage", stage);
    k("round", round);
    k("losses", losses);
    k("pressed", pressed);
    k("is_pressed", is_pressed);
    k("ratio", ratio);
  }
};

/// How far a search has got: with the packing all that it needs to go on.
template <int Dim>
struct JamState {
  JamProgress<Dim> progress;
  PressState<Dim> press;
  LineSearchState<Dim> line;

  std::int64_t minimisations() const { return progress.minimisations; }
  void keep(Keeper& k) {
    k("progress", progress);
    k("press", press);
    k("line", line);
  }
};

/// Searches by minima of the enthalpy (JamSearch::pressure). False if these do not lead to a packing in the
/// window; the packing is then where its particles first pressed on each other.
template <int Dim>
bool jam_at_pressure(Packing<Dim>& packing, const JamSpec& spec, JamState<Dim>& state,
                     const BeforeMinimisation& before, const JamCallback<Dim>& callback);

/// Whether 1 < pressure/spec.pressure < 1 + spec.window.
bool in_window(const JamSpec& spec, double pressure);

/// Throws an input error where the cell is so small that a body meets itself, or one neighbour through two
/// images.
template <int Dim>
void require_room(const Packing<Dim>& packing);

/// Takes the packing to the wanted pressure by isotropic compression. Throws a numerics error where no state
/// in the window exists within rounding (the packing is then at the last state below), and where a
/// minimisation ran out of evaluations or that of the jammed state did not converge (the packing is then at
/// `relaxed`). Throws `interrupted` where the callback returns false (the packing is as just minimised) or
/// the user stops a minimisation (the packing is at `relaxed`), and an input error where the cell gets too
/// small for its particles.
template <int Dim>
JamProgress<Dim> jam(Packing<Dim>& packing, const JamSpec& spec,
                     const std::type_identity_t<JamCallback<Dim>>& callback = {});
/// The same from where `state` says that the search is.
template <int Dim>
JamProgress<Dim> jam(Packing<Dim>& packing, const JamSpec& spec, JamState<Dim>& state,
                     const BeforeMinimisation& before,
                     const std::type_identity_t<JamCallback<Dim>>& callback);

}  // namespace supple
