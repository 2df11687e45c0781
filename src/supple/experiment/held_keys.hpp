/// The keys of a case that stay with its state: the laws that act, and how the sample was made, by name.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <variant>

#include "supple/experiment/case.hpp"

namespace supple {

/// Values by key ("contact.kind"), in SI as in the case. Which keys these are, the fields say by their Role.
using KeyValue = std::variant<double, std::int64_t, bool, std::string>;
using HeldKeys = std::map<std::string, KeyValue>;

/// What a state of this case holds: keys of the roles law and sample in sections that its experiment reads.
HeldKeys held_keys(const Case& c);

/// Those of the role law alone.
HeldKeys laws_of(const HeldKeys& keys);

/// The keys that the user gave. Input error that names a key which no state holds.
HeldKeys given_as_held(const Case& c);

/// Keys that the user did not give get the value of the state. Of those that were given a law wins over the
/// state; a key about the sample has to be that of the state, as its particles are there already: `known`
/// holds what is known of them besides, and one input error has a line for each that differs or that the
/// state cannot confirm.
void adopt_keys(Case& c, const HeldKeys& held, const HeldKeys& known, const std::string& file);

/// As it stands in a case.
std::string shown(const KeyValue& value);

}  // namespace supple
