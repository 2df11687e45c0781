#include "supple/experiment/moduli.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numeric>
#include <string>

#include "supple/observe/summary.hpp"

namespace supple {

namespace {

double mean(const std::vector<double>& x) {
  return std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(x.size());
}

}  // namespace

void record_moduli(const StressTable& table, const Protocol& protocol, DriftCorrection correction, Recorder& recorder) {
  const auto record = [&](const std::string& name, const std::vector<double>& stress, const std::string& meaning) {
    const Demodulation d = demodulate(table.time(), stress, protocol, correction);
    const auto value = [&](const char* what, const char* unit, const std::string& says, double v, double error = -1) {
      recorder.value("results", {std::string(what) + "_" + name, unit, says}, v, error);
    };
    value("storage_modulus", "Pa", "G' from " + meaning, d.storage, d.storage_error);
    value("loss_modulus", "Pa", "G'' from " + meaning, d.loss, d.loss_error);
    value("in_phase_stress", "Pa", "amplitude in phase with the strain", d.in_phase);
    value("out_of_phase_stress", "Pa", "amplitude in phase with the strain rate", d.out_of_phase);
    value("third_harmonic", "Pa", "amplitude of the third harmonic", d.third_amplitude);
    value("third_harmonic_phase", "rad", "phase of the third harmonic", d.third_phase);
    return std::hypot(d.storage, d.loss);
  };
  const double internal = record("internal", table.internal(), "the overall stress tensor (S1-24)");
  const double external = record("external", table.external(), "external forces (S1-16)");
  record("external_corrected", table.external_corrected(), "external forces without the jumps of the cut");
  record("periodic", table.periodic(), "Love-Weber with contacts across x internal");
  record("virial", table.virial(), "the virial of all contacts");
  recorder.value("results", {"mean_normal_stress", "Pa", "mean of (xx + yy)/2 of the overall tensor over the protocol"},
                 mean(table.pressure()));
  if (std::abs(internal - external) > 0.3 * std::max(internal, external))
    recorder.warning(fmt::format("|G*| of the internal ({:.4g} Pa) and external ({:.4g} Pa) stress differ by more than "
                                 "30 %: no steady cycle yet, or too few discs carry the stress",
                                 internal, external));
}

void record_counts(const System<2>& system, const Evaluation<2>& evaluation, Recorder& recorder) {
  const ContactCounts counts = contact_counts(evaluation);
  int plate = 0;
  for (Mobility m : system.state.mobility) plate += m != Mobility::free;
  recorder.value("results", {"contacts", "", "touching or linked pairs at the end"}, counts.total());
  recorder.value("results", {"links", "", "permanent links at the end"}, counts.links);
  recorder.value("results", {"slipping_contacts", "", "contacts that slip at the end"}, counts.slip);
  recorder.value("results", {"coordination", "", "contacts and links per disc"}, coordination(system, evaluation));
  recorder.value("results", {"plate_discs", "", "discs on the plates at the end"}, plate);
}

}  // namespace supple
