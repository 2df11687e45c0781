#include <fmt/format.h>

#include <cmath>
#include <ctime>
#include <numeric>

#include "supple/core/error.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/experiment/frame.hpp"
#include "supple/experiment/microgel.hpp"
#include "supple/experiment/stress_table.hpp"
#include "supple/experiment/suspension.hpp"

namespace supple {

namespace {

/// Number of the protocol: the user's key, else the state's, else the default.
double protocol_number(const Case& c, const InitialState* initial, const char* key, const char* stored, double of_case) {
  if (!initial || c.is_given(std::string("shear.") + key)) return of_case;
  const auto at = initial->protocol.find(stored);
  return at == initial->protocol.end() ? of_case : at->second;
}

OscillatoryProtocol make_protocol(const Case& c, const InitialState* initial, const MicrogelConstants& k) {
  OscillatoryProtocol p;
  p.amplitude = protocol_number(c, initial, "amplitude", "amplitude", c.shear.amplitude);
  p.frequency = k.frequency;
  p.pre_periods = protocol_number(c, initial, "pre_periods", "pre", c.shear.pre_periods);
  p.periods = protocol_number(c, initial, "periods", "periods", c.shear.periods);
  p.post_periods = protocol_number(c, initial, "post_periods", "post", c.shear.post_periods);
  p.steps_per_period = static_cast<int>(std::ceil(1 / (k.frequency * k.time_step) * (1 - 1e-12)));
  return p;
}

/// Steps at which frames are kept: evenly spaced, the first and the last included.
class FrameSchedule {
 public:
  FrameSchedule(std::int64_t steps, int frames) : steps_(steps), frames_(std::max(frames, 2)) {}
  bool due(std::int64_t step) {
    if (step < std::llround(static_cast<double>(next_) * static_cast<double>(steps_) / (frames_ - 1))) return false;
    ++next_;
    return true;
  }

