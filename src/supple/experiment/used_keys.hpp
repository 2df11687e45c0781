/// Which keys of a case do something: what its experiment declares to use (experiments.cpp), and what a key
/// needs of others.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "supple/experiment/case.hpp"

namespace supple {

/// Whether the case's experiment uses the key ("section.key"; "seed" above any section) for its matter and
/// physics.
bool uses(const Case& c, std::string_view key);

/// The experiments that use the key, of discs or of deformable particles.
std::vector<std::string> users_of(std::string_view key);

/// What a run starts from: particles that it makes, or those of a state.
enum class Start { nothing, state };

/// An input error, as text, for each key that was set to something else than its default and that the
/// experiment does not use, or not with what it starts from.
std::vector<std::string> find_useless_keys(const Case& c, Start start);

/// A warning for each key that was given and has no effect as another key has the value that it has; in
/// `preparation` also for keys of the runs that start from it.
std::vector<std::string> find_idle_keys(const Case& c);

}  // namespace supple
