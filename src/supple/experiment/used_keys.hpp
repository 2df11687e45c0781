/// Which keys of a case do something: what its experiment declares to use (experiments.cpp), and what a key
/// needs of others.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "supple/experiment/case.hpp"
#include "supple/experiment/matter.hpp"

namespace supple {

/// "section.*", "section.key", and "-section.key" to take one out again; the last that fits decides.
using UsedKeys = std::vector<std::string_view>;
/// `common`, then `more`.
UsedKeys with(UsedKeys common, const UsedKeys& more);

/// What a key needs besides an experiment that uses it.
struct Need {
  /// Of the experiment's physics, of a state to start from, of another key.
  enum class Of { physics, start, value };
  std::string_view keys;  ///< names with spaces between
  Of of;
  bool (*met)(const Case&);
  std::string_view needed;
};

/// Whether the case's experiment uses the key ("section.key"; "seed" above any section) for its matter and
/// physics.
bool uses(const Case& c, std::string_view key);

/// The experiments that use the key, of discs or of deformable particles.
std::vector<std::string> users_of(std::string_view key);

/// An input error, as text, for each key that was set to something else than its default and that the
/// experiment does not use, or not with what it starts from.
std::vector<std::string> find_useless_keys(const Case& c, Start start);

/// A warning for each key that was given and has no effect as another key has the value that it has; in
/// `preparation` also for keys of the runs that start from it.
std::vector<std::string> find_idle_keys(const Case& c);

}  // namespace supple
