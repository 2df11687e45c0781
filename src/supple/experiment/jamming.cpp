#include <fmt/format.h>

#include "supple/core/error.hpp"
#include "supple/experiment/cost.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/experiment/jam.hpp"
#include "supple/experiment/key_sets.hpp"
#include "supple/experiment/packing_record.hpp"
#include "supple/experiment/sound_states.hpp"
#include "supple/experiment/way_to_jam.hpp"

namespace supple {

JamSpec jam_spec(const Case& c) {
  const std::string& name = c.jamming.search;
  const JamSearch search = name == "chapter"    ? JamSearch::chapter
                           : name == "pressure" ? JamSearch::pressure
                                                : JamSearch::root;
  return {search, c.jamming.pressure, c.jamming.window, c.jamming.step};
}

namespace {

template <int Dim>
std::vector<Derived> derive_jamming(const Case& c, const InitialState* initial) {
  const Packing<Dim> packing = make_periodic_packing<Dim>(c, initial, set_apart);
  std::vector<Derived> all = derived_equilibria(packing);
  all.push_back({{"evaluations", "", "force evaluations, within a factor of about two"},
                 evaluations_to_jam(packing.system.state.size())});
  return all;
}

template <int Dim>
void run_jamming(const Case& c, const InitialState* initial, Recorder& recorder) {
  Packing<Dim> packing = make_periodic_packing<Dim>(c, initial, at_random(recorder));
  begin_packing(packing, derived_equilibria(packing), recorder);
  const std::string& unit = packing.pressure_symbol;
  using P = JamProgress<Dim>;
  const Observables<P> observables{
      {{"packing_fraction", "", packing_fraction_meaning<Dim>},
       [&](const P& p) { return reached_fraction(packing, p); }},
      {{"pressure", unit, "full virial pressure (9.26)"}, [](const P& p) { return p.state.full_pressure; }},
      {{"contact_pressure", unit, "pressure by contacts alone"},
       [](const P& p) { return p.state.contact_pressure; }},
      {{"energy", "", "potential energy"}, [](const P& p) { return p.state.energy; }},
      {{"contact_stiffness", "", "of contacts, as a share of the case's"},
       [](const P& p) { return p.stiffness; }},
      {{"residual", "", "largest net force on a vertex"}, [](const P& p) { return p.last.residual; }},
      {{"evaluations", "", "force evaluations so far"},
       [](const P& p) { return static_cast<double>(p.evaluations); }},
      {{"unsound", "", unsound_meaning},
       [&](const P&) { return static_cast<double>(look_at(packing).bodies()); }}};
  observables.declare("packing", recorder);
  WayToJam way(c.jamming.pressure);
  JamState<Dim> state;
  const Keep keep = [&](Keeper& k) {
    k("packing", packing);
    k("jam", state);
  };
  restore(recorder, keep);
  const auto watch = [&](const JamProgress<Dim>& p) {
    if (is_minimum(p)) observables.append("packing", p, recorder);
    recorder.progress(
        fmt::format("jam: phi = {:.4f}, P = {:.2e}", reached_fraction(packing, p), p.state.pressure),
        static_cast<std::int64_t>(999 * way.share(p)), 1000);
    return true;
  };
  try {
    JamSpec spec = jam_spec(c);
    if (initial && spec.search == JamSearch::pressure)
      spec.search = JamSearch::root;  // soft contacts would rearrange it
    const JamProgress<Dim> end = jam(
        packing, spec, state, [&] { recorder.hold(keep, "after minimisation", state.minimisations()); },
        watch);
    recorder.progress("jam", 1000, 1000);
    record_packing(packing, end, recorder);
  } catch (const Error&) {
    hand_over_packing(packing, recorder);
    throw;
  }
}

}  // namespace

Experiment jamming() {
  return {.name = "jamming",
          .meaning = "isotropic compression of deformable particles to a jammed packing (9.4)",
          .matter = &body_matter(),
          .keys = with(minimised_keys(), {"jamming.*"}),
          .derive = {derive_jamming<2>, derive_jamming<3>},
          .run = {run_jamming<2>, run_jamming<3>},
          .figure = always<Figure::search>,
          .first_keys = {"experiment", "seed", "bodies.family", "bodies.N", "bodies.vertices",
                         "jamming.pressure"}};
}

}  // namespace supple
