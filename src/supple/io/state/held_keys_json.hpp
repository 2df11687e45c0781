/// The keys that a state holds, in JSON. For .cpp files only: it includes the JSON library.
#pragma once
#include "supple/experiment/held_keys.hpp"
#include "supple/io/state/json_node.hpp"

namespace supple {

/// Name of the object of those keys: {"contact.kind": "smooth", ...}, values in SI as in a case.
inline constexpr auto held_keys_name = "case";

/// Nothing where `root` has no such object. File error on keys that no state holds, and on values that a case
/// could not have.
HeldKeys read_held_keys(const JsonNode& root);

Json held_keys_json(const HeldKeys& keys);

}  // namespace supple
