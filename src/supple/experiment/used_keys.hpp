/// Which keys of a case have an effect: those that its experiment declares to use, if what each of them needs
/// is there.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "supple/experiment/case.hpp"
#include "supple/experiment/matter.hpp"

namespace supple {

/// Keys that an experiment uses: "section.*", "section.key", with kind_of_section(), and "-section.key" to
/// take one out again. The last entry that fits a key decides.
using UsedKeys = std::vector<std::string_view>;
/// `common`, then `more`.
UsedKeys with(UsedKeys common, const UsedKeys& more);

/// What keys need besides an experiment that uses them.
struct Need {
  /// Of a state to start from, of another key.
  enum class Of { start, value };
  std::string_view keys;  ///< names with spaces between
  Of of;
  bool (*met)(const Case&);
  std::string_view needed;
};

/// Whether the case's experiment, on its particles and with its physics, uses the key ("section.key"; "seed"
/// above any section).
bool uses(const Case& c, std::string_view key);

/// Names of the experiments that use the key, on any particles.
std::vector<std::string> users_of(std::string_view key);

/// The text of an input error for each key that has another value than its default and that the experiment
/// does not use, or not with what it starts from.
std::vector<std::string> find_useless_keys(const Case& c, Start start);

/// A warning for each key that was given and has no effect because of the value of another key; in
/// `preparation` also for keys of the runs that start from it.
std::vector<std::string> find_idle_keys(const Case& c);

}  // namespace supple
