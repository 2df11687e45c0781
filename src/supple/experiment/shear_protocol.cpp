#include "supple/experiment/shear_protocol.hpp"

#include <fmt/format.h>

#include "supple/core/error.hpp"
#include "supple/core/whole_number.hpp"
#include "supple/observe/demodulate.hpp"

namespace supple {

namespace {

/// Number of the protocol: the user's key, else the state's, else the default.
double protocol_number(const Case& c, const InitialState* initial, const char* key, const char* stored,
                       double of_case) {
  if (!initial || c.is_given(std::string("shear.") + key)) return of_case;
  const auto at = initial->protocol.find(stored);
  return at == initial->protocol.end() ? of_case : at->second;
}

/// A step shorter than stability needs, where the oscillation is fast: twice what a cycle must have to be
/// demodulated.
constexpr int least_steps_per_period = 2 * least_samples_of_cycle;

}  // namespace

OscillatoryProtocol oscillatory_protocol(const Case& c, const InitialState* initial, double frequency,
                                         double longest_step) {
  OscillatoryProtocol p;
  p.amplitude = protocol_number(c, initial, "amplitude", "amplitude", c.shear.amplitude);
  p.frequency = frequency;
  const double pre = protocol_number(c, initial, "pre_periods", "pre", c.shear.pre_periods);
  const double periods = protocol_number(c, initial, "periods", "periods", c.shear.periods);
  const double post = protocol_number(c, initial, "post_periods", "post", c.shear.post_periods);
  if (periods < 1)
    throw input_error(fmt::format("shear.periods = {} is less than one period", periods),
                      "G', G'', offset and drift of the stress cannot be told apart", "set it to 1 or more");
  const double per_period =
      std::max(std::ceil(1 / (frequency * longest_step) * (1 - 1e-12)), 1.0 * least_steps_per_period);
  if (!(per_period * (pre + periods + post) < most_counted))
    throw input_error(
        fmt::format("the protocol has {:.3g} steps, {:.3g} in a period", per_period * (pre + periods + post),
                    per_period),
        fmt::format("it can have {:.0g}", most_counted),
        fmt::format("raise shear.relative_frequency (to {:.1g} or more)",
                    c.shear.relative_frequency * per_period * (pre + periods + post) / most_counted));
  p.steps_per_period = std::llround(per_period);
  p.pre_steps = std::llround(pre * per_period);
  p.shear_steps = std::llround(periods * per_period);
  p.post_steps = std::llround(post * per_period);
  return p;
}

Protocol windows_of(const OscillatoryProtocol& p) {
  return {p.frequency, p.amplitude, p.periods(p.pre_steps), p.periods(p.shear_steps),
          p.periods(p.post_steps)};
}

void doubt_periods(const Case& c, Doubts& doubts) {
  if (c.shear.periods < 2)
    doubts.push_back(
        fmt::format("shear.periods = {}: the first period is transient and there is no second to demodulate",
                    c.shear.periods));
  else if (c.shear.periods < 4)
    doubts.push_back(
        fmt::format("shear.periods = {}: no error of G' and G'', as the cycles after the first are fewer "
                    "than three",
                    c.shear.periods));
}

std::vector<Derived> derived_protocol(const Protocol& p, const std::string& frequency_unit) {
  return {{{"frequency", frequency_unit, "of the oscillation"}, p.frequency},
          {{"strain_amplitude", "", "A"}, p.amplitude},
          {{"pre_periods", "", "periods of rest before"}, p.pre},
          {{"periods", "", "periods of shear"}, p.periods},
          {{"post_periods", "", "periods of rest after"}, p.post}};
}

}  // namespace supple
