/// The keys that a state holds, in JSON. For .cpp files only: it includes the JSON library.
#pragma once
#include "supple/experiment/held_keys.hpp"
#include "supple/io/state/json_node.hpp"

namespace supple {

/// Name of the object that holds the keys: {"contact.kind": "smooth", ...}, values in the units of a case.
inline constexpr auto held_keys_name = "case";

/// The keys in that object of `root`; empty where there is none. Throws a file error on keys that no state
/// holds, and on values that a case could not have.
HeldKeys read_held_keys(const JsonNode& root);

Json held_keys_json(const HeldKeys& keys);

}  // namespace supple
