/// What becomes of states in which particles have got into each other.
#pragma once
#include <algorithm>
#include <cstdint>

#include "supple/core/error.hpp"
#include "supple/experiment/packing.hpp"
#include "supple/observe/soundness.hpp"

namespace supple {

/// The packing as it is.
Soundness look_at(const Packing& packing);

/// Whether the run ends here: by `contact.unsound`, and always where a ring encloses no area, as nothing can
/// be said of it.
bool must_stop(const Packing& packing, const Soundness& soundness);

/// The numerics error for that.
Error unsound_error(const Soundness& soundness);

/// Steps of a motion between two looks: a look costs some ten steps, and particles pass each other in
/// hundreds.
inline std::int64_t look_interval(std::int64_t steps) { return std::max<std::int64_t>(100, steps / 1000); }

/// The state that was looked at last and found sound, of a packing that changes from one to the next.
class LastGood {
 public:
  explicit LastGood(Packing& packing) : packing_(packing), good_(packing.system) {}

  /// Keeps the state. Throws unsound_error where the run must stop, with the packing back at the last
  /// good state.
  Soundness look();

 private:
  Packing& packing_;
  System<2> good_;
};

}  // namespace supple
