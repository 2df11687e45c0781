#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "supple/core/error.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/experiment/jam.hpp"
#include "supple/experiment/packing_record.hpp"
#include "supple/experiment/sound_states.hpp"

namespace supple {

JamSpec jam_spec(const Case& c) {
  const std::string& name = c.jamming.search;
  const JamSearch search = name == "chapter"    ? JamSearch::chapter
                           : name == "pressure" ? JamSearch::pressure
                                                : JamSearch::root;
  return {search, c.jamming.pressure, c.jamming.window, c.jamming.step};
}

std::vector<Derived> derive_jamming(const Case& c, const InitialState* initial) {
  const Packing packing = make_periodic_packing(c, initial);
  return derived_equilibria(packing);
}

void run_jamming(const Case& c, const InitialState* initial, Recorder& recorder) {
  Packing packing = make_periodic_packing(c, initial);
  begin_packing(packing, derived_equilibria(packing), recorder);
  recorder.declare("packing", {{"packing_fraction", "", "covered area over area of the cell"},
                               {"pressure", packing.pressure_symbol, "full virial pressure (9.26)"},
                               {"contact_pressure", packing.pressure_symbol, "pressure by contacts alone"},
                               {"energy", "", "potential energy"},
                               {"residual", "", "largest net force on a vertex"},
                               {"evaluations", "", "force evaluations so far"},
                               {"unsound", "", unsound_meaning}});
  const double start = std::log(c.jamming.packing_fraction);
  const auto watch = [&](const JamProgress& p) {
    const double phi = reached_fraction(packing, p);
    const double row[] = {phi,
                          p.state.full_pressure,
                          p.state.contact_pressure,
                          p.state.energy,
                          p.last.residual,
                          static_cast<double>(p.evaluations),
                          static_cast<double>(look_at(packing).bodies())};
    if (p.settled) recorder.append("packing", row);
    // The way from the start to about 0.84 in packing fraction, which nobody knows exactly before.
    const double way = (std::log(phi) - start) / (std::log(0.9) - start);
    recorder.progress(fmt::format("jam, phi = {:.4f}, P = {:.2e}", phi, p.state.pressure),
                      static_cast<std::int64_t>(1000 * std::clamp(way, 0.0, 1.0)), 1000);
    return !recorder.stop_requested();
  };
  try {
    JamSpec spec = jam_spec(c);
    if (initial && spec.search == JamSearch::pressure)
      spec.search = JamSearch::root;  // soft contacts would rearrange it
    const JamProgress end = jam(packing, spec, watch);
    record_packing(packing, end, recorder);
  } catch (const Error&) {
    hand_over(packing, recorder);
    throw;
  }
}

}  // namespace supple
