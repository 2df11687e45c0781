/// The oscillation that a case asks for, of whatever is sheared.
#pragma once
#include <string>
#include <vector>

#include "supple/experiment/case.hpp"
#include "supple/experiment/derived.hpp"
#include "supple/experiment/initial_state.hpp"
#include "supple/experiment/problems.hpp"
#include "supple/experiment/protocol.hpp"
#include "supple/observe/demodulate.hpp"

namespace supple {

/// Numbers of the user, else of the state, else defaults. The time step is at most `longest_step` and such
/// that a period has a whole number of steps, enough to be demodulated. Input error where it shears for less
/// than a period, or for more steps than can be counted.
OscillatoryProtocol oscillatory_protocol(const Case& c, const InitialState* initial, double frequency,
                                         double longest_step);

/// Its windows, as the demodulation needs them.
Protocol windows_of(const OscillatoryProtocol& p);

/// What a run records of them, and its figure reads.
std::vector<Derived> derived_protocol(const Protocol& p, const std::string& frequency_unit);

/// Too few periods for moduli, or for their errors.
void doubt_periods(const Case& c, Doubts& doubts);

}  // namespace supple