 private:
  std::int64_t steps_;
  int frames_, next_ = 0;
};

void record_moduli(const StressTable& table, const OscillatoryProtocol& p, Recorder& recorder) {
  const Protocol windows{p.frequency, p.amplitude, p.pre_periods, p.periods, p.post_periods};
  const auto record = [&](const std::string& name, const std::vector<double>& stress, const std::string& meaning) {
    const Demodulation d = demodulate(table.time(), stress, windows, DriftCorrection::right);
    recorder.value("results", {"storage_modulus_" + name, "Pa", "G' from " + meaning}, d.storage, d.storage_error);
    recorder.value("results", {"loss_modulus_" + name, "Pa", "G'' from " + meaning}, d.loss, d.loss_error);
    recorder.value("results", {"in_phase_stress_" + name, "Pa", "in phase with the strain"}, d.in_phase);
    recorder.value("results", {"out_of_phase_stress_" + name, "Pa", "in phase with the strain rate"}, d.out_of_phase);
    recorder.value("results", {"third_harmonic_" + name, "Pa", "amplitude of the third harmonic"}, d.third_amplitude);
    return std::hypot(d.storage, d.loss);
  };
  const double internal = record("internal", table.internal(), "the overall stress tensor (S1-24)");
  const double external = record("external", table.external(), "external forces (S1-16)");
  record("periodic", table.periodic(), "Love-Weber with contacts across x internal");
  record("virial", table.virial(), "the virial of all contacts");
  if (std::abs(internal - external) > 0.3 * std::max(internal, external))
    recorder.warning(fmt::format("|G*| of the internal ({:.4g} Pa) and external ({:.4g} Pa) stress differ by more than 30 %: "
                                 "the sample is not in a steady cycle, or too few discs carry the stress",
                                 internal, external));
}

double mean(const std::vector<double>& x) {
  return std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(x.size());
}

void record_counts(const System<2>& system, const Evaluation<2>& evaluation, Recorder& recorder) {
  int contacts = 0, links = 0, slipping = 0, plate = 0;
  for (int row = 0; row < system.pairs.size(); ++row) {
    if (!evaluation.pair[row].active) continue;
    ++contacts;
    links += evaluation.trial_state[row] == ContactState::permanent;
    slipping += evaluation.trial_state[row] == ContactState::slip;
  }
  for (Mobility m : system.state.mobility) plate += m != Mobility::free;
  recorder.value("results", {"contacts", "", "touching or linked pairs at the end"}, contacts);
  recorder.value("results", {"links", "", "permanent links"}, links);
  recorder.value("results", {"slipping_contacts", "", "contacts that slip at the end"}, slipping);
  recorder.value("results", {"plate_discs", "", "discs on the plates at the end"}, plate);
}

}  // namespace

std::vector<Derived> derive_oscillatory_shear(const Case& c, const InitialState* initial) {
  const MicrogelConstants k = derive_constants(c, initial);
  const OscillatoryProtocol p = make_protocol(c, initial, k);
  return {
      {{"spring_constant", "N/m per m", "k = (pi/8) E (S1-8)"}, k.k},
      {{"tangential_spring_constant", "N/m per m", "k_t of contacts"}, k.law.contact.k_t},
      {{"viscosity", "N s/m per m", "eta of contacts (S1-9)"}, k.law.contact.eta},
      {{"mean_mass", "kg per m", "mean mass of a disc"}, k.mean_mass},
      {{"time_constant", "s", "tau = sqrt(m/k)"}, k.tau},
      {{"frequency", "Hz", "of the oscillation"}, k.frequency},
      {{"stable_time_step", "s", "stability limit"}, k.stable_step},
      {{"time_step", "s", "time step"}, p.time_step()},
      {{"steps_per_period", "", "steps per period"}, static_cast<double>(p.steps_per_period)},
      {{"steps", "", "steps of the protocol"}, static_cast<double>(p.steps())},
  };
}

void run_oscillatory_shear(const Case& c, const InitialState* initial, Recorder& recorder) {
  check(c);
  const std::clock_t start = std::clock();
  const OscillatoryProtocol protocol = make_protocol(c, initial, derive_constants(c, initial));
  Suspension s = make_suspension(c, initial);
  s.time_step = protocol.time_step();
  s.damping = std::pow(c.shear.cool_factor, 1.0 / protocol.steps_per_period);

  if (initial) adopt_state(s, c, *initial); else prepare(s, c, recorder);
  s.system.time = 0;
  s.system.step = 0;
  recorder.begin(make_run_info(s.system, s.units));
  for (const Derived& d : derive_oscillatory_shear(c, initial)) recorder.value("constants", d.name, d.value);

  StressTable table(recorder, s.units, c.output.tensors);
  FrameSchedule frames(protocol.steps(), c.output.images > 0 ? c.output.images : c.output.frames + 1);
  for (std::int64_t i = 0; i <= protocol.steps(); ++i) {
    const Evaluation<2>& evaluation = s.stepper->evaluate(s.system, protocol.rates(i));
    table.append(s.system, stress_tensors(s.system, evaluation, s.units.stress()));
    if (frames.due(i)) recorder.frame(make_frame(s.system, evaluation));
    if (i == protocol.steps() || recorder.stop_requested()) {
      record_counts(s.system, evaluation, recorder);
      recorder.final_state(s.system, evaluation);
      if (i < protocol.steps()) throw Error(ErrorKind::interrupted, "interrupted at step " + std::to_string(i));
      break;
    }
    s.stepper->advance(s.system, protocol.rates(i), s.time_step, s.damping);
    if (i % 256 == 0) recorder.progress("oscillatory shear", i, protocol.steps());
  }
  record_moduli(table, protocol, recorder);
  recorder.value("results", {"mean_normal_stress", "Pa", "mean of (xx + yy)/2 over the protocol"}, mean(table.pressure()));
  recorder.value("results", {"cpu_time", "s", "processor time of the run"},
                 static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
}

}  // namespace supple
