/// What becomes of states in which particles have got into each other.
#pragma once
#include <algorithm>
#include <cstdint>

#include "supple/core/error.hpp"
#include "supple/experiment/packing.hpp"
#include "supple/observe/soundness.hpp"

namespace supple {

/// Looks at the packing as it is (observe/soundness).
template <int Dim>
Soundness look_at(const Packing<Dim>& packing);

/// Whether the run must end: by contact.unsound, and always where a ring encloses no area, as it has no
/// packing fraction.
template <int Dim>
bool must_stop(const Packing<Dim>& packing, const Soundness& soundness);

/// The numerics error with which a run ends at such a state.
Error unsound_error(const Soundness& soundness);

/// Steps of a motion between two looks. A look takes as long as some ten steps, and particles need hundreds
/// of steps to pass each other.
inline std::int64_t look_interval(std::int64_t steps) { return std::max<std::int64_t>(100, steps / 1000); }

/// Keeps the last sound state of a packing that changes.
template <int Dim>
class LastGood {
 public:
  explicit LastGood(Packing<Dim>& packing) : packing_(packing), good_(packing.system) {}

  /// Takes the present state as good without a look.
  void trust() { good_ = packing_.system; }

  /// Looks at the packing and keeps its state. Where the run must stop, puts the packing back to the last
  /// good state and throws unsound_error.
  Soundness look();

  /// Puts the packing back to the last good state.
  void go_back();

  void keep(Keeper& k) { k("good", good_); }

 private:
  Packing<Dim>& packing_;
  System<Dim> good_;
};

}  // namespace supple
