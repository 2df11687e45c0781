/// The keys of a case that stay with its state: the laws that act, and how the sample was made, by name.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <variant>

#include "supple/experiment/case.hpp"

namespace supple {

/// Values by key ("contact.kind"), in the units of a case. The Role of its field says whether a key is among
/// them.
using KeyValue = std::variant<double, std::int64_t, bool, std::string>;
using HeldKeys = std::map<std::string, KeyValue>;

/// What a state of this case holds: the keys with the roles law and sample in the sections that its
/// experiment uses.
HeldKeys held_keys(const Case& c);

/// The keys with the role law among these.
HeldKeys laws_of(const HeldKeys& keys);

/// The keys that the user gave. Throws an input error on a key that no state holds.
HeldKeys given_as_held(const Case& c);

/// Gives keys that the user did not give the value in the state `file`: of `held`, its keys by name, or else
/// of `known`, what its particles themselves tell. A law that the user gave wins over the state. A key about
/// the sample that the user gave must have the value of the state, as the particles exist already; one input
/// error has a line for each that differs or that the state cannot confirm.
void adopt_keys(Case& c, const HeldKeys& held, const HeldKeys& known, const std::string& file);

/// The value as it stands in a case.
std::string shown(const KeyValue& value);

}  // namespace supple
