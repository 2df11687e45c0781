#include "supple/experiment/moduli.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "supple/observe/summary.hpp"

namespace supple {

namespace {

constexpr double apart = 0.3;        // of the larger modulus
constexpr double relevant = 0.05;    // of |G*|: below it a difference is one of noise
constexpr double told_drift = 0.02;  // of |G*|, change over the measured cycles

double size(const Estimate& e) { return std::hypot(e.found.storage.value, e.found.loss.value); }

}  // namespace

void warn_if_apart(const Estimate& a, const Estimate& b, const std::string& why, Recorder& recorder) {
  const auto compare = [&](const char* symbol, double x, double y) {
    const double difference = std::abs(x - y);
    if (difference <= apart * std::max(std::abs(x), std::abs(y)) ||
        difference <= relevant * std::max(size(a), size(b)))
      return;
    recorder.warning(
        fmt::format("{} of the {} ({:.4g} {}) and the {} stress ({:.4g} {}) differ by more than {:.0f} %: {}",
                    symbol, a.name, x, a.unit, b.name, y, b.unit, 100 * apart, why));
  };
  compare("G'", a.found.storage.value, b.found.storage.value);
  compare("G''", a.found.loss.value, b.found.loss.value);
}

void warn_of_drift(const Estimate& e, Recorder& recorder) {
  const auto tell = [&](const char* symbol, const Modulus& m) {
    if (!m.drifts() || e.found.cycles * std::abs(m.change) < told_drift * size(e)) return;
    recorder.warning(fmt::format(
        "{} ({} stress) {} by {:.2g} {} per cycle over the {} cycles measured: the sample ages "
        "and is not in a steady cycle; more shear.periods show where it leads",
        symbol, e.name, m.change > 0 ? "rises" : "falls", std::abs(m.change), e.unit, e.found.cycles));
  };
  tell("G'", e.found.storage);
  tell("G''", e.found.loss);
}

double Gap::wavelengths(double storage, double frequency) const {
  return std::sqrt(std::max(storage, 0.0) / density) / (frequency * height);
}

Gap gap_of(const System<2>& system, const Units& units) {
  double mass = 0;
  for (const double m : system.state.mass) mass += m;
  return {system.box.length[gradient] * units.length, mass / system.box.volume() * units.density()};
}

std::optional<Protocol> whole_cycles(Protocol protocol, const std::vector<double>& time) {
  if (time.empty()) return std::nullopt;
  const double sheared = time.back() * protocol.frequency - protocol.pre;
  protocol.periods = std::min(protocol.periods, std::floor(sheared + 1e-9));
  protocol.post = 0;
  return protocol.periods >= 1 ? std::optional(protocol) : std::nullopt;
}

Demodulation record_modulus(const StressSeries& s, const Protocol& protocol, Demodulator demodulator,
                            Recorder& recorder) {
  const Demodulation d = demodulate(s.time, s.stress, protocol, demodulator);
  const auto value = [&](const char* what, const std::string& unit, const std::string& says, double v,
                         double error = -1) {
    recorder.value("results", {std::string(what) + "_" + s.name, unit, says}, v, error);
  };
  value("storage_modulus", s.unit, "G' from " + s.meaning, d.storage.value, d.storage.error);
  value("loss_modulus", s.unit, "G'' from " + s.meaning, d.loss.value, d.loss.error);
  value("storage_change", s.unit, "change of G' from cycle to cycle", d.storage.change,
        d.storage.change_error);
  value("loss_change", s.unit, "change of G'' from cycle to cycle", d.loss.change, d.loss.change_error);
  value("in_phase_stress", s.unit, "amplitude in phase with the strain", d.in_phase);
  value("out_of_phase_stress", s.unit, "amplitude in phase with the strain rate", d.out_of_phase);
  value("third_harmonic", s.unit, "amplitude of the third harmonic", d.third_amplitude);
  value("third_harmonic_phase", "rad", "phase of the third harmonic", d.third_phase);
  return d;
}

void record_moduli(const StressTable& table, const Protocol& protocol, Demodulator demodulator,
                   const Gap& gap, Recorder& recorder) {
  const std::vector<double> time = table.column("t");
  const auto record = [&](const std::string& name, const std::string& meaning) {
    return Estimate{name, "Pa",
                    record_modulus({name, meaning, "Pa", time, table.column("shear_stress_" + name)},
                                   protocol, demodulator, recorder)};
  };
  const bool plated = table.has_plates();
  std::vector<Estimate> first;
  if (plated) first.push_back(record("plates", "the force of the plates over the width of the cell"));
  first.push_back(record("virial", "the virial of all contacts"));
  record("periodic", "Love-Weber with contacts across x internal");
  const Estimate internal = record("internal", "the overall stress tensor (S1-24), as published");
  const Estimate external = record("external", "external forces (S1-16), as published");
  const Estimate corrected = record("external_corrected", "external forces without the jumps of the cut");
  recorder.value("results", {"cycles", "", "whole cycles of shear that were demodulated"},
                 first.front().found.cycles);
  const double waves = gap.wavelengths(first.back().found.storage.value, protocol.frequency);
  recorder.value("results",
                 {"wavelength_over_gap", "", "shear wave, c/f with c^2 = G'/density (virial), over the gap"},
                 waves);
  recorder.value("results",
                 {"mean_normal_stress", "Pa", "mean of (xx + yy)/2 of the overall tensor over the protocol"},
                 table.mean_pressure());

  if (plated)
    warn_if_apart(first[0], first[1],
                  "plates and bulk are not in step, or the sample is too small for its plates", recorder);
  warn_if_apart(internal, external,
                "the frequency is too high for a uniform stress, or too few discs carry it", recorder);
  warn_of_drift(first.front(), recorder);
  if (const double jumps = table.most_removed(); jumps > apart * protocol.amplitude * size(corrected))
    recorder.warning(
        fmt::format("external_corrected: jumps of {:.4g} Pa were taken out of a stress of amplitude {:.4g} "
                    "Pa; its level is that of the first cut, take virial or plates",
                    jumps, protocol.amplitude * size(corrected)));
  if (waves < short_wavelength)
    recorder.warning(
        fmt::format("shear waves are {:.2g} gaps long: near or above the resonance of the gap (1) the stress "
                    "is not uniform and estimators differ; lower shear.relative_frequency {:.0f}-fold",
                    waves, std::ceil(2 * short_wavelength / std::max(waves, 0.01))));
}

void record_counts(const System<2>& system, const Evaluation<2>& evaluation, Recorder& recorder) {
  const ContactCounts counts = contact_counts(evaluation);
  int plate = 0;
  for (Mobility m : system.state.mobility) plate += m != Mobility::free;
  recorder.value("results", {"contacts", "", "touching or linked pairs at the end"}, counts.total());
  recorder.value("results", {"links", "", "permanent links at the end"}, counts.links);
  recorder.value("results", {"slipping_contacts", "", "contacts that slip at the end"}, counts.slip);
  recorder.value("results", {"coordination", "", "contacts and links per disc"},
                 coordination(system, evaluation));
  recorder.value("results", {"plate_discs", "", "discs on the plates at the end"}, plate);
}

}  // namespace supple
