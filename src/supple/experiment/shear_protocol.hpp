/// The oscillation that a case asks for, of discs or deformable particles.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "supple/experiment/case.hpp"
#include "supple/experiment/derived.hpp"
#include "supple/experiment/initial_state.hpp"
#include "supple/experiment/problems.hpp"
#include "supple/experiment/protocol.hpp"
#include "supple/observe/demodulate.hpp"
#include "supple/solve/stepper.hpp"

namespace supple {

/// The protocol, with numbers from the user, else from the state, else defaults. The time step is at most
/// `longest_step` [time] and divides a period into a whole number of steps, enough for demodulation. Throws
/// an input error where the shear is shorter than a period or has more steps than can be counted.
OscillatoryProtocol oscillatory_protocol(const Case& c, const InitialState* initial, double frequency,
                                         double longest_step);

/// The spans of rest and shear in periods, as demodulate() needs them.
Protocol windows_of(const OscillatoryProtocol& p);

/// How a suspension is sheared: the rates of each step, and the spans and the way of the demodulation.
struct ShearProtocol {
  Protocol windows;
  Demodulator demodulator;
  std::int64_t steps,
      rows;  ///< one row a step; the documented protocol closes with the instant after the last
  double time_step, damping;
  std::function<ShearRates(std::int64_t step, double time)> rates;
};

/// What a run records of them, and its figure reads.
std::vector<Derived> derived_protocol(const Protocol& p, const std::string& frequency_unit);

/// Warns of too few periods for moduli, and for errors of moduli that are fitted.
void doubt_periods(const Case& c, Doubts& doubts);

}  // namespace supple
